#pragma once
/// Inputs whose bytes arrive as a test wants them to.
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace durero::test {

inline void write_to(int file, std::string_view bytes) {
  if (::write(file, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size()))
    throw std::runtime_error("not all is written");
}

/// The number of an open regular file that holds a text; whoever takes it closes it.
inline int file_of(std::string_view text) {
  const int file = ::memfd_create("text", MFD_CLOEXEC);
  if (file < 0) throw std::runtime_error("no file");
  write_to(file, text);
  ::lseek(file, 0, SEEK_SET);
  return file;
}

/// A pipe: what is written, at most what a pipe holds, can be read until it is closed, and then its end.
class Pipe {
 public:
  Pipe() {
    if (::pipe(ends_.data()) != 0) throw std::runtime_error("no pipe");
  }
  ~Pipe() { close(); }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  /// The end to read from, which whoever takes it closes.
  int out() const { return ends_[0]; }
  void write(std::string_view bytes) const { write_to(ends_[1], bytes); }
  void close() {
    if (ends_[1] >= 0) ::close(std::exchange(ends_[1], -1));
  }

 private:
  std::array<int, 2> ends_{-1, -1};
};

}  // namespace durero::test
