#pragma once
/// Inputs whose bytes arrive as a test wants them to.
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
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
  /// The end to write to, which the pipe closes.
  int in() const { return ends_[1]; }
  void write(std::string_view bytes) const { write_to(ends_[1], bytes); }
  void close() {
    if (ends_[1] >= 0) ::close(std::exchange(ends_[1], -1));
  }

 private:
  std::array<int, 2> ends_{-1, -1};
};

/// A pipe that blanks come through for as long as it is read, or until so many have come.
class Blanks {
 public:
  explicit Blanks(std::string_view before, std::size_t most = std::size_t{1} << 26U) {
    pipe_.write(before);
    writing_ = std::jthread([this, most] {
      sigset_t broken_pipe;
      sigemptyset(&broken_pipe);
      sigaddset(&broken_pipe, SIGPIPE);
      ::pthread_sigmask(SIG_BLOCK, &broken_pipe, nullptr);
      const std::string blanks(std::size_t{1} << 16U, ' ');
      ssize_t count = 0;
      while (count_ < most && (count = ::write(pipe_.in(), blanks.data(), blanks.size())) > 0)
        count_ += static_cast<std::size_t>(count);
      pipe_.close();
    });
  }

  /// The end to read from, which whoever takes it closes.
  int out() const { return pipe_.out(); }
  /// How many have come when nobody reads any more.
  std::size_t count() {
    writing_.join();
    return count_;
  }

 private:
  Pipe pipe_;
  std::size_t count_ = 0;
  std::jthread writing_;
};

}  // namespace durero::test
