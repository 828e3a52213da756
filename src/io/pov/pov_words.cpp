#include "pov_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "durero/io/number_text.hpp"
#include "durero/text/shown.hpp"

namespace durero::io {

bool is_one_of(std::span<const std::string_view> words, std::string_view word) {
  return std::ranges::find(words, word) != words.end();
}

std::string PovWords::passed(std::size_t from) const {
  std::string joined;
  for (std::size_t i = from; i < next_; ++i) joined.append(i == from ? "" : " ").append(words_[i].text);
  return joined;
}

std::optional<double> PovWords::take_number() {
  const std::size_t from = next_;
  const bool is_negative = take("-");
  const auto value = done() || !words_[next_].is_number() ? std::nullopt : read_finite(word());
  if (!value) {
    next_ = from;
    return std::nullopt;
  }
  pass();
  return is_negative ? -*value : *value;
}

PovNumbers PovWords::value(std::string_view what) {
  if (done()) fail(next_, fmt::format("the text ends in {}", what), "expected a number");
  if (!begins_pov_expression(words_[next_]))
    fail(next_, fmt::format("{} in {}", text::shown(word()), what), "expected a finite number");
  return pov_sum(*this);
}

double PovWords::number(std::string_view what) {
  const std::size_t at = next_;
  const PovNumbers given = value(what);
  if (given.count != 1) fail(at, fmt::format("a vector in {}", what), "expected a number");
  return given.of[0];
}

glm::dvec3 PovWords::triple(std::string_view what) { return value(what).triple(); }

PovColor PovWords::color(std::string_view what) {
  const PovNumbers given = value(what);
  PovColor color{given.triple()};
  if (given.count == 5) color.filter = given.of[3], color.transmit = given.of[4];
  while (word() == "filter" || word() == "transmit") {
    double& share = word() == "filter" ? color.filter : color.transmit;
    pass();
    share = number(what);
  }
  return color;
}

void PovWords::skip_block() {
  for (std::size_t open = 1; open > 0; pass()) {
    if (done()) fail_here("expected } for each {");
    if (word() == "{") ++open;
    if (word() == "}") --open;
  }
}

void PovWords::skip_value() {
  if (take("{")) return skip_block();
  while (!done()) {
    if (word() == "," || word().starts_with('"'))
      pass();
    else if (word() == "<")
      skip_vector();
    else if (begins_pov_expression(words_[next_]))
      pov_sum(*this);
    else
      return;
  }
}

void PovWords::fail(std::size_t offset, const std::string& wrong, const std::string& expected,
                    const contract::clause* broken) const {
  if (offset < words_.size()) words_[offset].source->fail(words_[offset].offset, wrong, expected, broken);
  program_.source().fail(program_.source().text().size(), wrong, expected, broken);
}

void PovWords::skip_vector() {
  do {
    if (done()) fail_here("expected > behind <");
    pass();
  } while (!take(">"));
}

void PovWords::refuse(const std::string& expected) const {
  fail(next_, done() ? "the text ends" : text::shown(word()) + " stands here", expected);
}

}  // namespace durero::io
