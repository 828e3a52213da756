#include "rad_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "durero/io/number_text.hpp"
#include "durero/text/shown.hpp"

namespace durero::io {
namespace {

constexpr std::string_view rad_blanks = " \t\r\n\v\f";

}  // namespace

void RadWords::skip_blanks() {
  next_ = std::min(source_.text().find_first_not_of(rad_blanks, next_), source_.text().size());
}

std::string_view RadWords::rest_of_line() {
  const std::size_t end = std::min(source_.text().find_first_of("\r\n", next_), source_.text().size());
  const std::string_view line = source_.text().substr(next_, end - next_);
  next_ = end;
  return line;
}

void RadWords::skip_comments() {
  skip_blanks();
  while (!done() && source_.text()[next_] == '#') {
    rest_of_line();
    skip_blanks();
  }
}

std::optional<RadLine> RadWords::take_command() {
  if (done() || source_.text()[next_] != '!') return std::nullopt;
  RadLine line{next_++, std::string(rest_of_line())};
  while (line.text.ends_with('\\') && !done()) {
    line.text.back() = ' ';
    next_ += source_.text().substr(next_).starts_with("\r\n") ? 2 : 1;
    line.text += rest_of_line();
  }
  skip_comments();
  return line;
}

std::string_view RadWords::word(std::string_view what) {
  skip_blanks();
  if (done()) fail(next_, fmt::format("the text ends before {}", what), "expected it");
  const std::string_view text = source_.text();
  const char first = text[next_];
  if (first == '"' || first == '\'') {
    const std::size_t end = text.find(first, next_ + 1);
    if (end == text.npos)
      fail(next_, fmt::format("{} does not end", what), fmt::format("expected {} behind it", first));
    const std::string_view quoted = text.substr(next_ + 1, end - next_ - 1);
    next_ = end + 1;
    return quoted;
  }
  const std::size_t end = std::min(text.find_first_of(rad_blanks, next_), text.size());
  const std::string_view plain = text.substr(next_, end - next_);
  next_ = end;
  return plain;
}

double RadWords::number(std::string_view what) {
  skip_blanks();
  const std::size_t at = next_;
  const std::string_view text = word(what);
  const auto value = read_decimal(text);
  if (!value) fail(at, fmt::format("{} in {}", text::shown(text), what), "expected a finite decimal number");
  return *value;
}

std::size_t RadWords::count(std::string_view what) {
  skip_blanks();
  const std::size_t at = next_;
  const std::string_view text = word(what);
  std::size_t value = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size())
    fail(at, fmt::format("{} in the place of {}", text::shown(text), what), "expected a whole number");
  return value;
}

}  // namespace durero::io
