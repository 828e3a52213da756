// In the place of src/number/integers.cpp: the same of Boost's integers.
#include "number/integers.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace durero::number {
namespace {

// Both integers are magnitudes with a sign, of the same limbs.
template <class To, class From>
To with_limbs_of(const From& value) {
  To result;
  const auto& from = value.backend();
  auto& to = result.backend();
  to.resize(static_cast<unsigned>(from.size()), static_cast<unsigned>(from.size()));
  std::copy_n(from.limbs(), from.size(), to.limbs());
  to.normalize();
  if (value.sign() < 0) to.negate();
  return result;
}

Integer magnitude(const Integer& value) { return value.sign() < 0 ? Integer(-value) : value; }

template <std::size_t N>
Integer integer_of(const Limbs<N>& limbs) {
  Integer value;
  auto& backend = value.backend();
  backend.resize(N, N);
  std::ranges::copy(limbs, backend.limbs());
  backend.normalize();
  return value;
}

template <std::size_t N>
Limbs<N> limbs_of(const Integer& value) {
  Limbs<N> limbs{};
  std::copy_n(value.backend().limbs(), value.backend().size(), limbs.begin());
  return limbs;
}

}  // namespace

Integer to_integer(const Dyadic::Significand& value) { return with_limbs_of<Integer>(value); }
Dyadic::Significand to_significand(const Integer& value) { return with_limbs_of<Dyadic::Significand>(value); }

Leading leading(const Integer& value) { return leading_of_limbs(value.backend().limbs(), value.backend().size(), 0); }

std::int64_t bit_count(const Integer& value) {
  return value.is_zero() ? 1 : static_cast<std::int64_t>(msb(magnitude(value))) + 1;
}

std::int64_t trailing_zeros(const Integer& value) { return static_cast<std::int64_t>(lsb(magnitude(value))); }

Division divided(const Integer& n, const Integer& d) {
  Division result;
  divide_qr(n, d, result.quotient, result.remainder);
  return result;
}

// Newton's steps from above fall until they reach the root, cut: the first that does not fall is behind it. Of a number
// of more than 106 bits the root of its upper half comes first, with a unit more, so that the start is above the root
// and a step or two reach it; a shorter number's is within a unit or two of the processor's.
IntegerRoot integer_root(const Integer& value) {
  if (value.is_zero()) return {};
  const std::int64_t bits = bit_count(value);
  Integer root;
  if (bits <= 106) {
    root = Integer(std::ceil(std::sqrt(value.convert_to<double>()))) + 2;
  } else {
    const auto cut = static_cast<unsigned>(bits / 4);
    root = (integer_root(Integer(value >> (2 * cut))).root + 1) << cut;
  }
  for (;;) {
    Integer next = (root + value / root) >> 1;
    if (next >= root) break;
    root = std::move(next);
  }
  Integer remainder = value - root * root;
  return {std::move(root), std::move(remainder)};
}

bool is_square(const Integer& value) { return value.sign() >= 0 && integer_root(value).remainder.is_zero(); }

Rational scaled(const Integer& significand, std::int64_t exponent) {
  if (exponent >= 0) return Rational(Integer(significand << static_cast<unsigned>(exponent)));
  return Rational(significand, Integer(Integer(1) << static_cast<unsigned>(-exponent)));
}

Rational fraction_of(double value) {
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  return scaled(Integer(static_cast<std::int64_t>(std::ldexp(fraction, 53))), exponent - 53);
}

Limbs<2> root_of_limbs(const Limbs<4>& radicand) { return limbs_of<2>(integer_root(integer_of(radicand)).root); }

Limbs<3> quotient_of_limbs(const Limbs<4>& dividend, const Limbs<2>& divisor) {
  return limbs_of<3>(Integer(integer_of(dividend) / integer_of(divisor)));
}

}  // namespace durero::number
