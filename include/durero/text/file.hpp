#pragma once
/// Reading a file whole, in one place for every layer.

#include <cstddef>
#include <cstdio>
#include <limits>
#include <string>

namespace durero::text {

/// As many bytes as there are.
inline constexpr std::size_t no_limit = std::numeric_limits<std::size_t>::max();

/// Returns what is left to read of an open file, and of that the first `most` bytes. Throws std::system_error with the
/// error of the system where it cannot be read.
std::string read_rest(std::FILE& file, std::size_t most = no_limit);

/// Returns the bytes of the file at this path, the first `most` of them where it has more. Throws std::system_error
/// with the error of the system where it cannot be opened or read, as a folder cannot.
std::string read_file(const std::string& path, std::size_t most = no_limit);

}  // namespace durero::text
