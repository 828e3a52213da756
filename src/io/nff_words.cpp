#include "nff_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "durero/io/number_text.hpp"
#include "durero/text/shown.hpp"

namespace durero::io {

std::string_view NffWords::word() {
  const std::string_view text = source_.text();
  const std::size_t end = std::min(text.find_first_of(" \t\r\n\v\f#", next_), text.size());
  const std::string_view word = text.substr(next_, end - next_);
  next_ = end;
  skip();
  return word;
}

double NffWords::number(std::string_view what) {
  if (done()) fail(next_, fmt::format("the text ends in {}", what), "expected a number");
  const std::size_t at = next_;
  const std::string_view text = word();
  const auto value = read_number(text);
  if (!value || !std::isfinite(*value))
    fail(at, fmt::format("{} in {}", text::shown(text), what), "expected a finite number");
  return *value;
}

glm::dvec3 NffWords::triple(std::string_view what) {
  const double x = number(what), y = number(what), z = number(what);
  return {x, y, z};
}

void NffWords::skip() {
  const std::string_view text = source_.text();
  crossed_ = false;
  while (next_ < text.size()) {
    const char c = text[next_];
    if (c == '#') {
      next_ = std::min(text.find('\n', next_), text.size());
    } else if (c == '\n') {
      crossed_ = true;
      ++next_;
    } else if (c == ' ' || (c >= '\t' && c <= '\r')) {
      ++next_;
    } else {
      return;
    }
  }
}

}  // namespace durero::io
