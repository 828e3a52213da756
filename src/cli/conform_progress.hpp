#pragma once
/// How much of a run is done, and the time that is left: on a terminal, and nowhere else.

#include <chrono>
#include <cstddef>
#include <string>

namespace durero::cli {

class Progress {
 public:
  Progress(std::string name, std::size_t all) : name_(std::move(name)), all_(all) {}
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// One scene more is done.
  void step();

 private:
  using Clock = std::chrono::steady_clock;
  std::string name_;
  std::size_t all_, done_ = 0;
  bool is_shown_ = is_terminal();
  Clock::time_point begin_ = Clock::now(), last_{};

  static bool is_terminal();
};

}  // namespace durero::cli
