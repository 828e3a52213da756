#pragma once
/// The words of an NFF text, of all its lines: separated by blanks and line ends, comments left out.

#include <glm/vec3.hpp>
#include <optional>

#include "io/cursor.hpp"

namespace durero::io {

class NffWords {
 public:
  explicit NffWords(const Source& source) : source_(source), lines_(source.text()) { skip(); }

  bool done() const { return !line_; }
  /// Where the next word stands; the end of the text where there is none.
  std::size_t offset() const { return line_ ? line_->offset() : source_.text().size(); }
  /// True when the next word stands on the same line as the last one.
  bool same_line() const { return !done() && !crossed_; }
  /// Precondition: !done().
  std::string_view word();
  /// A finite number. `what` names it in messages.
  double number(std::string_view what);
  glm::dvec3 triple(std::string_view what);
  [[noreturn]] void fail(std::size_t offset, const std::string& wrong, const std::string& expected,
                         const contract::clause* broken = nullptr) const {
    source_.fail(offset, wrong, expected, broken);
  }

 private:
  void skip();

  const Source& source_;
  Lines lines_;
  std::optional<WordCursor> line_;  // on the next word; nothing at the end of the text
  bool crossed_ = false;            // a line end was passed on the way to the next word
};

}  // namespace durero::io
