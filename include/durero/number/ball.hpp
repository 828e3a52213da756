#pragma once
/// Numbers known to about 50 bits, to decide a sign quickly where it is not close. For formulas a few operations deep
/// on dyadic numbers: middles are not brought back to one size in between.
#include <cstdint>

#include "durero/number/dyadic.hpp"

namespace durero::number {

/// A number v with |v − middle · 2^exponent| ≤ radius · 2^exponent. The exponent is apart so that nothing overflows.
struct Ball {
  double middle = 0, radius = 0;  ///< in units of 2^exponent
  std::int64_t exponent = 0;      ///< of the power of two

  /// Of a dyadic number, which it holds.
  explicit Ball(const Dyadic& value);
  /// Of a finite number: itself.
  explicit Ball(double value);
  /// m ± r, times 2^e.
  Ball(double m, double r, std::int64_t e) : middle(m), radius(r), exponent(e) {}

  /// −1 or 1 where every number of the ball has that sign; 0 says "cannot decide".
  int decided_sign() const { return middle > radius ? 1 : middle < -radius ? -1 : 0; }
};

/// @{ A ball that holds the result of every number of a with every number of b.
Ball operator+(const Ball& a, const Ball& b);
inline Ball operator-(const Ball& a) { return {-a.middle, a.radius, a.exponent}; }
inline Ball operator-(const Ball& a, const Ball& b) { return a + -b; }
Ball operator*(const Ball& a, const Ball& b);
/// @}
/// Ball::decided_sign(), as the other numbers have it.
inline int sign(const Ball& a) { return a.decided_sign(); }
/// Precondition: b was made from a Dyadic other than 0.
Ball operator/(const Ball& a, const Ball& b);
/// Precondition: value was made from a Dyadic, which is not negative.
Ball sqrt(const Ball& value);

}  // namespace durero::number
