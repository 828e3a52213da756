#pragma once
/// Dyadic numbers m·2^e: what +, − and × make of binary64 numbers. Every coefficient of every quadratic of the tracer
/// is one, so it is computed without the common divisors that a Rational would look for.
///
/// The significand is Boost's own integer, not GMP's: with room for 512 bits inside the object the coefficients of a
/// quadratic need no heap, which measured twice as fast. It grows beyond that where the exponents ask for it.
#include <boost/multiprecision/cpp_int.hpp>
#include <compare>
#include <cstdint>

#include "durero/number/rational.hpp"

namespace durero::number {

/// The number significand · 2^exponent; 0 is 0 · 2⁰. What it is made of need not be in lowest terms.
class Dyadic {
 public:
  /// An integer without a bound, up to 512 bits without a heap.
  using Significand = boost::multiprecision::number<
      boost::multiprecision::cpp_int_backend<512, 0, boost::multiprecision::signed_magnitude,
                                             boost::multiprecision::unchecked,
                                             std::allocator<boost::multiprecision::limb_type>>,
      boost::multiprecision::et_off>;

  Dyadic() = default;  ///< 0
  /// The integer.
  Dyadic(int value) : Dyadic(static_cast<double>(value)) {}
  /// The number that a binary64 denotes. Throws std::domain_error for an infinity or a NaN.
  Dyadic(double value);
  /// significand · 2^exponent.
  Dyadic(Significand significand, std::int64_t exponent)
      : significand_(std::move(significand)), exponent_(significand_.is_zero() ? 0 : exponent) {}
  /// The same of an integer of GMP.
  Dyadic(const Integer& significand, std::int64_t exponent);

  /// The value is significand() · 2^exponent(). The significand need not be odd; 0 is 0 · 2⁰.
  const Significand& significand() const { return significand_; }
  /// See significand().
  std::int64_t exponent() const { return exponent_; }
  /// The same number as a fraction in lowest terms.
  Rational rational() const;

  /// @{ Exact: no result is rounded.
  Dyadic operator-() const { return {Significand(-significand_), exponent_}; }
  friend Dyadic operator+(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator*(const Dyadic& a, const Dyadic& b);
  Dyadic& operator+=(const Dyadic& b) { return *this = *this + b; }
  Dyadic& operator-=(const Dyadic& b) { return *this = *this - b; }
  Dyadic& operator*=(const Dyadic& b) { return *this = *this * b; }
  /// @}

  /// Order of the values, whatever their representation.
  friend std::strong_ordering operator<=>(const Dyadic& a, const Dyadic& b);
  /// Whether the values are equal, whatever their representation.
  friend bool operator==(const Dyadic& a, const Dyadic& b) { return (a <=> b) == 0; }

 private:
  Significand significand_ = 0;
  std::int64_t exponent_ = 0;
};

/// −1, 0 or 1.
inline int sign(const Dyadic& value) { return value.significand().sign(); }

/// value · 2^k.
inline Dyadic shifted(const Dyadic& value, std::int64_t k) { return {value.significand(), value.exponent() + k}; }

/// value².
inline Dyadic square(const Dyadic& value) { return value * value; }

/// ⌊log₂ |value|⌋. Precondition: value ≠ 0.
std::int64_t floor_log2(const Dyadic& value);

/// As round_to_binary64 of a Rational.
double round_to_binary64(const Dyadic& value);

}  // namespace durero::number
