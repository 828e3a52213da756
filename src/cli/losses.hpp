#pragma once
/// The losses of a change of format, as commands name them on standard error.

#include <fmt/format.h>

#include <string>
#include <vector>

#include "durero/io/standard_output.hpp"
#include "durero/text/shown.hpp"

namespace durero::cli {

/// Prints a line for each thing that a file has lost.
inline void name_losses(const std::string& path, const std::vector<std::string>& lost) {
  for (const std::string& line : lost) io::complain(fmt::format("durero: {}: {}\n", text::escaped(path), line));
}

}  // namespace durero::cli
