#include "durero/io/input.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "descriptor.hpp"

namespace durero::io {
namespace {

constexpr std::size_t most_at_once = std::size_t{1} << 16U;  // what a pipe holds

/// The bytes of a regular file that stand behind the place where it is read. A file of /proc says that it is empty.
std::optional<std::uint64_t> bytes_behind(int file) {
  struct stat what {};
  if (::fstat(file, &what) != 0 || !S_ISREG(what.st_mode) || what.st_size == 0) return std::nullopt;
  const off_t at = ::lseek(file, 0, SEEK_CUR);
  if (at < 0) return std::nullopt;
  return static_cast<std::uint64_t>(std::max<off_t>(0, what.st_size - at));
}

}  // namespace

Input::Input(const std::string& path) : name_(path == "-" ? "<stdin>" : path) {
  file_ = path == "-" ? ::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 0) : ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file_ < 0) refuse(errno);
}

Input::~Input() {
  if (file_ >= 0) ::close(file_);
}

bool Input::read() {
  if (file_ < 0) return false;
  held_.erase(0, held_.size() - waiting_.size());
  const std::size_t before = held_.size(), full = before + block_;
  do {
    read_some(std::min(most_at_once, full - held_.size()));
  } while (file_ >= 0 && held_.size() < full && is_ready());
  waiting_ = held_;
  return held_.size() > before;
}

void Input::read_some(std::size_t most) {
  const std::size_t before = held_.size();
  held_.resize(before + most);
  ssize_t count = -1;
  while ((count = ::read(file_, held_.data() + before, most)) < 0 && (errno == EINTR || errno == EAGAIN)) {
    pollfd for_more{file_, POLLIN, 0};
    ::poll(&for_more, 1, -1);
  }
  if (count < 0) refuse(errno);
  held_.resize(before + static_cast<std::size_t>(count));
  if (count == 0) ::close(std::exchange(file_, -1));
}

bool Input::is_ready() const {
  pollfd now{file_, POLLIN, 0};
  return ::poll(&now, 1, 0) == 1;
}

std::optional<std::uint64_t> Input::left() const {
  if (file_ < 0) return waiting_.size();
  const auto behind = bytes_behind(file_);
  if (!behind) return std::nullopt;
  return waiting_.size() + *behind;
}

void Input::look(std::uint64_t ahead, std::span<char> bytes) const {
  if (file_ < 0) {
    std::memcpy(bytes.data(), waiting_.data() + ahead, bytes.size());
    return;
  }
  off_t at = ::lseek(file_, 0, SEEK_CUR) - static_cast<off_t>(waiting_.size()) + static_cast<off_t>(ahead);
  while (!bytes.empty()) {
    const ssize_t count = ::pread(file_, bytes.data(), bytes.size(), at);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) refuse(count < 0 ? errno : EIO);
    at += count;
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
}

void Input::refuse(int error) const { refuse_to_read(name_, error); }

}  // namespace durero::io
