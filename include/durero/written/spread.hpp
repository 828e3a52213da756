#pragma once
/// The spread of a formula is how far it moves where numbers in it are off: to the first order by each of them, and a
/// bound on all that is of higher order.
///
/// Each error e of a number is between −1 and 1, and what it is times is the greatest amount by which the number is
/// off. A formula with a spread is f + Σ eᵢ·gᵢ + r, where the gᵢ are polynomials known to about 50 bits and r is a
/// polynomial each of whose coefficients is between two opposite numbers. In a product (f + Σ eᵢ·gᵢ + r)·(f' + Σ eᵢ·g'ᵢ
/// + r') the gᵢ become f·g'ᵢ + f'·gᵢ, so that errors that cancel to the first order do so here; r becomes the rest,
/// f·r' + f'·r + r·r' + Σᵢ Σⱼ eᵢ·eⱼ·gᵢ·g'ⱼ, with 1 for the magnitude of each eᵢ·eⱼ.

#include <array>
#include <cstdint>
#include <map>

#include "durero/number/ball.hpp"
#include "durero/number/rational.hpp"

namespace durero::written {

/// The exponents of x, y and z in a product.
using Exponents = std::array<std::uint8_t, 3>;
/// A polynomial in x, y and z whose coefficients are known to about 50 bits.
using RoughTerms = std::map<Exponents, number::RealBall>;
/// A polynomial in x, y and z by its coefficients, none of which is 0.
using ExactTerms = std::map<Exponents, number::Rational>;

/// How far a formula moves: Σ eᵢ·gᵢ + r.
class FormulaSpread {
 public:
  FormulaSpread() = default;  ///< nothing is off
  /// The spread of a number that is off by the error of that number, times an amount.
  FormulaSpread(std::size_t error, const number::Rational& amount);

  /// Whether nothing is off.
  bool is_none() const { return linear_.empty() && rest_.empty(); }
  /// Whether no coordinate stands in it.
  bool is_constant() const;
  /// The polynomials gᵢ, by the numbers of their errors.
  const std::map<std::size_t, RoughTerms>& linear() const { return linear_; }
  /// The polynomial r: its coefficients have the middle 0.
  const RoughTerms& rest() const { return rest_; }
  /// The greatest magnitude of the constant part.
  number::RealBall at_origin() const;

  /// @{ The spread of a sum, of a negated formula, and of a product of f and g.
  friend FormulaSpread operator+(const FormulaSpread& a, const FormulaSpread& b);
  FormulaSpread operator-() const;
  friend FormulaSpread of_product(const ExactTerms& f, const FormulaSpread& a, const ExactTerms& g,
                                  const FormulaSpread& b);
  /// @}
  bool operator==(const FormulaSpread& other) const;  ///< equal in every coefficient

 private:
  std::map<std::size_t, RoughTerms> linear_{};
  RoughTerms rest_{};
};

/// The numbers of the ball, and their opposites: 0 ± the greatest magnitude of one.
number::RealBall either_way(const number::RealBall& ball);

/// A rational number to about 50 bits.
number::RealBall roughly(const number::Rational& value);

}  // namespace durero::written
