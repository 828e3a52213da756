#pragma once
/// Exact numbers as an answer tells them.

#include <string>

#include "durero/number/dyadic_surd.hpp"

namespace durero::web {

/// The significant digits of a number that are told.
inline constexpr int told_digits = 40;

/// The first significant digits of a number, truncated, in decimal; with `…` behind them where others follow that are
/// not all 0. From 10⁻⁷ to below 10⁴⁰ plain, elsewhere with an exponent: `1.25e-9`.
std::string digits_of(const number::DyadicSurd& value);

/// The number as x + y√delta, its digits, its rounding to binary64 in decimal and in hexadecimal, and the binary64 on
/// both sides of that: an object of JSON (docs/formats/call.md).
std::string exact_number(const number::DyadicSurd& value);

/// A fraction: `-7/3`, or `4`.
std::string fraction(const number::Dyadic& value);

/// About b − a, to more than ten digits; 0 where they are equal alone. Precondition: a ≤ b.
double distance_between(const number::DyadicSurd& a, const number::DyadicSurd& b);

}  // namespace durero::web
