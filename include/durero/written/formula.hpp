#pragma once
/// A formula is a polynomial in x, y and z over the rationals. A predicate over the coordinates of a point asks the
/// signs of formulas, once the attributes are known.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "durero/number/rational.hpp"
#include "durero/written/spread.hpp"

namespace durero::written {

/// A polynomial in x, y and z. Numbers in it may be off, and it then knows how far that moves it.
class Formula {
 public:
  /// The greatest degree of a formula.
  static constexpr int max_degree = 24;
  /// The most bits of a coefficient.
  static constexpr std::size_t max_bits = 1 << 16;

  Formula() = default;  ///< 0
  /// A constant.
  Formula(const number::Rational& value);
  /// A number that is off by `amount` at most; all that is made of it knows the error by its number.
  static Formula off_by(const number::Rational& value, std::size_t error, const number::Rational& amount);
  /// The coordinate x (0), y (1) or z (2).
  static Formula coordinate(std::size_t axis);

  /// The coefficients, none of which is 0, by their exponents.
  const ExactTerms& terms() const { return terms_; }
  /// How far errors move it.
  const FormulaSpread& spread() const { return spread_; }
  /// Whether no coordinate stands in it.
  bool is_constant() const;
  /// The constant term: the value, where it is constant.
  number::Rational constant() const;
  /// The sign of every number that it may be, where it is constant; nothing where these have several.
  std::optional<int> certain_sign() const;
  /// The greatest sum of exponents; 0 of a constant.
  int degree() const;
  /// The derivative by that coordinate. Precondition: nothing is off.
  Formula derivative(std::size_t axis) const;

  /// @{ Throws std::length_error where the result is beyond max_degree or max_bits.
  friend Formula operator+(const Formula& a, const Formula& b);
  friend Formula operator-(const Formula& a, const Formula& b);
  friend Formula operator*(const Formula& a, const Formula& b);
  /// @}
  bool operator==(const Formula&) const = default;

 private:
  void add(const Exponents& exponents, const number::Rational& coefficient);
  ExactTerms terms_;
  FormulaSpread spread_;
};

/// A set of the signs −1, 0 and 1.
struct Signs {
  bool negative = false, zero = false, positive = false;  ///< the signs in the set
  /// Whether this one is among them.
  bool contains(int sign) const { return sign < 0 ? negative : sign > 0 ? positive : zero; }
  bool operator==(const Signs&) const = default;
};

/// A predicate without quantifiers: comparisons of formulas with 0, joined.
struct Condition {
  /// The form of a condition.
  enum class Kind : std::uint8_t {
    constant,    ///< the value `truth`
    comparison,  ///< the sign of `formula` is among `signs`
    all,         ///< of `parts`, two or more
    any          ///< of `parts`, two or more
  };
  Kind kind = Kind::constant;      ///< says which members are in use
  bool truth = true;               ///< of a constant
  Formula formula{};               ///< not constant
  Signs signs{};                   ///< of a comparison
  std::vector<Condition> parts{};  ///< none of them a constant, nor of the same kind

  /// Whether the condition is known to hold everywhere, or nowhere.
  bool is(bool everywhere) const { return kind == Kind::constant && truth == everywhere; }
  /// Whether the condition is a comparison by =.
  bool is_equation() const { return kind == Kind::comparison && signs == Signs{false, true, false}; }
};

/// Makes a constant.
Condition always(bool truth);
/// Makes a comparison; a constant where the formula is one and its sign is certain.
Condition compared(Formula formula, Signs signs);
/// Whether the condition is true of the numbers as they are given, whatever they are off by. False where it depends on
/// coordinates.
bool holds_as_given(const Condition& of);
/// @{ Makes a connective of conditions.
Condition both(Condition a, Condition b);
Condition either(Condition a, Condition b);
Condition negated(const Condition& of);
/// @}

}  // namespace durero::written
