#include "durero/number/dyadic_surd.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "durero/number/ball.hpp"
#include "durero/number/quotient.hpp"
#include "number/quick_round.hpp"

namespace durero::number {
namespace {

void require_radicand(const Dyadic& delta) {
  if (sign(delta) < 0) throw std::domain_error("a negative number has no square root here");
}

void require_valid(const DyadicSurd& value) {
  require_radicand(value.delta);
  if (sign(value.w) == 0) throw std::domain_error("a surd's denominator is 0");
}

/// The sign of y√a. Precondition: a ≥ 0.
int sign_of_term(const Dyadic& y, const Dyadic& a) { return sign(a) == 0 ? 0 : sign(y); }

/// The sign of x + y√a. Precondition: a ≥ 0.
int sign_of_pair(const Dyadic& x, const Dyadic& y, const Dyadic& a) {
  const int of_x = sign(x);
  const int of_y = sign_of_term(y, a);
  if (of_x == of_y || of_y == 0) return of_x;
  if (of_x == 0) return of_y;
  if (const int decided = (RealBall(x) + RealBall(y) * sqrt(RealBall(a))).decided_sign()) return decided;
  // Opposite signs: the sum has the sign of the term of the greater square.
  return of_x * sign(square(x) - square(y) * a);
}

/// The binary64 as a number, an infinity as the power of two where its binade would begin: so the middle of the
/// greatest binary64 and the infinity is 2¹⁰²⁴ − 2⁹⁷⁰, from which on IEEE 754 rounds to the infinity.
Dyadic extended(double value) { return std::isinf(value) ? shifted(Dyadic(value > 0 ? 1 : -1), 1024) : Dyadic(value); }

/// The value lies between neighbours low and high: the nearer, or the even one.
double nearer(const DyadicSurd& value, double low, double high) {
  const Dyadic middle = shifted(extended(low) + extended(high), -1);
  const auto order = compare(value, {.x = middle});
  if (order == 0) return round_to_binary64(middle);
  return order < 0 ? low : high;
}

}  // namespace

int sign_of_sum(const Dyadic& x, const Dyadic& y, const Dyadic& a, const Dyadic& z, const Dyadic& b) {
  require_radicand(a);
  require_radicand(b);
  const int of_z = sign_of_term(z, b);
  if (of_z == 0) return sign_of_pair(x, y, a);
  if (a == b) return sign_of_pair(x, y + z, a);
  const RealBall sum = RealBall(x) + RealBall(y) * sqrt(RealBall(a)) + RealBall(z) * sqrt(RealBall(b));
  if (const int decided = sum.decided_sign()) return decided;
  const int of_pair = sign_of_pair(x, y, a);
  if (of_pair == of_z || of_pair == 0) return of_z;
  // Opposite signs: the sum has the sign of the part of the greater square, and
  // (x + y√a)² − (z√b)² = (x² + y²a − z²b) + 2xy√a.
  const Dyadic difference = square(x) + square(y) * a - square(z) * b;
  return of_pair * sign_of_pair(difference, shifted(x * y, 1), a);
}

int sign(const DyadicSurd& value) {
  require_valid(value);
  return sign(value.w) * sign_of_pair(value.x, value.y, value.delta);
}

RealBall enclosure(const DyadicSurd& value) {
  require_valid(value);
  return (RealBall(value.x) + RealBall(value.y) * sqrt(RealBall(value.delta))) / RealBall(value.w);
}

std::strong_ordering compare(const DyadicSurd& a, const DyadicSurd& b) {
  if (const int decided = (enclosure(a) + -enclosure(b)).decided_sign()) return decided <=> 0;
  // a − b = ((x₁w₂ − x₂w₁) + y₁w₂√δ₁ − y₂w₁√δ₂)/(w₁w₂)
  const int of_numerator = sign_of_sum(a.x * b.w - b.x * a.w, a.y * b.w, a.delta, -(b.y * a.w), b.delta);
  return of_numerator * sign(a.w) * sign(b.w) <=> 0;
}

DyadicSurd linear(const Dyadic& m, const Dyadic& n, const DyadicSurd& value) {
  return {m * value.w + n * value.x, n * value.y, value.delta, value.w};
}

double round_to_binary64(const DyadicSurd& value) {
  require_valid(value);
  const bool is_rational = sign_of_term(value.y, value.delta) == 0;
  if (is_rational && sign(value.x) == 0) return 0;
  if (const auto rounded = quick_round(value)) return *rounded;
  if (is_rational) return round_quotient(value.x, value.w);
  // A narrowing interval around the value. Where the value is not 0, in the end the interval lies on one side of 0 and
  // holds at most one middle of two neighbours, which is then compared exactly. Where it is 0, √delta = −x/y is
  // rational, hence dyadic, and in the end the root is exact. 128 bits are enough unless x and y√delta nearly cancel.
  for (std::int64_t bits = 128;; bits *= 2) {
    const SquareRoot root = square_root(value.delta, bits);
    const Dyadic begin = value.x + value.y * root.value;
    if (root.exact) return round_quotient(begin, value.w);
    const Dyadic end = begin + value.y * root.unit;
    if (sign(begin) * sign(end) <= 0) continue;
    const double one = round_quotient(begin, value.w);
    const double other = round_quotient(end, value.w);
    if (one == other) return one;
    const auto [low, high] = std::minmax(one, other);
    if (std::nextafter(low, std::numeric_limits<double>::infinity()) == high) return nearer(value, low, high);
  }
}

}  // namespace durero::number
