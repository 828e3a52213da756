#include "durero/number/ball.hpp"

#include <cmath>
#include <utility>

#include "number/binary64.hpp"

// Magnitudes: a ball made from a number has middle 0 or in [1/2, 1). The formulas built on them are a few operations
// deep, so middles and radii stay far from overflow, and what is added stays far from underflow (see operator+).
namespace durero::number {
namespace {

// One operation of binary64 errs by at most 2⁻⁵³ of the exact result, which is less than 2⁻⁵² of the rounded one.
constexpr double rounding = 0x1p-52;

/// A radius, a sum of non-negative terms computed in at most 7 roundings, is short by less than 7 · 2⁻⁵³ of itself;
/// 1 + 2⁻⁴⁹ makes up for that and for its own rounding.
double above(double radius) { return radius * (1 + 0x1p-49); }

}  // namespace

RealBall::RealBall(const Dyadic& value) {
  if (sign(value) == 0) return;
  const Leading magnitude = leading(value);
  // The 11 bits dropped, and what lies below them, are less than one unit of 2⁻⁵³.
  middle = static_cast<double>(magnitude.bits >> 11) * 0x1p-53;
  if (sign(value) < 0) middle = -middle;
  radius = 0x1p-53;
  exponent = magnitude.exponent + 64;
}

RealBall::RealBall(double value) {
  int places = 0;
  middle = std::frexp(value, &places);
  exponent = places;
}

RealBall operator+(const RealBall& a, const RealBall& b) {
  if (a.middle == 0 && a.radius == 0) return b;
  if (b.middle == 0 && b.radius == 0) return a;
  if (a.exponent < b.exponent) return b + a;
  const std::int64_t shift = a.exponent - b.exponent;
  // Beyond 200 places b, whose middle and radius are less than 2⁹ each, is less than 2⁻¹⁹⁰; a radius says so.
  if (shift > 200) return {a.middle, above(a.radius + 0x1p-190), a.exponent};
  const double scale = std::ldexp(1.0, static_cast<int>(-shift));
  const double middle = a.middle + b.middle * scale;
  return {middle, above(a.radius + b.radius * scale + rounding * std::abs(middle)), a.exponent};
}

RealBall operator*(const RealBall& a, const RealBall& b) {
  const double middle = a.middle * b.middle;
  return {middle,
          above(std::abs(a.middle) * b.radius + a.radius * std::abs(b.middle) + a.radius * b.radius +
                rounding * std::abs(middle)),
          a.exponent + b.exponent};
}

RealBall operator/(const RealBall& a, const RealBall& b) {
  // A/B − a/b = (A − a)/B + (a/b)·(b − B)/B, and |B| ≥ |b| − radius, a difference of numbers in [1/2, 1) and 2⁻⁵³ that
  // is exact up to one rounding.
  const double middle = a.middle / b.middle;
  const double least = std::abs(b.middle) - b.radius;
  return {middle,
          above((a.radius + std::abs(middle) * (1 + rounding) * b.radius) / least + rounding * std::abs(middle)),
          a.exponent - b.exponent};
}

RealBall sqrt(const RealBall& value) {
  if (value.middle == 0) return value;
  const bool odd = value.exponent % 2 != 0;
  const double scaled = odd ? 2 * value.middle : value.middle;
  const double radius = odd ? 2 * value.radius : value.radius;
  // |√V − √v| = |V − v|/(√V + √v) ≤ |V − v|/√v, and the computed root is within 2⁻⁵³ of √v, relatively.
  const double root = std::sqrt(scaled);
  return {root, above(radius / root * (1 + rounding) + rounding * root), (value.exponent - (odd ? 1 : 0)) / 2};
}

}  // namespace durero::number
