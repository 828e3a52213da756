#pragma once
/// The numbers x + y√delta over the rationals: "t and each coordinate of the point are algebraic numbers x + y√Δ".
/// This is the form to read and to state properties with; DyadicSurd is the one to compute with in bulk.
#include <compare>

#include "durero/number/dyadic_surd.hpp"
#include "durero/number/rational.hpp"

namespace durero::number {

/// x + y√delta. Where the value is rational by sight (y = 0, or delta the square of a rational) the constructor makes
/// it the rational x with y = delta = 0, so y ≠ 0 exactly where the value is irrational.
struct Surd {
  Rational x, y, delta;  ///< the three numbers of x + y√delta

  Surd() = default;  ///< 0
  /// The rational.
  Surd(Rational value) : x(std::move(value)) {}
  Surd(double value) : x(exact(value)) {}  ///< Throws std::domain_error for an infinity or a NaN.
  /// The integer.
  Surd(int value) : x(value) {}
  /// Throws std::domain_error where delta < 0.
  Surd(Rational x, Rational y, Rational delta);
  /// The same number.
  explicit Surd(const DyadicSurd& value);

  /// −x − y√delta
  Surd operator-() const;
};

/// @{ Arithmetic inside one field: one operand is rational, or delta₁·delta₂ is the square of a rational (the result
/// then has the left operand's delta). Throws std::domain_error for operands of different fields, and for a division by
/// 0.
Surd operator+(const Surd& a, const Surd& b);
Surd operator-(const Surd& a, const Surd& b);
Surd operator*(const Surd& a, const Surd& b);
Surd operator/(const Surd& a, const Surd& b);
/// @}

/// The sign of x + y√a + z√b, exactly: −1, 0 or 1. Throws std::domain_error where a < 0 or b < 0.
int sign_of_sum(const Rational& x, const Rational& y, const Rational& a, const Rational& z, const Rational& b);

/// −1, 0 or 1, exactly.
int sign(const Surd& value);

/// Order of the values of any two surds, of whatever fields.
std::strong_ordering compare(const Surd& a, const Surd& b);
/// compare().
inline std::strong_ordering operator<=>(const Surd& a, const Surd& b) { return compare(a, b); }
/// Whether the values are equal, whatever their representation.
inline bool operator==(const Surd& a, const Surd& b) { return compare(a, b) == 0; }

/// The value rounded once to the nearest binary64, ties to even; overflow, subnormal results and zeros as
/// round_to_binary64 of a Rational.
double round_to_binary64(const Surd& value);

}  // namespace durero::number
