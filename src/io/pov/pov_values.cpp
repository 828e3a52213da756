// What the names of a POV-Ray program are given, and what they are asked for.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "durero/io/number_text.hpp"
#include "durero/text/shown.hpp"
#include "pov_program.hpp"
#include "pov_words.hpp"

namespace durero::io {
namespace {

constexpr std::size_t most_elements = 1'000'000;  // of an array

/// A value that shares nothing with another.
PovValue copied(const PovValue& value) {
  const auto* const array = std::get_if<PovArray>(&value.of);
  if (array == nullptr) return value;
  PovArray copy;
  for (const auto& element : *array) copy.push_back(std::make_shared<PovValue>(copied(*element)));
  return {std::move(copy)};
}

PovArray array_of(std::span<const std::size_t> sizes) {
  PovArray array(sizes.front());
  for (auto& element : array) {
    element = std::make_shared<PovValue>();
    if (sizes.size() > 1) element->of = array_of(sizes.subspan(1));
  }
  return array;
}

/// The questions that a program answers in numbers, and the functions that make texts.
constexpr std::string_view questions[] = {"defined",     "rand",         "seed",       "strlen",         "strcmp",
                                          "asc",         "val",          "dimensions", "dimension_size", "version",
                                          "image_width", "image_height", "file_exists"},
                           text_functions[] = {"concat", "str", "vstr", "chr", "substr", "strupr", "strlwr"};

bool is_any(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::ranges::find(words, word) != words.end();
}

/// A number with so many digits behind the point, at least so many characters long: with blanks before it, with zeros
/// where the length is below 0.
std::string formatted(double value, double length, double digits) {
  const int places = digits < 0 ? 6 : static_cast<int>(std::min(digits, 60.0));
  const int wide = static_cast<int>(std::min(std::abs(length), 1000.0));
  return length < 0 ? fmt::format("{:0{}.{}f}", value, wide, places) : fmt::format("{:{}.{}f}", value, wide, places);
}

}  // namespace

// Values.

PovValue PovProgram::value() {
  if (const PovToken* const array = raw();
      array != nullptr && array->is_name() && raw(1) != nullptr && raw(1)->text == "[")
    if (const auto known = find(array->text); known && std::holds_alternative<PovArray>(known->of)) {
      const PovToken at = take_raw("expected an array");
      const auto element = element_of(known);
      if (std::holds_alternative<PovArray>(element->of)) return copied(*element);
      put(*element, at);
    }
  const PovToken* const token = here();
  if (token == nullptr) fail_here("expected a value");
  if (auto said = take_text()) return {*std::move(said)};
  if (token->text == "array") return {array()};
  const PovToken* const behind = raw(1);
  if (token->text == "spline" && behind != nullptr && behind->text == "{") return {spline()};
  if (token->text == "function" && behind != nullptr && behind->text == "{" && raw(2) != nullptr &&
      raw(2)->text == "spline") {
    pass();
    pass();
    PovValue within{spline()};
    expect("}", "behind a function");
    return within;
  }
  if (token->text == "function" && behind != nullptr && is_any(behind->text, {"{", "("})) return {function()};
  const auto known = token->is_name() ? find(token->text) : nullptr;
  if (known && std::holds_alternative<PovArray>(known->of)) {
    pass();
    return copied(*known);
  }
  if (known && std::holds_alternative<std::shared_ptr<const PovSpline>>(known->of) &&
      (behind == nullptr || behind->text != "(")) {
    pass();
    return *known;
  }
  const bool is_number =
      known && (std::holds_alternative<PovNumbers>(known->of) || std::holds_alternative<PovFunction>(known->of) ||
                std::holds_alternative<std::shared_ptr<const PovSpline>>(known->of));
  if (is_number || begins_pov_expression(*token) || is_one_of(questions, token->text)) return {pov_sum(*this)};
  return {std::make_shared<const PovTokens>(captured())};
}

/// A block behind its word, with the texture or textures behind a first one; or a word alone.
PovTokens PovProgram::captured() {
  return kept_by([&] {
    const std::string first(here()->text);
    while (true) {
      emit();
      if (!at("{")) break;
      std::size_t open = 0, counted = sink_->size();
      do {
        if (here() == nullptr) fail_here("expected } for each {");
        emit();
        for (; counted < sink_->size(); ++counted) {
          if ((*sink_)[counted].text == "{") ++open;
          if ((*sink_)[counted].text == "}") --open;
        }
      } while (open > 0);
      if (first != "texture" || !at("texture")) break;
    }
  });
}

PovArray PovProgram::array() {
  pass();
  std::vector<std::size_t> sizes;
  std::size_t all = 1;
  while (take("[")) {
    const double size = std::floor(pov_sum(*this).of[0] + 0.5);
    if (!(size >= 1 && size <= double(most_elements)) || (all *= static_cast<std::size_t>(size)) > most_elements)
      fail_here("expected an array of 1 to 1,000,000 elements");
    sizes.push_back(static_cast<std::size_t>(size));
    expect("]", "behind the size of an array");
  }
  PovArray made = sizes.empty() ? PovArray() : array_of(sizes);
  if (!take("{")) return made;
  PovArray given = elements();
  if (sizes.empty()) return given;
  if (given.size() > made.size()) fail_here("expected no more elements than the array has");
  std::ranges::copy(given, made.begin());
  return made;
}

/// From behind a { to behind its }.
PovArray PovProgram::elements() {
  PovArray all;
  while (!take("}")) {
    if (here() == nullptr) fail_here("expected } behind the elements of an array");
    if (all.size() == most_elements) fail_here("expected an array of 1,000,000 elements at most");
    all.push_back(std::make_shared<PovValue>(take("{") ? PovValue{elements()} : value()));
    take(",");
  }
  return all;
}

/// Its names of numbers are replaced by what they are now, but for its parameters.
PovFunction PovProgram::function() {
  pass();
  PovFunction made{{"x", "y", "z"}, nullptr};
  if (take_raw_if("(")) made.parameters = parameters();
  expect_raw("{", "behind function");
  made.body = std::make_shared<const PovTokens>(kept_by([&] {
    for (std::size_t open = 1; open > 0;) {
      const PovToken token = take_raw("expected } behind a function");
      if (token.text == "{") ++open;
      if (token.text == "}" && --open == 0) break;
      const bool is_parameter = std::ranges::find(made.parameters, token.text) != made.parameters.end();
      const auto known = token.is_name() && !is_parameter ? find(token.text) : nullptr;
      const auto* const numbers = known ? std::get_if<PovNumbers>(&known->of) : nullptr;
      if (numbers != nullptr)
        emit(*numbers, token);
      else
        keep(token);
    }
  }));
  return made;
}

/// Numbers and vectors behind another spline, whose copy it begins as, and a kind.
std::shared_ptr<const PovSpline> PovProgram::spline() {
  pass();
  expect("{", "behind spline");
  PovSpline made;
  while (!take("}")) {
    const PovToken* const token = here();
    if (token == nullptr) fail_here("expected } behind a spline");
    const auto known = token->is_name() ? find(token->text) : nullptr;
    const auto* const other = known ? std::get_if<std::shared_ptr<const PovSpline>>(&known->of) : nullptr;
    if (const auto kind = pov_spline_kind(token->text)) {
      made.kind = *kind;
      pass();
    } else if (other != nullptr) {
      made = **other;
      pass();
    } else {
      const double at = pov_sum(*this).of[0];
      expect(",", "between a number of a spline and its vector");
      made.put(at, pov_sum(*this));
      if (made.size() > most_elements) fail_here("expected a spline of 1,000,000 vectors at most");
    }
    take(",");
  }
  if (made.size() == 0) fail_here("expected a vector at least in a spline");
  return std::make_shared<const PovSpline>(std::move(made));
}

/// Of a spline whose name stands before.
PovNumbers PovProgram::value_of(const PovSpline& spline, const PovToken& at) {
  expect("(", fmt::format("behind {}", at.text));
  const double where = pov_sum(*this).of[0];
  PovSplineKind kind = spline.kind;
  if (take(",")) {
    const auto other = here() == nullptr ? std::nullopt : pov_spline_kind(here()->text);
    if (!other) fail_here("expected linear_spline, quadratic_spline, cubic_spline or natural_spline");
    kind = *other;
    pass();
  }
  expect(")", fmt::format("behind {}", at.text));
  steps_ += spline.size();
  count_step(at);
  return spline.value(where, kind);
}

std::shared_ptr<PovValue> PovProgram::element_of(const std::shared_ptr<PovValue>& array) {
  std::shared_ptr<PovValue> element = array;
  while (take("[")) {
    auto* const all = std::get_if<PovArray>(&element->of);
    if (all == nullptr) fail_here("expected no [ behind what is no array");
    const double number = std::floor(pov_sum(*this).of[0] + same_within);
    if (!(number >= 0 && number < double(all->size())))
      fail_here(fmt::format("expected the number of an element, 0 to {}", double(all->size()) - 1));
    expect("]", "behind the number of an element");
    element = (*all)[static_cast<std::size_t>(number)];
  }
  return element;
}

// Texts.

std::string PovProgram::text(std::string_view where) {
  auto said = take_text();
  if (!said) fail_here(fmt::format("expected a text {}", where));
  return *std::move(said);
}

std::optional<std::string> PovProgram::take_text() {
  const PovToken* const token = here();
  if (token == nullptr) return std::nullopt;
  if (token->text.starts_with('"')) {
    std::string said = unquoted_pov_text(token->text);
    pass();
    return said;
  }
  if (!token->is_name()) return std::nullopt;
  if (const auto known = find(token->text)) {
    if (const auto* const said = std::get_if<std::string>(&known->of)) {
      std::string copy = *said;
      pass();
      return copy;
    }
    return std::nullopt;
  }
  const std::string_view word = token->text;
  if (raw(1) == nullptr || raw(1)->text != "(" || !is_one_of(text_functions, word)) return std::nullopt;
  pass();
  expect("(", fmt::format("behind {}", word));
  std::string said;
  if (word == "concat") {
    do said += text("in concat");
    while (take(","));
  } else if (word == "str") {
    const double number = pov_sum(*this).of[0];
    expect(",", "in str");
    const double length = pov_sum(*this).of[0];
    expect(",", "in str");
    said = formatted(number, length, pov_sum(*this).of[0]);
  } else if (word == "vstr") {
    const double count = pov_sum(*this).of[0];
    expect(",", "in vstr");
    const PovNumbers numbers = pov_sum(*this).widened(5);
    expect(",", "in vstr");
    const std::string between = text("in vstr");
    expect(",", "in vstr");
    const double length = pov_sum(*this).of[0];
    expect(",", "in vstr");
    const double digits = pov_sum(*this).of[0];
    for (std::size_t i = 0; i < 5 && double(i) < count; ++i)
      said += (i == 0 ? "" : between) + formatted(numbers.of[i], length, digits);
  } else if (word == "chr") {
    const double code = pov_sum(*this).of[0];
    if (!(code >= 1 && code <= 126)) fail_here("expected the number of a character, 1 to 126");
    said = std::string(1, static_cast<char>(code));
  } else {
    said = text(fmt::format("in {}", word));
    if (word == "substr") {
      expect(",", "in substr");
      const double begin = pov_sum(*this).of[0];
      expect(",", "in substr");
      const double length = pov_sum(*this).of[0];
      if (!(begin >= 1 && length >= 0 && begin - 1 + length <= double(said.size())))
        fail_here("expected a part that the text has");
      said = said.substr(static_cast<std::size_t>(begin) - 1, static_cast<std::size_t>(length));
    }
    const auto change = [&](char first, char last, int by) {
      for (char& c : said)
        if (c >= first && c <= last) c = static_cast<char>(c + by);
    };
    if (word == "strupr") change('a', 'z', 'A' - 'a');
    if (word == "strlwr") change('A', 'Z', 'a' - 'A');
  }
  expect(")", fmt::format("behind {}", word));
  if (said.size() > 1'000'000) fail_here("expected a text of 1,000,000 characters at most");
  return said;
}

// Numbers.

std::vector<PovNumbers> PovProgram::numbers_in_parentheses(std::string_view where) {
  std::vector<PovNumbers> all;
  expect("(", where);
  do all.push_back(pov_sum(*this));
  while (take(","));
  expect(")", where);
  return all;
}

std::optional<PovNumbers> PovProgram::named() {
  const PovToken token = *here();
  const PovToken* const behind = raw(1);
  const auto known = find(token.text);
  if (!known) {
    if (behind != nullptr && behind->text == "(") return asked(token.text);
    if (!is_any(token.text, {"version", "image_width", "image_height"})) return std::nullopt;
    pass();
    return token.text == "version" ? version_ : double(token.text == "image_width" ? size_.width : size_.height);
  }
  if (const auto* const numbers = std::get_if<PovNumbers>(&known->of)) {
    const PovNumbers copy = *numbers;
    pass();
    return copy;
  }
  if (const auto* const function = std::get_if<PovFunction>(&known->of)) {
    if (behind == nullptr || behind->text != "(") return std::nullopt;
    const PovFunction copy = *function;  // it may be declared again
    pass();
    return call(copy, token);
  }
  if (const auto* const spline = std::get_if<std::shared_ptr<const PovSpline>>(&known->of)) {
    if (behind == nullptr || behind->text != "(") return std::nullopt;
    const auto copy = *spline;
    pass();
    return value_of(*copy, token);
  }
  return std::nullopt;
}

std::optional<PovNumbers> PovProgram::asked(std::string_view word) {
  const PovToken at = *here();
  if (word == "defined") {
    pass();
    return is_defined() ? 1.0 : 0.0;
  }
  if (word == "rand" || word == "seed") {
    pass();
    const double number = numbers_in_parentheses("of rand or seed").front().of[0];
    if (word == "seed") {
      streams_.push_back(static_cast<std::uint32_t>(static_cast<std::int64_t>(std::clamp(number, -1e15, 1e15))));
      return static_cast<double>(streams_.size() - 1);
    }
    if (!(number >= 0 && number < double(streams_.size()))) at.fail("rand of no stream", "expected what seed gave");
    std::uint32_t& state = streams_[static_cast<std::size_t>(number)];
    state = state * 1812433253U + 12345U;
    return double(state) / 4294967295.0;
  }
  if (is_any(word, {"strlen", "asc", "val", "file_exists"})) {
    pass();
    expect("(", fmt::format("behind {}", word));
    const std::string said = text(fmt::format("in {}", word));
    expect(")", fmt::format("behind {}", word));
    if (word == "strlen") return static_cast<double>(said.size());
    if (word == "file_exists") return found_file(said) ? 1.0 : 0.0;
    if (word == "asc") return said.empty() ? 0.0 : static_cast<double>(static_cast<unsigned char>(said.front()));
    const auto number = read_finite(said);
    if (!number) at.fail(fmt::format("val of {}", text::shown(said)), "expected a number in a text");
    return *number;
  }
  if (word == "strcmp") {
    pass();
    expect("(", "behind strcmp");
    const std::string first = text("in strcmp");
    expect(",", "in strcmp");
    const int order = first.compare(text("in strcmp"));
    expect(")", "behind strcmp");
    return order < 0 ? -1.0 : order > 0 ? 1.0 : 0.0;
  }
  if (word == "dimensions" || word == "dimension_size") {
    pass();
    expect("(", fmt::format("behind {}", word));
    const auto array = find(name("expected the name of an array"));
    std::size_t wanted = 0;
    if (word == "dimension_size" && take(",")) wanted = static_cast<std::size_t>(std::max(1.0, pov_sum(*this).of[0]));
    expect(")", fmt::format("behind {}", word));
    std::size_t dimension = 0;
    const PovValue* level = array.get();
    while (level != nullptr) {
      const auto* const all = std::get_if<PovArray>(&level->of);
      if (all == nullptr) break;
      if (++dimension == wanted) return static_cast<double>(all->size());
      level = all->empty() ? nullptr : all->front().get();
    }
    return word == "dimensions" ? static_cast<double>(dimension) : 0.0;
  }
  if (is_any(word, {"min_extent", "max_extent", "trace", "inside", "internal", "now"}))
    at.fail(fmt::format("{} is not carried out", word), "expected a value that asks no object");
  return std::nullopt;
}

}  // namespace durero::io
