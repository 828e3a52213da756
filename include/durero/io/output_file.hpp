#pragma once
/// An output file that appears whole or not at all.

#include <optional>
#include <string>
#include <string_view>

#include "durero/io/temporary.hpp"

namespace durero::io {

/// Writes a Temporary beside its target, which takes the target's name at commit(): until then, and if commit() is
/// never reached, the target is as it was and no other file is left, as temporary.hpp says. A target that is a symbolic
/// link keeps being one. "-" and /dev/stdout are the standard output; it, and a target that exists and is no regular
/// file (a pipe, a device), are streams: what is written to them is there at once. All members throw FileError, one
/// line that names the target.
class OutputFile {
 public:
  /// Finds out whether the target can be written, so it is for the beginning of a work.
  explicit OutputFile(std::string path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Writes behind what has been written. Precondition: commit() has not been called.
  void write(std::string_view bytes);
  /// Puts the file in place, on disk. Nothing may be written after it.
  void commit();

 private:
  [[noreturn]] void refuse(const char* doing, int error) const;
  void open_beside(unsigned permissions);

  std::string path_;                    // as messages name it
  std::string target_;                  // with links followed
  std::optional<Temporary> temporary_;  // nothing: the target is a stream
  int file_ = -1;
};

/// The whole text at once.
void write_file(const std::string& path, std::string_view bytes);

}  // namespace durero::io
