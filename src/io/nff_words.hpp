#pragma once
/// The words of an NFF text: separated by spaces and line ends, `#` to the end of the line left out.

#include <glm/vec3.hpp>

#include "durero/io/source.hpp"

namespace durero::io {

class NffWords {
 public:
  explicit NffWords(const Source& source) : source_(source) { skip(); }

  bool done() const { return next_ == source_.text().size(); }
  /// Where the next word stands.
  std::size_t offset() const { return next_; }
  /// True when the next word stands on the same line as the last one.
  bool same_line() const { return !done() && !crossed_; }
  std::string_view word();
  /// A finite number. `what` names it in messages.
  double number(std::string_view what);
  glm::dvec3 triple(std::string_view what);
  [[noreturn]] void fail(std::size_t offset, const std::string& wrong, const std::string& expected) const {
    source_.fail(offset, wrong, expected);
  }

 private:
  void skip();

  const Source& source_;
  std::size_t next_ = 0;
  bool crossed_ = false;  // a line end was passed on the way to the next word
};

}  // namespace durero::io
