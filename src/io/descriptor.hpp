#pragma once
/// What is done with an open file by its number, and said where it fails: FileError, with an error of errno.

#include <string>
#include <string_view>

namespace durero::io {

[[noreturn]] void refuse_to_read(const std::string& name, int error);
/// It cannot do what is named, as "be written".
[[noreturn]] void refuse_to_write(const std::string& name, const char* doing, int error);

/// Writes all of it, and waits where there is no room for it yet.
void write_all(const std::string& name, int file, std::string_view bytes);

}  // namespace durero::io
