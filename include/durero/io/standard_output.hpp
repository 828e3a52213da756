#pragma once
/// What a program prints, in one place: to the standard output, where what cannot be printed is an error, and to the
/// standard error.

#include <string_view>

namespace durero::io {

/// How messages name it.
inline constexpr const char* standard_output = "<stdout>";

/// Throws FileError where nothing can be printed, as where it is closed.
void require_standard_output();

/// Prints all of it at once. Throws FileError where it cannot, as where it is full, or where nobody reads the pipe that
/// it is (and SIGPIPE is ignored).
void print(std::string_view text);

/// Prints to the standard error, as far as it can: where it cannot, there is nowhere to say so.
void complain(std::string_view text) noexcept;

}  // namespace durero::io
