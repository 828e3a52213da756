#include "interrupted.hpp"

#include <csignal>

namespace durero::cli {
namespace {

std::atomic<bool> was_interrupted = false;

}  // namespace

const std::atomic<bool>& interrupted() {
  static_assert(std::atomic<bool>::is_always_lock_free);  // so a signal handler may set it
  const auto interrupt = [](int) { was_interrupted = true; };
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, interrupt);
  if (std::signal(SIGHUP, interrupt) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);  // as nohup starts it
  return was_interrupted;
}

}  // namespace durero::cli
