#pragma once
/// What the sources of this layer ask of integers without a bound, beyond arithmetic. integers.cpp answers by GMP; the
/// build as WebAssembly, which has no GMP, compiles another source in its place.
#include <array>
#include <cstdint>

#include "durero/number/dyadic.hpp"
#include "number/binary64.hpp"

namespace durero::number {

/// @{ Between the two libraries' integers, limb by limb.
Integer to_integer(const Dyadic::Significand& value);
Dyadic::Significand to_significand(const Integer& value);
/// @}

/// The bits of |value|. Precondition: value ≠ 0.
std::int64_t bit_count(const Integer& value);

/// The number of zeros below the lowest bit that is set. Precondition: value ≠ 0.
std::int64_t trailing_zeros(const Integer& value);

/// n = quotient·d + remainder, the quotient cut towards 0.
struct Division {
  Integer quotient, remainder;
};
/// Precondition: d ≠ 0.
Division divided(const Integer& n, const Integer& d);

/// value = root² + remainder with the greatest such root.
struct IntegerRoot {
  Integer root, remainder;
};
/// Precondition: value ≥ 0.
IntegerRoot integer_root(const Integer& value);

/// Whether it is the square of an integer.
bool is_square(const Integer& value);

/// significand·2^exponent in lowest terms.
Rational scaled(const Integer& significand, std::int64_t exponent);

/// The rational number that a finite binary64 denotes.
Rational fraction_of(double value);

/// Integers of a fixed size, 64 bits each, the least significant first.
template <std::size_t N>
using Limbs = std::array<std::uint64_t, N>;

/// ⌊√radicand⌋. Precondition: radicand ≥ 2²⁵⁴.
Limbs<2> root_of_limbs(const Limbs<4>& radicand);

/// ⌊dividend/divisor⌋. Precondition: divisor ≥ 2¹²⁷.
Limbs<3> quotient_of_limbs(const Limbs<4>& dividend, const Limbs<2>& divisor);

}  // namespace durero::number
