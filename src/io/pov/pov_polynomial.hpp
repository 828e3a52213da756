#pragma once
/// Polynomials in three coordinates, with rational coefficients: what POV-Ray's surfaces are the zeros of.

#include <array>
#include <map>
#include <vector>

#include "durero/number/rational.hpp"
#include "pov_transform.hpp"

namespace durero::io {

/// The powers of x, y and z in a term.
using PovPowers = std::array<int, 3>;

/// The powers of all terms up to a degree, in POV-Ray's order: they fall by those of x, then of y, then of z.
std::vector<PovPowers> pov_powers_up_to(int degree);

/// A polynomial, each of whose terms has a coefficient other than 0.
class PovPolynomial {
 public:
  /// No term: the polynomial 0.
  PovPolynomial() = default;
  /// A constant.
  PovPolynomial(const number::Rational& value) { add({}, value); }
  /// A constant. Precondition: it is finite.
  PovPolynomial(double value) : PovPolynomial(number::exact(value)) {}
  /// The coordinate of that number, 0 to 2.
  static PovPolynomial coordinate(std::size_t axis);

  const std::map<PovPowers, number::Rational>& terms() const noexcept { return terms_; }
  /// The coefficient of a term; 0 where it has none.
  number::Rational coefficient(const PovPowers& powers) const;
  int degree() const;
  /// Adds a term.
  void add(const PovPowers& powers, const number::Rational& coefficient);

  friend PovPolynomial operator+(const PovPolynomial& a, const PovPolynomial& b);
  friend PovPolynomial operator-(const PovPolynomial& a, const PovPolynomial& b);
  friend PovPolynomial operator*(const PovPolynomial& a, const PovPolynomial& b);
  bool operator==(const PovPolynomial&) const = default;

 private:
  std::map<PovPowers, number::Rational> terms_{};
};

/// The product of so many of it; 1 of none.
PovPolynomial power(const PovPolynomial& base, int exponent);
/// Whether another transformation undoes this one, exactly.
bool has_way_back(const PovTransform& by);
/// The polynomial whose value where a transformation puts a point is that of this one at the point. Precondition:
/// has_way_back(by).
PovPolynomial moved(const PovPolynomial& polynomial, const PovTransform& by);

}  // namespace durero::io
