#pragma once
/// The progress of a work shows its share, its speed and the time left, on a terminal and nowhere else.

#include <CLI/CLI.hpp>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>
#include <thread>

namespace durero::cli {

/// The option --quiet of a command that shows its progress.
void add_quiet(CLI::App& command, bool& quiet);

/// A progress is a line at the foot of the terminal of the standard error, from two seconds after the beginning to the
/// end of the work. Any thread may add to it.
class Progress {
 public:
  static constexpr std::uint64_t unknown = 0;

  /// The progress of a work in units such as rays; without units the line tells its time alone.
  Progress(bool is_quiet, std::string work, std::string_view units = "", std::uint64_t all = unknown);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Adds so many units.
  void add(std::uint64_t more = 1) { done_ += more; }
  /// Sets the share of the work that is done, from 0 to 1, where the number of units is not known.
  void set_share(double share) { share_ = share; }

 private:
  using Clock = std::chrono::steady_clock;
  void show(const std::stop_token& end) const;
  std::string line() const;

  std::string work_;
  std::string_view units_;
  std::uint64_t all_;
  std::atomic<std::uint64_t> done_ = 0;
  std::atomic<double> share_ = 0;
  Clock::time_point begin_ = Clock::now();
  std::jthread shown_{};  // the last member: it ends before the others do
};

}  // namespace durero::cli
