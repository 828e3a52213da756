#include "nff_words.hpp"

#include <fmt/format.h>

namespace durero::io {

std::string_view NffWords::word() {
  const std::string_view word = line_->word("#");
  skip();
  return word;
}

double NffWords::number(std::string_view what) {
  if (done()) fail(offset(), fmt::format("the text ends in {}", what), "expected a number");
  const double number = line_->number("#", what);
  skip();
  return number;
}

glm::dvec3 NffWords::triple(std::string_view what) {
  const double x = number(what), y = number(what), z = number(what);
  return {x, y, z};
}

void NffWords::skip() {
  crossed_ = false;
  if (line_) line_->skip_blanks();
  while (!line_ || line_->done()) {
    const auto next = lines_.next();
    if (!next) {
      line_.reset();
      return;
    }
    crossed_ = line_.has_value();
    line_.emplace(source_, *next);
  }
}

}  // namespace durero::io
