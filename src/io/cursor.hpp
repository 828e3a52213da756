#pragma once
/// Walks the words of one line: what every text format but JSON is read by. Blanks are space, tab, vertical tab and
/// form feed; a `#` that starts a word starts a comment, which goes to the end of the line.

#include "durero/io/lines.hpp"
#include "durero/io/source.hpp"

namespace durero::io {

class WordCursor {
 public:
  /// Stands on the first word of the line. Throws InputError where it is longer than longest_line.
  WordCursor(const Source& source, const TextLine& line) : WordCursor(source, source.text(), line) {}
  /// The line is of that text, which is as long as the source's: places are those of the source.
  WordCursor(const Source& source, std::string_view text, const TextLine& line);

  /// True at the end of the line and at a comment.
  bool done() const;
  /// Where the next byte stands in the source.
  std::size_t offset() const { return next_; }
  void skip_blanks();

  /// True where that byte is the next one.
  bool at(char c) const { return next_ < text_.size() && text_[next_] == c; }
  /// Passes that byte, if it is the next one.
  bool take(char c);
  /// Passes that byte, or fails: `what stands here; expected c where`.
  void expect(char c, std::string_view where);
  /// The bytes up to a blank or to one of the given ones; perhaps none. Does not pass what follows.
  std::string_view word(std::string_view stops);
  /// A word that is a finite number, or fails: `"word" in what; expected a finite number`.
  double number(std::string_view stops, std::string_view what);

  /// What stands here, as a message says it.
  std::string here() const;
  [[noreturn]] void fail(std::size_t offset, const std::string& wrong, const std::string& expected,
                         const contract::clause* broken = nullptr) const {
    source_->fail(offset, wrong, expected, broken);
  }

 private:
  const Source* source_;
  std::string_view text_;  // of the source, up to the end of the line
  std::size_t next_;
};

}  // namespace durero::io
