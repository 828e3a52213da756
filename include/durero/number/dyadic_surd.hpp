#pragma once
/// The numbers (x + y√delta)/w with dyadic x, y, delta and w: the roots of quadratics with dyadic coefficients, and
/// linear functions of them. Signs and orders are decided by multiplying across, so nothing is divided.
#include <compare>

#include "durero/number/ball.hpp"
#include "durero/number/dyadic.hpp"

namespace durero::number {

/// (x + y√delta)/w. Precondition of every function on it: delta ≥ 0 and w ≠ 0; std::domain_error else.
struct DyadicSurd {
  Dyadic x{}, y{}, delta{}, w{1};  ///< the four numbers of (x + y√delta)/w
};

/// The sign of x + y√a + z√b, exactly: −1, 0 or 1. Throws std::domain_error where a < 0 or b < 0.
int sign_of_sum(const Dyadic& x, const Dyadic& y, const Dyadic& a, const Dyadic& z, const Dyadic& b);

/// −1, 0 or 1, exactly.
int sign(const DyadicSurd& value);

/// The value to about 50 bits, the step before the exact one: where its sign, or that of a difference, is decided,
/// sign() and compare() look no further.
RealBall enclosure(const DyadicSurd& value);

/// Order of the values; the radicands may differ. A strict total order on the numbers denoted.
std::strong_ordering compare(const DyadicSurd& a, const DyadicSurd& b);
/// compare().
inline std::strong_ordering operator<=>(const DyadicSurd& a, const DyadicSurd& b) { return compare(a, b); }
/// Whether the values are equal, whatever their representation.
inline bool operator==(const DyadicSurd& a, const DyadicSurd& b) { return compare(a, b) == 0; }

/// m + n·value, such as a coordinate p + t·v of the point at the root t.
DyadicSurd linear(const Dyadic& m, const Dyadic& n, const DyadicSurd& value);

/// The value rounded once to the nearest binary64, ties to even; overflow, subnormal results and zeros as
/// round_to_binary64 of a Rational.
double round_to_binary64(const DyadicSurd& value);

}  // namespace durero::number
