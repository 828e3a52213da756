#pragma once
/// Whether the user wants the program to end.

#include <atomic>

namespace durero::cli {

/// Is set when the user interrupts the program (SIGINT, SIGTERM, SIGHUP), from this call on.
const std::atomic<bool>& interrupted();

}  // namespace durero::cli
