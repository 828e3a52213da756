#include "progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <condition_variable>
#include <mutex>

#include "durero/io/standard_output.hpp"
#include "durero/text/shown.hpp"
#include "durero/text/utf8.hpp"

namespace durero::cli {
namespace {

using std::chrono::duration;
using std::chrono::milliseconds;

constexpr milliseconds unseen{2000}, between_two{200};

std::string time_text(double seconds) {
  if (seconds < 120) return fmt::format("{:.0f} s", seconds);
  if (seconds < 7200) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

/// The text cut to one line of the terminal: the rest of a longer one would stay when it is written over.
std::string cut_to_terminal(std::string text) {
  winsize size{};
  if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return text;
  return std::string(text::head(text, size.ws_col - 1U));
}

}  // namespace

void add_quiet(CLI::App& command, bool& quiet) {
  command.add_flag("--quiet", quiet, "Show no progress; it is shown on a terminal alone, after two seconds");
}

Progress::Progress(bool is_quiet, std::string work, std::string_view units, std::uint64_t all)
    : work_(text::escaped(work)), units_(units), all_(all) {
  if (is_quiet || ::isatty(STDERR_FILENO) != 1) return;
  shown_ = std::jthread([this](const std::stop_token& end) { show(end); });
}

void Progress::show(const std::stop_token& end) const {
  std::mutex mutex;
  std::condition_variable_any never;
  std::unique_lock lock(mutex);
  const auto ends_within = [&](milliseconds time) {
    return never.wait_for(lock, end, time, [&] { return end.stop_requested(); });
  };
  if (ends_within(unseen)) return;
  do {
    io::complain(fmt::format("\r\033[K{}", cut_to_terminal(line())));
  } while (!ends_within(between_two));
  io::complain("\r\033[K");
}

std::string Progress::line() const {
  const double time = duration<double>(Clock::now() - begin_).count();
  const auto done = static_cast<double>(done_);
  const double share = all_ == unknown ? share_.load() : std::min(1.0, done / static_cast<double>(all_));
  std::string line = work_ + ':';
  if (!units_.empty()) {
    line += fmt::format(" {}", done_.load());
    if (all_ != unknown) line += fmt::format(" of {}", all_);
    const double rate = done / time;
    line += fmt::format(" {0}, {1:.{2}f} {0}/s,", units_, rate, rate < 10 ? 1 : 0);
  } else if (share > 0) {
    line += fmt::format(" {:.0f} %,", 100 * share);
  }
  return line + (share > 0 ? fmt::format(" {} left", time_text(time / share * (1 - share))) : ' ' + time_text(time));
}

}  // namespace durero::cli
