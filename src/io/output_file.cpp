#include "durero/io/output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <memory>
#include <system_error>
#include <utility>

#include "descriptor.hpp"
#include "durero/io/standard_output.hpp"

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
    if (path_ == "-") path_ = standard_output;
    file_ = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0);
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
  open_beside(permissions(old, exists));
}

void OutputFile::open_beside(unsigned permissions) {
  try {
    file_ = temporary_.emplace(target_).file();
  } catch (const std::system_error& error) {
    refuse("be written", error.code().value());
  }
  if (::fchmod(file_, permissions) == 0) return;
  const int error = errno;
  ::close(file_);
  refuse("be written", error);
}

OutputFile::~OutputFile() {
  if (file_ >= 0) ::close(file_);
}

void OutputFile::write(std::string_view bytes) { write_all(path_, file_, bytes); }

void OutputFile::commit() {
  if (temporary_ && ::fsync(file_) != 0) refuse("be written", errno);
  if (::close(std::exchange(file_, -1)) != 0) refuse("be written", errno);
  if (!temporary_) return;
  try {
    temporary_->replace();
  } catch (const std::system_error& error) {
    refuse("be put in place", error.code().value());
  }
}

void OutputFile::refuse(const char* doing, int error) const { refuse_to_write(path_, doing, error); }

void write_file(const std::string& path, std::string_view bytes) {
  OutputFile file(path);
  file.write(bytes);
  file.commit();
}

}  // namespace durero::io
