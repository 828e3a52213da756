#pragma once
/// Installs and builds systems, each into a folder of its own; Debian's packages into the machine.

#include <atomic>
#include <functional>
#include <string>
#include <string_view>

#include "durero/conform/system_file.hpp"

namespace durero::conform {

/// Why the system cannot be asked, such as "it is not set up"; empty where it can.
std::string why_absent(const System& system);

/// Is told what is done, in a line without its end.
using Say = std::function<void(std::string_view line)>;

/// Installs what the system names, from Debian, PyPI, crates.io and npm, and builds what asks it. Its folder is then
/// whole, or is not there: what was in it before is removed. Throws std::runtime_error where a step fails, with the end
/// of what it said.
void set_up(const System& system, const Say& say, const std::atomic<bool>& stop);

}  // namespace durero::conform
