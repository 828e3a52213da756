#pragma once
/// The positive real roots of polynomials of any degree with dyadic coefficients: isolated, compared and rounded
/// exactly.
///
/// A root of degree two or less is a DyadicSurd, the house's own. Another is known by a polynomial and an interval with
/// dyadic ends in which that has no other root; FLINT computes with the polynomials.

#include <compare>
#include <memory>
#include <variant>
#include <vector>

#include "durero/number/dyadic_surd.hpp"

namespace durero::algebra {

/// c₀ + c₁t + c₂t² + …; the last coefficient is not 0, so that the zero polynomial has none.
using Polynomial = std::vector<number::Dyadic>;

/// Drops leading zeros.
void normalise(Polynomial& polynomial);

/// A primitive polynomial with integer coefficients, as FLINT holds it.
class IntegerPolynomial;

/// A number low < α < high, the one root of the polynomial in there, where that changes its sign. At both ends it is
/// not 0.
struct Isolated {
  std::shared_ptr<const IntegerPolynomial> polynomial;  ///< α is a root of it
  number::Dyadic low, high;                             ///< 0 ≤ low < high
  int sign_at_low;                                      ///< of the polynomial: −1 or 1
};

/// A positive real root.
using Root = std::variant<number::DyadicSurd, Isolated>;

/// Returns the roots t > 0, ascending, each once. Precondition: the polynomial is not 0.
std::vector<Root> positive_roots(const Polynomial& polynomial);

/// Returns the sign of the polynomial there: −1, 0 or 1, exactly.
int sign_at(const Polynomial& polynomial, const Root& root);
/// The same at a dyadic number.
int sign_at(const Polynomial& polynomial, const number::Dyadic& t);

/// Order of the values, exactly. A strict total order on the numbers denoted.
std::strong_ordering compare(const Root& a, const Root& b);

/// Returns a dyadic number low < t < high; precondition: low < high.
number::Dyadic between(const Root& low, const Root& high);
/// Returns a dyadic number 0 < t < high.
number::Dyadic below(const Root& high);
/// Returns a dyadic number t > low.
number::Dyadic above(const Root& low);

/// Returns m + n·root rounded once to the nearest binary64, ties to even; overflow, subnormal results and zeros as
/// number::round_to_binary64 of a Rational.
double rounded_linear(const number::Dyadic& m, const number::Dyadic& n, const Root& root);

}  // namespace durero::algebra
