#include "durero/io/file_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "durero/io/source.hpp"

namespace durero::io {
namespace {

bool is_one(const struct stat& a, const struct stat& b) { return a.st_dev == b.st_dev && a.st_ino == b.st_ino; }

/// Waits for the lock of an open file. False where the system has none for it.
bool is_locked_now(int file) {
  int result = 0;
  do result = ::flock(file, LOCK_EX);
  while (result != 0 && errno == EINTR);
  return result == 0;
}

}  // namespace

FileLock::FileLock(const std::string& path) {
  for (;;) {
    file_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    struct stat held {
    }, there{};
    if (file_ < 0 || ::fstat(file_, &held) != 0 || !S_ISREG(held.st_mode)) return;
    if (!is_locked_now(file_)) {
      const std::string why = std::generic_category().message(errno);
      ::close(std::exchange(file_, -1));
      throw FileError(path, fmt::format("cannot be held: {}", why), "expected a file system that locks files");
    }
    // The program that held it before may have put another file in its place.
    if (::stat(path.c_str(), &there) == 0 && is_one(held, there)) return;
    ::close(std::exchange(file_, -1));
  }
}

FileLock::~FileLock() {
  if (file_ >= 0) ::close(file_);
}

bool is_same_file(const std::string& a, const std::string& b) {
  struct stat of_a {
  }, of_b{};
  return ::stat(a.c_str(), &of_a) == 0 && ::stat(b.c_str(), &of_b) == 0 && is_one(of_a, of_b);
}

}  // namespace durero::io
