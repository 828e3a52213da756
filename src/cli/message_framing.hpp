#pragma once
/// The framing of the Language Server Protocol: each message behind headers, of which Content-Length counts its bytes.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace durero::cli {

/// Parts a stream of bytes into messages.
class MessageFraming {
 public:
  /// The longest headers and the longest message that are read, in bytes: a text of a MiB takes six, escaped.
  static constexpr std::size_t most_header = 4096, most_message = std::size_t{16} << 20U;

  /// Adds bytes that were read.
  void add(std::string_view bytes);
  /// Returns the next message, once all of it was added. Throws io::InputError at headers that count no bytes: nothing
  /// tells where the next message begins.
  std::optional<std::string> next();
  /// Says whether a message has begun and not ended.
  bool is_within() const { return from_ < bytes_.size(); }

 private:
  std::size_t length_in(std::string_view headers) const;
  [[noreturn]] void refuse(std::size_t at, const std::string& what, const char* expected) const;

  std::string bytes_;
  std::size_t from_ = 0;   // what stands before it was given out
  std::size_t lines_ = 0;  // the line ends before that, and before what was dropped
};

/// Returns a message with its headers.
std::string framed(std::string_view message);

}  // namespace durero::cli
