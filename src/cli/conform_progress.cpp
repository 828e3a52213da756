#include "conform_progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

namespace durero::cli {

bool Progress::is_terminal() { return ::isatty(STDERR_FILENO) == 1; }

Progress::~Progress() {
  if (is_shown_) fmt::print(stderr, "\r\033[K");
}

void Progress::step() {
  ++done_;
  const std::chrono::duration<double> passed = Clock::now() - begin_;
  if (!is_shown_ || (Clock::now() - last_ < std::chrono::milliseconds(200) && done_ != all_)) return;
  last_ = Clock::now();
  const double left = passed.count() / static_cast<double>(done_) * static_cast<double>(all_ - done_);
  fmt::print(stderr, "\r\033[K{}: {} of {} scenes, {:.0f} s left", name_, done_, all_, left);
}

}  // namespace durero::cli
