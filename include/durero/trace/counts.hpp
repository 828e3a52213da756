#pragma once
/// The steps by which the tracer decides, and how many decisions each made.

#include <array>
#include <cstdint>

namespace durero::trace {

/// triage computes in binary64 with a bound, stable in double-double with a bound, exact in surface::exact. Each says
/// hit or miss only where it has proved it; what a step leaves undecided goes to the next, and the last leaves nothing.
enum class Step : std::uint8_t { triage, stable, exact };

/// How many decisions of each kind each step made. A plain value: every thread counts in its own, and adds.
struct Counts {
  using Steps = std::array<std::uint64_t, 3>;  ///< by Step
  Steps element{};                             ///< whether and where the ray first meets an element (after the filter)
  Steps order{};                               ///< which of several elements is the nearest: by the last step needed
  Steps rounding{};                            ///< t and point of a hit, rounded once

  /// Adds number by number.
  Counts& operator+=(const Counts& other);
  bool operator==(const Counts&) const = default;
};

}  // namespace durero::trace
