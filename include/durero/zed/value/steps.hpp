#pragma once
/// What an evaluation has done so far, and how much it may do.

#include <cstdint>
#include <limits>
#include <stdexcept>

namespace durero::zed {

/// Tells that an evaluation has taken all the steps that it may.
class StepsSpent : public std::runtime_error {
 public:
  StepsSpent() : std::runtime_error("the evaluation takes more steps than it may") {}
};

/// A step is a member that a search visits, an application of a function, a relation asked, or so much work on a large
/// set or number as takes about as long: the time of an evaluation is bounded by that of its steps.
class Steps {
 public:
  /// The most steps where there is no bound: no evaluation takes so many.
  static constexpr std::uint64_t unbounded = std::numeric_limits<std::uint64_t>::max();

  /// Counts from 0, and allows so many.
  explicit Steps(std::uint64_t most = unbounded) : most_(most) {}

  /// Throws StepsSpent where there are more than there may be.
  void take(std::uint64_t steps = 1) {
    taken_ += steps;
    if (taken_ > most_) throw StepsSpent();
  }
  /// Returns how many were asked for so far, with those that were too many.
  std::uint64_t taken() const { return taken_; }
  /// Returns how many there may be.
  std::uint64_t most() const { return most_; }

 private:
  std::uint64_t taken_ = 0, most_;
};

}  // namespace durero::zed
