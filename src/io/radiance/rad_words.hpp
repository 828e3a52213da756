#pragma once
/// The words of a text of Radiance: primitives, comments from a # that stands in the place of one, and lines of
/// commands from a ! there.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "durero/io/source.hpp"

namespace durero::io {

/// A command's line, without its !.
struct RadLine {
  std::size_t at;
  std::string text;
};

class RadWords {
 public:
  explicit RadWords(const Source& source) : source_(source) { skip_comments(); }

  /// Whether no primitive and no command follows.
  bool done() const { return next_ >= source_.text().size(); }
  std::size_t offset() const { return next_; }
  /// Passes the command that stands here, if one does. A line that ends with a backslash goes on in the next one.
  std::optional<RadLine> take_command();
  /// @{ Pass a word; `what` names it in messages. A word may stand in quotes, with blanks.
  std::string_view word(std::string_view what);
  double number(std::string_view what);
  std::size_t count(std::string_view what);
  /// @}
  /// Passes comments, behind a primitive.
  void skip_comments();
  [[noreturn]] void fail(std::size_t at, const std::string& wrong, const std::string& expected) const {
    source_.fail(at, wrong, expected);
  }

 private:
  void skip_blanks();
  std::string_view rest_of_line();

  const Source& source_;
  std::size_t next_ = 0;
};

}  // namespace durero::io
