#pragma once
/// An interrupt tells that the user wants the program to end.

#include <atomic>

namespace durero::cli {

/// A flag that is set when the user interrupts the program (SIGINT, SIGTERM, SIGHUP), from this call on.
const std::atomic<bool>& interrupted();

}  // namespace durero::cli
