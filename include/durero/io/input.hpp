#pragma once
/// Bytes as they arrive: of a file or a pipe, read a block at a time, or of a text that is held whole already.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "durero/io/source.hpp"

namespace durero::io {

/// What has been read and not been taken waits; who reads from it takes what it has understood, and asks for more where
/// it needs more. Throws FileError where the file cannot be read.
class Input {
 public:
  /// How many bytes a call of read() adds at most, where the caller has not said otherwise: 1 MiB.
  static constexpr std::size_t usual_block = std::size_t{1} << 20U;

  /// Opens the file; "-" is the standard input.
  explicit Input(const std::string& path);
  /// A file that is open, and that it closes. Precondition: block > 0.
  Input(std::string name, int file, std::size_t block = usual_block)
      : name_(std::move(name)), file_(file), block_(block) {}
  /// A text held whole, which must outlive it.
  explicit Input(const Source& source) : name_(source.name()), waiting_(source.text()) {}
  ~Input();
  Input(const Input&) = delete;
  Input& operator=(const Input&) = delete;

  /// As messages name it; the standard input is "<stdin>".
  const std::string& name() const noexcept { return name_; }
  /// The bytes that wait, the next one first; valid until the next read().
  std::string_view waiting() const noexcept { return waiting_; }
  /// Precondition: so many wait.
  void take(std::size_t bytes) noexcept { waiting_.remove_prefix(bytes); }
  /// Puts more behind what waits: what is there, at most a block, and waits where that is nothing. False at the end.
  bool read();

  /// How many bytes wait or come, where that is known: of a regular file, of a text, and at the end.
  std::optional<std::uint64_t> left() const;
  /// Those that stand so far behind the first that waits, without taking any. Precondition: left() is known, and they
  /// are there. Throws FileError also where the file has become shorter.
  void look(std::uint64_t ahead, std::span<char> bytes) const;

 private:
  void read_some(std::size_t most);
  /// True where read_some() would not wait.
  bool is_ready() const;
  [[noreturn]] void refuse(int error) const;

  std::string name_;
  int file_ = -1;  // -1: nothing more to read
  std::size_t block_ = usual_block;
  std::string held_;
  std::string_view waiting_;  // in held_, or in the text
};

}  // namespace durero::io
