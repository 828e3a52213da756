#pragma once
/// A watch sees each save of a file: in place, or by renaming another file to its name.

#include <string>
#include <vector>

#include "durero/io/source.hpp"

namespace durero::cli {

/// A watch of one file, by inotify. Where the path is a link, the file that it leads to is watched as well.
class FileWatch {
 public:
  /// Watches from now on. Throws io::FileError where the folder cannot be watched; the file may be absent.
  explicit FileWatch(std::string path);
  ~FileWatch();
  FileWatch(const FileWatch&) = delete;
  FileWatch& operator=(const FileWatch&) = delete;

  /// The path that is watched.
  const std::string& path() const noexcept { return path_; }
  /// The descriptor that can be read where something has happened in the folder.
  int descriptor() const noexcept { return descriptor_; }
  /// Whether the file was saved, or removed, since the last call. It does not wait.
  bool was_saved();
  /// Waits so many milliseconds at most; whether the file was saved, or removed. An interrupt ends it.
  bool is_saved_within(int milliseconds);
  /// The file, once it is whole: a text that is no JSON is taken for one that is being written, until no byte of it has
  /// changed for 150 ms. Throws io::FileError where it cannot be read.
  io::Source whole_file();

 private:
  /// A name in a folder that is watched.
  struct Watched {
    int folder;
    std::string name;
  };
  void watch(const std::string& path);

  std::string path_;
  int descriptor_;
  std::vector<Watched> watched_{};
};

}  // namespace durero::cli
