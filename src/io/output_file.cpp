#include "durero/io/output_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <utility>

#include "durero/io/source.hpp"

namespace durero::io {
namespace {

// The file that a path means, with symbolic links followed: renaming over a link would replace the link itself.
std::string resolved(const std::string& path) {
  const std::unique_ptr<char, void (*)(void*)> real(::realpath(path.c_str(), nullptr), std::free);
  return real ? std::string(real.get()) : path;
}

// The permissions that the new file gets: those of the file it replaces, else those that open(2) would give.
mode_t permissions(const struct stat& old, bool exists) {
  if (exists) return old.st_mode & 07777U;
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return 0666U & ~mask;
}

// True where a path means the standard output itself, wherever that goes: to put another file in its place would lose
// what else is printed there.
bool is_standard_output(const std::string& path, const struct stat& file) {
  struct stat out {};
  return path.starts_with("/dev/") && ::fstat(STDOUT_FILENO, &out) == 0 && out.st_dev == file.st_dev &&
         out.st_ino == file.st_ino;
}

}  // namespace

OutputFile::OutputFile(std::string path) : path_(std::move(path)), target_(resolved(path_)) {
  struct stat old {};
  const bool exists = ::stat(path_.c_str(), &old) == 0;
  if (path_ == "-" || (exists && is_standard_output(path_, old))) {
    file_ = ::dup(STDOUT_FILENO);
    if (file_ < 0) refuse("be written", errno);
    return;
  }
  if (exists && S_ISDIR(old.st_mode)) refuse("be written", EISDIR);
  if (exists && !S_ISREG(old.st_mode)) {
    file_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
    if (file_ < 0) refuse("be written", errno);
    return;
  }
  if (exists && ::access(target_.c_str(), W_OK) != 0) refuse("be written", errno);
  std::string name = target_ + '.' + std::string(6, 'X');  // mkostemp puts its own six characters there
  file_ = ::mkostemp(name.data(), O_CLOEXEC);
  if (file_ < 0) refuse("be written", errno);
  temporary_ = name;
  if (::fchmod(file_, permissions(old, exists)) != 0) {
    const int error = errno;
    ::close(file_);
    ::unlink(name.c_str());
    refuse("be written", error);
  }
}

OutputFile::~OutputFile() {
  if (file_ >= 0) ::close(file_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void OutputFile::write(std::string_view bytes) {
  if (temporary_.empty()) {
    direct_.append(bytes);
  } else {
    write_all(file_, bytes);
  }
}

void OutputFile::commit() {
  if (temporary_.empty()) {
    write_all(file_, direct_);
  } else if (::fsync(file_) != 0) {
    refuse("be written", errno);
  }
  const int closed = ::close(std::exchange(file_, -1));
  if (closed != 0) refuse("be written", errno);
  if (temporary_.empty()) return;
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) refuse("be put in place", errno);
  temporary_.clear();
}

void OutputFile::write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(file, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) refuse("be written", errno);
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
}

void OutputFile::refuse(const char* doing, int error) const {
  throw FileError(path_, fmt::format("cannot {}: {}", doing, std::strerror(error)),
                  "expected a file that can be written, in a directory that can");
}

void write_file(const std::string& path, std::string_view bytes) {
  OutputFile file(path);
  file.write(bytes);
  file.commit();
}

}  // namespace durero::io
