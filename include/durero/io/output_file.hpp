#pragma once
/// An output file that appears whole or not at all.

#include <cstdio>
#include <string>
#include <string_view>

namespace durero::io {

/// Writes beside its target under a temporary name, and takes the target's name at commit(): until then, and if
/// commit() is never reached, the target is as it was and no other file is left. A target that is a symbolic link keeps
/// being one. "-" and /dev/stdout are the standard output; it, and a target that exists and is no regular file (a pipe,
/// a device), are written to at commit(). All members throw FileError, one line that names the target.
class OutputFile {
 public:
  explicit OutputFile(std::string path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view bytes);
  /// Puts the file in place, on disk. Nothing may be written after it.
  void commit();

 private:
  [[noreturn]] void refuse(const char* doing, int error) const;
  void write_all(int file, std::string_view bytes);

  std::string path_;       // as the caller names it
  std::string target_;     // with links followed
  std::string temporary_;  // empty: nothing to remove
  std::string direct_;     // the whole text, for a target that is no regular file
  int file_ = -1;
};

/// The whole text at once.
void write_file(const std::string& path, std::string_view bytes);

}  // namespace durero::io
