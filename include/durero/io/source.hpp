#pragma once
/// A text with its name, and errors that know their place in it: `FILE:LINE:COLUMN: what is wrong; what is expected`.

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace durero::io {

/// A place in a text: line and column count from 1. Lines end as lines.hpp says. A column is a character: bytes that
/// continue a UTF-8 character do not count. In a `.npy` file the line is the row and the column the value's number in
/// it.
struct Place {
  std::size_t line;
  std::size_t column;
  bool operator==(const Place&) const = default;
};

/// Malformed input. what() is one line, escaped as text::escaped does: `FILE:LINE:COLUMN: what is wrong; what is
/// expected`.
class InputError : public std::runtime_error {
 public:
  InputError(const std::string& file, Place place, const std::string& wrong, const std::string& expected);
  Place place() const noexcept { return place_; }

 private:
  Place place_;
};

/// A file that cannot be read or written. what() is one line, escaped: `FILE: what is wrong; what is expected`.
class FileError : public std::runtime_error {
 public:
  FileError(const std::string& file, const std::string& wrong, const std::string& expected);
};

/// A text held whole, and its name in messages.
class Source {
 public:
  Source(std::string name, std::string text) : name_(std::move(name)), text_(std::move(text)) {}
  const std::string& name() const noexcept { return name_; }
  std::string_view text() const noexcept { return text_; }

  /// The place of a byte of the text; the end of the text has one too.
  Place place(std::size_t offset) const noexcept;
  /// Throws InputError at the place of that byte.
  [[noreturn]] void fail(std::size_t offset, const std::string& wrong, const std::string& expected) const;

 private:
  std::string name_;
  std::string text_;
};

/// Reads a whole file; "-" is the standard input. Throws FileError.
Source read_source(const std::string& path);

}  // namespace durero::io
