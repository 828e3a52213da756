#include "pbrt_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <glm/vec3.hpp>
#include <utility>

#include "durero/io/number_text.hpp"
#include "durero/text/shown.hpp"

namespace durero::io {
namespace {

constexpr std::size_t deepest_file = 64, most_pbrt_files = 10'000, most_bytes = std::size_t{1} << 33U;

constexpr bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f'; }
constexpr bool ends_word(char c) { return is_space(c) || c == '"' || c == '[' || c == ']' || c == '#'; }

/// The first byte from there on that is neither blank nor in a comment.
std::size_t behind_blanks(std::string_view text, std::size_t at) {
  while (at < text.size() && (is_space(text[at]) || text[at] == '#'))
    at = text[at] == '#' ? std::min(text.find_first_of("\r\n", at), text.size()) : at + 1;
  return at;
}

}  // namespace

void PbrtParameters::add(PbrtParameter parameter) {
  const auto same = std::ranges::find(all_, parameter.name, &PbrtParameter::name);
  if (same == all_.end()) return all_.push_back(std::move(parameter));
  *same = std::move(parameter);
  replaced_.push_back(same->name);
}

const PbrtParameter* PbrtParameters::find(std::string_view name) const {
  const auto found = std::ranges::find(all_, name, &PbrtParameter::name);
  if (found == all_.end()) return nullptr;
  if (std::ranges::find(known_, name) == known_.end()) known_.emplace_back(name);
  return &*found;
}

double PbrtParameters::number(std::string_view name, double usual) const {
  const PbrtParameter* const told = find(name);
  if (told == nullptr) return usual;
  if (told->numbers.size() != 1)
    told->place.fail(fmt::format("{} of {} numbers", told->name, told->numbers.size()), "expected one");
  return told->numbers.front();
}

std::string PbrtParameters::word(std::string_view name, std::string_view usual) const {
  const PbrtParameter* const told = find(name);
  if (told == nullptr) return std::string(usual);
  if (told->words.size() != 1)
    told->place.fail(fmt::format("{} of {} texts", told->name, told->words.size()), "expected one, in quotes");
  return told->words.front();
}

glm::dvec3 PbrtParameters::triple(std::string_view name, const glm::dvec3& usual) const {
  const PbrtParameter* const told = find(name);
  if (told == nullptr) return usual;
  if (told->numbers.size() != 3)
    told->place.fail(fmt::format("{} of {} numbers", told->name, told->numbers.size()), "expected three");
  return {told->numbers[0], told->numbers[1], told->numbers[2]};
}

std::vector<std::string> PbrtParameters::unknown() const {
  std::vector<std::string> names = replaced_;
  for (const PbrtParameter& parameter : all_)
    if (std::ranges::find(known_, parameter.name) == known_.end()) names.push_back(parameter.name);
  return names;
}

PbrtWords::PbrtWords(const Source& source)
    : files_{{std::make_shared<const Source>(source)}}, folder_(source), last_file_(files_.front().source) {}

std::optional<PbrtWord> PbrtWords::peek() {
  File& file = files_.back();
  const std::string_view text = file.source->text();
  const std::size_t at = file.next = behind_blanks(text, file.next);
  if (at == text.size()) return std::nullopt;
  if (text[at] == '"') {
    const std::size_t end = text.find_first_of("\"\n", at + 1);
    if (end == std::string_view::npos || text[end] != '"')
      file.source->fail(at, "a text in quotes without an end", "expected \" on the same line");
    return PbrtWord{text.substr(at + 1, end - at - 1), at, true};
  }
  std::size_t end = at + 1;
  if (text[at] != '[' && text[at] != ']')
    while (end < text.size() && !ends_word(text[end])) ++end;
  return PbrtWord{text.substr(at, end - at), at, false};
}

bool PbrtWords::done() {
  while (files_.size() > 1 && !peek()) {
    ended_ += files_.back().is_alone;
    files_.pop_back();
  }
  return !peek();
}

PbrtWord PbrtWords::next() {
  const auto word = peek();
  last_file_ = files_.back().source;
  last_at_ = word ? word->at : last_file_->text().size();
  if (!word) fail("the file ends here", "expected what the statement needs");
  files_.back().next = word->at + word->text.size() + (word->is_quoted ? 2 : 0);
  return *word;
}

std::optional<PbrtWord> PbrtWords::take(std::string_view text) {
  const auto word = peek();
  return word && !word->is_quoted && word->text == text ? std::optional(next()) : std::nullopt;
}

std::string PbrtWords::quoted(std::string_view what) {
  const PbrtWord word = next();
  if (!word.is_quoted)
    fail(fmt::format("{} stands here", text::shown(word.text)), fmt::format("expected {} in quotes", what));
  return std::string(word.text);
}

void PbrtWords::take_quoted() {
  const auto word = peek();
  if (word && word->is_quoted) next();
}

std::vector<double> PbrtWords::numbers(std::size_t count, std::string_view what) {
  const bool is_bracketed = take("[").has_value();
  std::vector<double> numbers;
  while (numbers.size() < count) {
    const PbrtWord word = next();
    const auto number = word.is_quoted ? std::nullopt : read_finite(word.text);
    if (!number)
      fail(fmt::format("{} in {}", text::shown(word.text), what), fmt::format("expected {} finite numbers", count));
    numbers.push_back(*number);
  }
  if (is_bracketed && !take("]")) {
    const PbrtWord word = next();
    fail(fmt::format("{} in {}", text::shown(word.text), what), fmt::format("expected ] behind {} numbers", count));
  }
  return numbers;
}

PbrtParameters PbrtWords::parameters() {
  PbrtParameters all;
  for (auto word = peek(); word && word->is_quoted; word = peek()) {
    const std::string declared(next().text);
    const std::size_t end = declared.find_first_of(" \t"), begin = declared.find_first_not_of(" \t", end);
    PbrtParameter parameter{declared.substr(0, end), begin == std::string::npos ? "" : declared.substr(begin), place()};
    while (!parameter.name.empty() && is_space(parameter.name.back())) parameter.name.pop_back();
    if (parameter.name.empty())
      fail(fmt::format("{} stands here", text::shown(declared)), "expected a type and a name");
    read_values(parameter);
    all.add(std::move(parameter));
  }
  return all;
}

/// Values of one kind, in brackets or one alone.
void PbrtWords::read_values(PbrtParameter& parameter) {
  const bool is_bracketed = take("[").has_value();
  for (bool is_first = true; is_bracketed ? !take("]") : is_first; is_first = false) {
    const PbrtWord word = next();
    const bool is_truth = word.text == "true" || word.text == "false";
    if (word.is_quoted || is_truth) {
      parameter.words.emplace_back(word.text);
    } else {
      const auto number = read_finite(word.text);
      if (!number)
        fail(fmt::format("{} in {}", text::shown(word.text), parameter.name),
             "expected a finite number, or a text in quotes");
      parameter.numbers.push_back(*number);
    }
    if (!parameter.words.empty() && !parameter.numbers.empty())
      fail(fmt::format("texts and numbers in {}", parameter.name), "expected values of one kind");
  }
}

void PbrtWords::include(const std::string& name, bool is_alone) {
  const PbrtPlace at = place();
  if (files_.size() == deepest_file || ++includes_ > most_pbrt_files)
    fail("too many files that include files",
         fmt::format("expected {} within each other and {} in all, at most", deepest_file, most_pbrt_files));
  auto source = std::make_shared<const Source>(read_source(path(at, name)));
  bytes_ += source->text().size();
  if (bytes_ > most_bytes) fail(fmt::format("more than {} bytes of files", most_bytes), "expected fewer");
  files_.push_back({std::move(source), 0, is_alone});
}

std::string PbrtWords::path(const PbrtPlace& place, std::string_view name) const {
  auto path = folder_.find(*files_.front().source, name);  // as pbrt does, whichever file names it
  if (!path) place.fail(fmt::format("no file {}", text::shown(name)), folder_.expected());
  return std::move(*path);
}

}  // namespace durero::io
