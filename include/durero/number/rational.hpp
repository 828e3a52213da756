#pragma once
/// Exact rational numbers, and their one way back to binary64.
#include <boost/multiprecision/gmp.hpp>
#include <optional>

namespace durero::number {

/// An integer without a bound, by GMP.
using Integer = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;
/// A fraction of such integers in lowest terms, by GMP.
using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;

/// The rational number that a binary64 denotes ("Every stored number is a binary64, and denotes exactly the rational
/// number that it is"; both zeros denote 0). Throws std::domain_error for an infinity or a NaN, which denote none.
Rational exact(double value);

/// −1, 0 or 1.
inline int sign(const Rational& value) { return value.sign(); }

/// The non-negative root, where it is rational.
std::optional<Rational> rational_sqrt(const Rational& value);

/// The nearest binary64, ties to even, by the rule of IEEE 754: subnormal results are rounded once, at 2⁻¹⁰⁷⁴;
/// |value| ≥ 2¹⁰²⁴ − 2⁹⁷⁰ gives an infinity; a value too small to be other than a zero gives the zero of its sign.
/// 0 gives +0.
double round_to_binary64(const Rational& value);

}  // namespace durero::number
