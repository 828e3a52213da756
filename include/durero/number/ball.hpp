#pragma once
/// Numbers known to about 50 bits, to decide a sign quickly where it is not close. For formulas a few operations deep
/// on dyadic numbers: middles are not brought back to one size in between.
#include <cstdint>

#include "durero/number/dyadic.hpp"

namespace durero::number {

/// A number v with |v − middle · 2^exponent| ≤ radius · 2^exponent. The exponent is apart so that nothing overflows.
struct RealBall {
  double middle = 0, radius = 0;  ///< in units of 2^exponent
  std::int64_t exponent = 0;      ///< of the power of two

  /// Of a dyadic number, which it holds.
  explicit RealBall(const Dyadic& value);
  /// Of a finite number: itself.
  explicit RealBall(double value);
  /// m ± r, times 2^e.
  RealBall(double m, double r, std::int64_t e) : middle(m), radius(r), exponent(e) {}

  /// −1 or 1 where every number of the ball has that sign; 0 says "cannot decide".
  int decided_sign() const { return middle > radius ? 1 : middle < -radius ? -1 : 0; }
};

/// @{ A ball that holds the result of every number of a with every number of b.
RealBall operator+(const RealBall& a, const RealBall& b);
inline RealBall operator-(const RealBall& a) { return {-a.middle, a.radius, a.exponent}; }
inline RealBall operator-(const RealBall& a, const RealBall& b) { return a + -b; }
RealBall operator*(const RealBall& a, const RealBall& b);
/// @}
/// RealBall::decided_sign(), as the other numbers have it.
inline int sign(const RealBall& a) { return a.decided_sign(); }
/// Precondition: b was made from a Dyadic other than 0.
RealBall operator/(const RealBall& a, const RealBall& b);
/// Precondition: value was made from a Dyadic, which is not negative.
RealBall sqrt(const RealBall& value);

}  // namespace durero::number
