#pragma once
/// The steps of an evaluation are counted and limited.

#include <cstdint>
#include <limits>
#include <stdexcept>

namespace durero::zed {

/// The error of an evaluation that has taken all its steps.
class StepsSpent : public std::runtime_error {
 public:
  StepsSpent() : std::runtime_error("the evaluation takes more steps than it may") {}
};

/// A step is a member that a search visits, an application of a function, a relation asked, or so much work on a large
/// set or number as takes about as long: the time of an evaluation is bounded by that of its steps.
class Steps {
 public:
  /// The limit that stands for none: no evaluation takes so many steps.
  static constexpr std::uint64_t unbounded = std::numeric_limits<std::uint64_t>::max();

  /// A count from 0 with the limit `most`.
  explicit Steps(std::uint64_t most = unbounded) : most_(most) {}

  /// Counts steps. Throws StepsSpent beyond the limit.
  void take(std::uint64_t steps = 1) {
    taken_ += steps;
    if (taken_ > most_) throw StepsSpent();
  }
  /// Returns the number of steps counted, with those beyond the limit.
  std::uint64_t taken() const { return taken_; }
  /// Returns the limit.
  std::uint64_t most() const { return most_; }

 private:
  std::uint64_t taken_ = 0, most_;
};

}  // namespace durero::zed
