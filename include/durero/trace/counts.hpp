#pragma once
/// The tracer decides in three steps; their decisions are counted.

#include <array>
#include <cstdint>

namespace durero::trace {

/// The triage computes in binary64 with a bound, stable in double-double with a bound, exact in surface::exact. A step
/// says hit or miss only where it has proved it, and leaves the rest to the next; the exact step decides everything.
enum class Step : std::uint8_t { triage, stable, exact };

/// The number of decisions by kind and step. Every thread has its own counts, which are added at the end.
struct Counts {
  using Steps = std::array<std::uint64_t, 3>;  ///< a number for each Step
  Steps element{};                             ///< the first point on an element that passed the filter
  Steps order{};                               ///< which of several elements is nearest: by the last step needed
  Steps rounding{};                            ///< t and point of a hit, rounded once

  /// Adds each number.
  Counts& operator+=(const Counts& other);
  bool operator==(const Counts&) const = default;
};

}  // namespace durero::trace
