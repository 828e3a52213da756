#pragma once
/// A text with its name, and errors that know their place in it: `FILE:LINE:COLUMN: what is wrong; what is expected`.

#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace durero::contract {
struct clause;
}

namespace durero::io {

/// A place in a text: line and column count from 1. Lines end as lines.hpp says. A column is a character: bytes that
/// continue a UTF-8 character do not count. In a `.npy` file the line is the row and the column the value's number in
/// it.
struct TextPosition {
  std::size_t line;    ///< from 1
  std::size_t column;  ///< from 1
  bool operator==(const TextPosition&) const = default;
};

/// Malformed input. what() is one line, escaped as text::escaped does: `FILE:LINE:COLUMN: what is wrong; what is
/// expected`.
class InputError : public std::runtime_error {
 public:
  /// Makes what() of its parts; offset() is 0, as only Source::fail() knows it.
  InputError(const std::string& file, TextPosition place, const std::string& wrong, const std::string& expected,
             const contract::clause* broken = nullptr);
  /// What LINE:COLUMN says.
  TextPosition place() const noexcept { return place_; }
  /// The line without file and place.
  std::string_view message() const noexcept { return std::string_view(what()).substr(message_at_); }
  /// Which byte of the source stands at the place; 0 where the place is of no Source.
  std::size_t offset() const noexcept { return offset_; }
  /// The clause of the Z text that the input breaks; null where it breaks none.
  const contract::clause* broken() const noexcept { return broken_; }

 private:
  friend class Source;
  TextPosition place_;
  std::size_t message_at_;
  std::size_t offset_ = 0;
  const contract::clause* broken_;
};

/// A file that cannot be read or written. what() is one line, escaped: `FILE: what is wrong; what is expected`.
class FileError : public std::runtime_error {
 public:
  /// Makes what() of its parts, and escapes them.
  FileError(const std::string& file, const std::string& wrong, const std::string& expected);
};

/// A text held whole, and its name in messages. Where it is a part of a file, whole lines stand before it.
class Source {
 public:
  /// Takes any bytes. `lines_before` whole lines of the file stand before the text.
  Source(std::string name, std::string text, std::size_t lines_before = 0);
  /// FILE in messages, where it is escaped.
  const std::string& name() const noexcept { return name_; }
  /// The folder that holds, in it or beneath it, each file that the text may name; empty where that is the text's own.
  const std::string& root() const noexcept { return root_; }
  /// Gives that folder.
  void set_root(std::string folder) { root_ = std::move(folder); }
  /// Whether elements of types that a Z text declares are kept.
  bool keeps_surfaces() const noexcept { return keeps_surfaces_; }
  /// Says whether they are.
  void set_keeps_surfaces(bool keeps) noexcept { keeps_surfaces_ = keeps; }
  /// Its bytes, as they were given; valid as long as the source.
  std::string_view text() const noexcept { return text_; }

  /// The place of a byte of the text in its file; the end of the text has one too. All bytes before it are counted
  /// once, however many places are asked for.
  TextPosition place(std::size_t offset) const;
  /// Throws InputError at the place of that byte, with the clause that is broken, if one is.
  [[noreturn]] void fail(std::size_t offset, const std::string& wrong, const std::string& expected,
                         const contract::clause* broken = nullptr) const;

 private:
  struct Counted;  // some places that are known

  std::string name_;
  std::string text_;
  std::string root_{};
  bool keeps_surfaces_ = false;
  std::shared_ptr<Counted> counted_;
};

/// Reads a whole file; "-" is the standard input. Throws FileError.
Source read_source(const std::string& path);

/// Reads a whole file of lines, or a .npy file, which has none. Throws also InputError where a line is longer than
/// longest_line, without reading on.
Source read_lines(const std::string& path);

/// The error of a line of the source that is longer than longest_line, and begins at that byte.
[[noreturn]] void refuse_long_line(const Source& source, std::size_t begin);

}  // namespace durero::io
