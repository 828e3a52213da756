#include "cursor.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "durero/io/number_text.hpp"
#include "durero/text/shown.hpp"
#include "durero/text/utf8.hpp"

namespace durero::io {
namespace {

constexpr std::string_view blanks = " \t\v\f";

}  // namespace

WordCursor::WordCursor(const Source& source, std::string_view text, const TextLine& line)
    : source_(&source), text_(text.substr(0, line.end)), next_(line.begin) {
  if (line.end - line.begin > longest_line) refuse_long_line(source, line.begin);
  skip_blanks();
}

bool WordCursor::done() const { return next_ == text_.size() || text_[next_] == '#'; }

void WordCursor::skip_blanks() { next_ = std::min(text_.find_first_not_of(blanks, next_), text_.size()); }

bool WordCursor::take(char c) {
  if (!at(c)) return false;
  ++next_;
  return true;
}

void WordCursor::expect(char c, std::string_view where) {
  if (!take(c)) fail(next_, here(), fmt::format("expected {} {}", c, where));
}

std::string_view WordCursor::word(std::string_view stops) {
  const std::size_t first = next_;
  const auto ends_word = [&](char c) { return stops.find(c) != stops.npos || blanks.find(c) != blanks.npos; };
  while (next_ < text_.size() && !ends_word(text_[next_])) ++next_;
  return text_.substr(first, next_ - first);
}

double WordCursor::number(std::string_view stops, std::string_view what) {
  const std::size_t at = next_;
  const std::string_view digits = word(stops);
  const auto value = read_finite(digits);
  if (!value) fail(at, fmt::format("{} in {}", text::shown(digits), what), "expected a finite number");
  return *value;
}

std::string WordCursor::here() const {
  if (next_ == text_.size()) return "the line ends";
  return text::shown(text::first(text_.substr(next_))) + " stands here";
}

}  // namespace durero::io
