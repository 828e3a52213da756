#pragma once
/// A hold on a file from when it is read until another takes its place, so that no change between is lost.

#include <string>

namespace durero::io {

/// The hold of one program on a file. Another that asks for it waits, and then finds the file that has come in its
/// place. Programs that do not ask are not kept from anything.
class FileLock {
 public:
  /// Waits until nobody else holds the file, and holds it. A path of no regular file, such as a pipe, is not held.
  /// Throws FileError where the file cannot be held.
  explicit FileLock(const std::string& path);
  /// Lets go.
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  int file_ = -1;
};

/// Whether two paths mean one file, which exists, with symbolic links followed.
bool is_same_file(const std::string& a, const std::string& b);

}  // namespace durero::io
