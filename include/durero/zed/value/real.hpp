#pragma once
/// The evaluator of Z computes with exact reals: dyadics in a machine word's reach, numbers x + y√Δ over the rationals,
/// and square roots of those.
///
/// There are three forms. A stored number and the sums and products of a few of them fit in 127 bits, and a check of an
/// operation then needs no heap. A coordinate of an intersection is x + y√Δ. A distance between such points is the root
/// of one, which lies in a further field; it is only ever compared with another, and then their radicands are compared.

#include <compare>
#include <cstdint>
#include <memory>
#include <string>
#include <variant>

#include "durero/number/surd.hpp"

namespace durero::zed {

/// An exact real number, in one of these forms. Its operators compute and compare without rounding.
class Real {
 public:
  Real() : form_(Small{}) {}  ///< it is 0
  /// Makes the integer.
  Real(int value);
  /// Makes the number that a binary64 denotes. Throws std::domain_error for an infinity or a NaN.
  Real(double value);
  /// Makes the same number, as a small one where it fits.
  Real(number::Surd value);
  /// Makes a natural number from its decimal digits.
  static Real natural(const std::string& digits);

  /// Says whether it is a whole number, in whichever form.
  bool is_integer() const;
  /// Returns about how many machine words the number takes beyond two.
  std::size_t words() const;
  /// Says whether it is anything but the root of an irrational number.
  bool is_surd() const { return form_.index() != 2; }
  /// Returns the number as x + y√Δ. Precondition: is_surd().
  number::Surd surd() const;

  /// @{ Throws std::domain_error for numbers of different fields, and for a root r of an irrational number, of which
  /// there are only r + 0, 0 + r, r − 0, r − r, r · 0, 0 · r, and r · q with a root q of a number of the same field.
  friend Real operator+(const Real& a, const Real& b);
  friend Real operator-(const Real& a, const Real& b);
  friend Real operator*(const Real& a, const Real& b);
  /// @}
  /// Throws std::domain_error for a division by 0, for numbers of different fields and for roots of irrational ones.
  friend Real operator/(const Real& a, const Real& b);
  /// Throws std::domain_error for the root of an irrational number.
  Real operator-() const { return Real() - *this; }

  /// @{ Compares any two numbers exactly, of whatever forms and fields.
  friend std::strong_ordering operator<=>(const Real& a, const Real& b);
  friend bool operator==(const Real& a, const Real& b) { return (a <=> b) == 0; }
  /// @}
  /// Returns −1, 0 or 1.
  friend int sign(const Real& value);
  /// Returns the non-negative root. Throws std::domain_error where value < 0, or is itself the root of an
  /// irrational number.
  friend Real square_root(const Real& value);
  /// Returns ⌊a / b⌋ (div) of integers. Throws std::domain_error unless both are integers and b ≠ 0.
  friend Real integer_quotient(const Real& a, const Real& b);

  /// Writes the number as `-7`, `5/2`, `1/2+3/4*√5` or `√(1+2*√3)`.
  std::string text() const;

 private:
  /// A small number is (high, low)·2^exponent, where the significand is odd, or is zero with exponent 0, and
  /// |significand| < 2^126.
  struct Small {
    std::int64_t high = 0;
    std::uint64_t low = 0;
    std::int32_t exponent = 0;
    bool operator==(const Small&) const = default;
  };
  struct Root {
    number::Surd radicand;  ///< it is irrational and positive
  };
  using Big = std::shared_ptr<const number::Surd>;
  using Rooted = std::shared_ptr<const Root>;
  friend struct SmallArithmetic;

  /// Returns the number as a surd: in place where it is one, else made in `room`. Precondition: is_surd().
  const number::Surd& surd(number::Surd& room) const;
  explicit Real(Small value) : form_(value) {}
  std::variant<Small, Big, Rooted> form_;
};

}  // namespace durero::zed
