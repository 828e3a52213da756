#pragma once
/// Installs and builds systems, each into a folder of its own; Debian's packages into the machine.

#include <atomic>
#include <functional>
#include <string>
#include <string_view>

#include "durero/conform/ask/system_file.hpp"

namespace durero::conform {

/// The reason why the system cannot be asked, such as "it is not set up"; empty where it can.
std::string why_absent(const System& system);

/// A receiver of progress, a line without its end at a time.
using Say = std::function<void(std::string_view line)>;

/// Installs the system's packages, from Debian, PyPI, crates.io and npm, and builds the program that asks it. Its
/// folder is then complete, or is not there: its earlier contents are removed. Throws std::runtime_error where a step
/// fails, with the end of the step's output.
void set_up(const System& system, const Say& say, const std::atomic<bool>& stop);

}  // namespace durero::conform
