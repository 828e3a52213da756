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
  static constexpr std::uint64_t unbounded = std::numeric_limits<std::uint64_t>::max();

  explicit Steps(std::uint64_t most = unbounded) : most_(most) {}

  /// Throws StepsSpent where there are more than there may be.
  void take(std::uint64_t steps = 1) {
    taken_ += steps;
    if (taken_ > most_) throw StepsSpent();
  }
  std::uint64_t taken() const { return taken_; }
  std::uint64_t most() const { return most_; }

 private:
  std::uint64_t taken_ = 0, most_;
};

}  // namespace durero::zed
