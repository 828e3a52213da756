#pragma once
/// How far a computed number is from the one meant, by exact arithmetic, in parts of its bound. Roots are taken to 600
/// bits, which for a bound is exact.

#include <limits>

#include "durero/number/quotient.hpp"

namespace durero::test {

using number::Dyadic;

inline Dyadic root(const Dyadic& x) { return number::sign(x) == 0 ? x : number::square_root(x, 600).value; }
inline Dyadic magnitude(const Dyadic& x) { return number::sign(x) < 0 ? -x : x; }

/// |error|/bound; 0 for no error, infinite for an error without a bound.
inline double ratio(const Dyadic& error, const Dyadic& bound) {
  if (number::sign(error) == 0) return 0;
  if (number::sign(bound) <= 0) return std::numeric_limits<double>::infinity();
  return number::round_quotient(magnitude(error), bound);
}

/// The number n/w: a root, or a linear function of one. Precondition: w ≠ 0.
struct Fraction {
  Dyadic n, w;

  /// |x − n/w|/bound.
  double ratio(const Dyadic& x, const Dyadic& bound) const { return test::ratio(x * w - n, bound * magnitude(w)); }
  /// m + k·(n/w)
  Fraction linear(const Dyadic& m, const Dyadic& k) const { return {m * w + k * n, w}; }
};

}  // namespace durero::test
