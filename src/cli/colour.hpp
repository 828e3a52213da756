#pragma once
/// Colour: on a terminal, where NO_COLOR is unset or empty (no-color.org).

#include <string>
#include <string_view>

namespace durero::cli {

/// The text of an error in red, for the file of that number: STDOUT_FILENO or STDERR_FILENO.
std::string in_red(std::string_view text, int file);
/// The text of a thing done in green, likewise.
std::string in_green(std::string_view text, int file);

}  // namespace durero::cli
