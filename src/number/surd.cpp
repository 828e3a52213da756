#include "durero/number/surd.hpp"

#include <stdexcept>
#include <utility>

namespace durero::number {
namespace {

/// b's coefficient on the square root of the field's delta, where a gives the field: √b.delta = √(b.delta/a.delta) ·
/// √a.delta.
Rational coefficient_in(const Rational& delta, const Surd& b) {
  if (b.y.is_zero() || b.delta == delta) return b.y;
  const auto ratio = rational_sqrt(Rational(b.delta / delta));
  if (!ratio) throw std::domain_error("arithmetic on surds of different fields");
  return b.y * *ratio;
}

/// The delta of the field that both lie in; where both are rational, 0.
const Rational& common_delta(const Surd& a, const Surd& b) { return a.y.is_zero() ? b.delta : a.delta; }

/// x + y√delta, where delta is a field's and so no square of a rational.
Surd in_field(Rational x, Rational y, const Rational& delta) {
  Surd number(std::move(x));
  if (!y.is_zero()) {
    number.y = std::move(y);
    number.delta = delta;
  }
  return number;
}

bool rational(const Surd& value) { return value.y.is_zero(); }

/// x + y√delta with the square root brought to an integer: √(n/d) = √(n·d)/d.
DyadicSurd dyadic(const Surd& value) {
  const Integer n = numerator(value.delta);
  const Integer d = denominator(value.delta);
  const Integer of_x = denominator(value.x);
  const Integer of_y = denominator(value.y) * d;
  return {.x = {Integer(numerator(value.x) * of_y), 0},
          .y = {Integer(numerator(value.y) * of_x), 0},
          .delta = {Integer(n * d), 0},
          .w = {Integer(of_x * of_y), 0}};
}

}  // namespace

Surd::Surd(Rational rational, Rational coefficient, Rational radicand)
    : x(std::move(rational)), y(std::move(coefficient)), delta(std::move(radicand)) {
  if (delta.sign() < 0) throw std::domain_error("a negative number has no square root here");
  if (const auto root = rational_sqrt(delta)) {
    x += y * *root;
    y = 0;
  }
  if (y.is_zero()) delta = 0;
}

Surd::Surd(const DyadicSurd& value) {
  if (sign(value.w) == 0) throw std::domain_error("a surd's denominator is 0");
  const Rational w = value.w.rational();
  *this = Surd(value.x.rational() / w, value.y.rational() / w, value.delta.rational());
}

Surd Surd::operator-() const {
  Surd result = *this;
  result.x = -result.x;
  result.y = -result.y;
  return result;
}

Surd operator+(const Surd& a, const Surd& b) {
  if (rational(a) && rational(b)) return Rational(a.x + b.x);
  const Rational& delta = common_delta(a, b);
  return in_field(a.x + b.x, a.y + coefficient_in(delta, b), delta);
}

Surd operator-(const Surd& a, const Surd& b) {
  if (rational(a) && rational(b)) return Rational(a.x - b.x);
  const Rational& delta = common_delta(a, b);
  return in_field(a.x - b.x, a.y - coefficient_in(delta, b), delta);
}

Surd operator*(const Surd& a, const Surd& b) {
  if (rational(b)) return rational(a) ? Surd(Rational(a.x * b.x)) : in_field(a.x * b.x, a.y * b.x, a.delta);
  if (rational(a)) return in_field(a.x * b.x, a.x * b.y, b.delta);
  const Rational by = coefficient_in(a.delta, b);
  return in_field(a.x * b.x + a.y * by * a.delta, a.x * by + a.y * b.x, a.delta);
}

Surd operator/(const Surd& a, const Surd& b) {
  if (rational(b) && !b.x.is_zero()) return in_field(a.x / b.x, a.y / b.x, a.delta);
  // 1/(x + y√δ) = (x − y√δ)/(x² − y²δ), and that norm is 0 only where the number is: else √δ would be rational.
  const Rational norm = b.x * b.x - b.y * b.y * b.delta;
  if (norm.is_zero()) throw std::domain_error("a surd divided by 0");
  return a * Surd(b.x / norm, -b.y / norm, b.delta);
}

int sign_of_sum(const Rational& x, const Rational& y, const Rational& a, const Rational& z, const Rational& b) {
  const auto order = compare(Surd(x, y, a), Surd(0, -z, b));
  return order < 0 ? -1 : order > 0 ? 1 : 0;
}

int sign(const Surd& value) { return rational(value) ? value.x.sign() : sign(dyadic(value)); }

std::strong_ordering compare(const Surd& a, const Surd& b) {
  if (rational(a) && rational(b)) return a.x.compare(b.x) <=> 0;
  if (a.x == b.x && a.y == b.y && a.delta == b.delta) return std::strong_ordering::equal;
  return compare(dyadic(a), dyadic(b));
}

double round_to_binary64(const Surd& value) { return round_to_binary64(dyadic(value)); }

}  // namespace durero::number
