#include "pov_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "durero/io/number_text.hpp"
#include "durero/text/shown.hpp"

namespace durero::io {
namespace {

constexpr std::string_view between = " \t\v\f\r\n";
constexpr std::string_view signs = "<>{}[]();,=*/?:!&|";
/// What a number or a name ends before.
constexpr std::string_view ends = " \t\v\f\r\n<>{}[]();,=*/?:!&|\"#";
/// What may stand before the numbers of a colour.
constexpr std::array<std::string_view, 3> colored{"color", "colour", "rgb"};
constexpr std::array<std::string_view, 6> switches{"on", "off", "true", "false", "yes", "no"};

}  // namespace

bool is_one_of(std::span<const std::string_view> words, std::string_view word) {
  return std::ranges::find(words, word) != words.end();
}

void PovWords::pass() {
  end_ = at_ + word_.size();
  stand(end_);
}

bool PovWords::take(std::string_view word) {
  if (done() || word_ != word) return false;
  pass();
  return true;
}

void PovWords::expect(std::string_view word, std::string_view where) {
  if (!take(word)) fail_here(fmt::format("expected {} {}", word, where));
}

std::optional<double> PovWords::take_number() {
  const auto value = done() ? std::nullopt : read_finite(word_);
  if (value) pass();
  return value;
}

void PovWords::comma(std::string_view where) {
  if (!take(",") && (word_.starts_with('+') || word_.starts_with('-')))
    fail_here(fmt::format("expected a comma in {}: no sum is read", where));
}

double PovWords::number(std::string_view what) {
  if (done()) fail(at_, fmt::format("the text ends in {}", what), "expected a number");
  const auto value = read_finite(word_);
  if (!value) fail(at_, fmt::format("{} in {}", text::shown(word_), what), "expected a finite number");
  pass();
  return *value;
}

glm::dvec3 PovWords::triple(std::string_view what) {
  if (take("<")) {
    glm::dvec3 v{};
    for (int k = 0; k < 3; ++k) {
      if (k > 0) expect(",", fmt::format("in {}", what));
      v[k] = number(what);
    }
    expect(">", fmt::format("in {}", what));
    return v;
  }
  const bool is_signed = word_.starts_with('-') || word_.starts_with('+');
  const std::string_view axis = word_.substr(is_signed ? 1 : 0);
  if (axis != "x" && axis != "y" && axis != "z") return glm::dvec3(number(what));
  glm::dvec3 v{};
  double& length = v[axis.front() - 'x'];
  length = word_.starts_with('-') ? -1 : 1;
  pass();
  if (take("*")) length *= number(what);
  return v;
}

PovColor PovWords::color(std::string_view what) {
  PovColor color;
  while (is_one_of(colored, word_)) pass();
  const std::string_view fourth = word_;
  if (take("rgbf") || take("rgbt")) {
    expect("<", fmt::format("in {}", what));
    for (int k = 0; k < 3; ++k) {
      color.rgb[k] = number(what);
      expect(",", fmt::format("in {}", what));
    }
    (fourth == "rgbf" ? color.filter : color.transmit) = number(what);
    expect(">", fmt::format("in {}", what));
  } else {
    color.rgb = triple(what);
  }
  while (word_ == "filter" || word_ == "transmit") {
    double& share = word_ == "filter" ? color.filter : color.transmit;
    pass();
    share = number(what);
  }
  return color;
}

void PovWords::skip_block() {
  for (std::size_t open = 1; open > 0; pass()) {
    if (done()) fail_here("expected } for each {");
    if (word_ == "{") ++open;
    if (word_ == "}") --open;
  }
}

void PovWords::skip_value() {
  if (take("{")) return skip_block();
  while (is_value()) {
    if (!take("<")) {
      pass();
      continue;
    }
    while (!done() && !take(">")) pass();
  }
}

bool PovWords::is_value() const {
  return word_ == "<" || word_ == "," || word_.starts_with('"') || read_finite(word_) || is_one_of(colored, word_) ||
         is_one_of(switches, word_);
}

std::string PovWords::here() const { return done() ? "the text ends" : text::shown(word_) + " stands here"; }

void PovWords::fail_here(const std::string& expected) const { fail(at_, here(), expected); }

void PovWords::stand(std::size_t from) {
  at_ = behind_comments(from);
  word_ = source_.text().substr(at_, word_end(at_) - at_);
}

std::size_t PovWords::behind_comments(std::size_t from) const {
  const std::string_view text = source_.text();
  while (true) {
    from = std::min(text.find_first_not_of(between, from), text.size());
    const std::size_t behind = behind_comment(from);
    if (behind == from) return from;
    from = behind;
  }
}

// Comments between /* and */ may stand in each other.
std::size_t PovWords::behind_comment(std::size_t from) const {
  const std::string_view text = source_.text();
  if (text.substr(from, 2) == "//") return std::min(text.find_first_of("\r\n", from), text.size());
  if (text.substr(from, 2) != "/*") return from;
  std::size_t next = from + 2;
  for (std::size_t open = 1; open > 0;) {
    next = text.find_first_of("*/", next);
    if (next == text.npos) fail(from, "a comment that does not end", "expected */");
    const std::string_view two = text.substr(next, 2);
    if (two == "/*") ++open;
    if (two == "*/") --open;
    next += two == "/*" || two == "*/" ? 2 : 1;
  }
  return next;
}

std::size_t PovWords::word_end(std::size_t from) const {
  const std::string_view text = source_.text();
  if (from == text.size()) return from;
  if (text[from] == '"') {
    std::size_t next = text.find_first_of("\"\\", from + 1);
    while (next != text.npos && text[next] == '\\') next = text.find_first_of("\"\\", next + 2);
    if (next == text.npos) fail(from, "a text that does not end", "expected \"");
    return next + 1;
  }
  if (signs.find(text[from]) != signs.npos) return from + 1;
  const std::size_t next = text.find_first_of(ends, from + 1);
  return std::min(next, text.size());
}

}  // namespace durero::io
