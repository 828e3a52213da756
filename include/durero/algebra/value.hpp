#pragma once
/// Rational functions of a root: numbers that two polynomials and a root name. They are compared and rounded exactly,
/// so that a distance and the coordinates of a nearest point are, too.

#include <compare>
#include <variant>

#include "durero/algebra/root.hpp"

namespace durero::algebra {

/// numerator(α)/denominator(α) at a root α > 0. Precondition of every function on it: the denominator is not 0 there.
struct Fraction {
  Polynomial numerator;    ///< empty where it is the zero polynomial
  Polynomial denominator;  ///< not the zero polynomial
  Polynomial of;           ///< a polynomial that has the root, with which the denominator has no root in common
  Root at;                 ///< the root itself
};

/// A number: one of degree two or less, or a rational function of a root.
using Value = std::variant<number::DyadicSurd, Fraction>;

/// −1, 0 or 1, exactly.
int sign(const Value& value);

/// Order of the values, exactly. A strict total order on the numbers denoted.
std::strong_ordering compare(const Value& a, const Value& b);
/// The order of a value and a dyadic number.
std::strong_ordering compare(const Value& a, const number::Dyadic& b);

/// The value rounded once to the nearest binary64, ties to even; overflow, subnormal results and zeros as
/// number::round_to_binary64 of a Rational.
double round_to_binary64(const Value& value);

/// √value, rounded once in the same way. Precondition: the value is not negative.
double rounded_root(const Value& value);

/// Returns the same root in an interval whose length is 2⁻ᵇⁱᵗˢ of its high end at most.
Root refined(Root root, std::int64_t bits);

}  // namespace durero::algebra
