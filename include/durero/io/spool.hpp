#pragma once
/// Bytes that are put aside until what stands before them is known.

#include <string>
#include <string_view>

#include "durero/io/input.hpp"

namespace durero::io {

/// A file without a name beside the one that the bytes are for, so that it is gone whatever happens. All members throw
/// FileError, which names that one.
class Spool {
 public:
  /// Makes the file in the folder of the target, which it does not touch.
  explicit Spool(std::string target);
  ~Spool();
  Spool(const Spool&) = delete;
  Spool& operator=(const Spool&) = delete;

  /// Writes behind what has been written. Precondition: read() has not been called.
  void write(std::string_view bytes);
  /// What has been written, from its beginning. Nothing may be written after it.
  Input read();

 private:
  std::string target_;
  int file_ = -1;
};

}  // namespace durero::io
