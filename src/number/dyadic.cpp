#include "durero/number/dyadic.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "number/binary64.hpp"
#include "number/integers.hpp"

namespace durero::number {
namespace {

using Significand = Dyadic::Significand;

/// An integer of two limbs, which the processor adds and multiplies itself: what leads to the coefficients of ordinary
/// quadratics is within it, and Boost's way for any size takes more steps.
using Narrow = boost::multiprecision::signed_double_limb_type;
static_assert(sizeof(Narrow) == 2 * sizeof(std::uint64_t));
constexpr int narrow_bits = 126;  // so the sum of two magnitudes of so many bits is less than 2¹²⁷

/// The bits of |m| where they are few enough, otherwise more.
int bits(const Significand& m) {
  const auto& backend = m.backend();
  const auto size = static_cast<int>(backend.size());
  return size > 2 ? narrow_bits + 1 : 64 * size - std::countl_zero(std::uint64_t{backend.limbs()[size - 1]});
}

/// Precondition: bits(m) ≤ narrow_bits.
Narrow narrow(const Significand& m) {
  const auto& backend = m.backend();
  Narrow magnitude = backend.limbs()[0];
  if (backend.size() == 2) magnitude |= static_cast<Narrow>(backend.limbs()[1]) << 64;
  return backend.sign() ? -magnitude : magnitude;
}

/// m·n of two limbs each, by schoolbook: such as the square of what is hardly narrow.
/// Precondition: neither has more limbs.
Significand product_of_pairs(const Significand& m, const Significand& n) {
  using Double = boost::multiprecision::double_limb_type;
  const auto limb = [](const Significand& of, unsigned i) -> Double {
    return i < of.backend().size() ? of.backend().limbs()[i] : 0;
  };
  const auto low = [](Double x) { return static_cast<std::uint64_t>(x); };
  const Double m0 = limb(m, 0), m1 = limb(m, 1), n0 = limb(n, 0), n1 = limb(n, 1);
  // (2⁶⁴ − 1)² + 2·(2⁶⁴ − 1) < 2¹²⁸, so no sum overflows.
  const Double first = m0 * n0, a = m0 * n1 + (first >> 64), b = m1 * n0 + low(a);
  const Double last = m1 * n1 + (a >> 64) + (b >> 64);
  Significand product;
  auto& backend = product.backend();
  backend.resize(4, 4);
  backend.limbs()[0] = low(first);
  backend.limbs()[1] = low(b);
  backend.limbs()[2] = low(last);
  backend.limbs()[3] = low(last >> 64);
  backend.normalize();
  backend.sign(m.backend().sign() != n.backend().sign());
  return product;
}

/// a ± b, brought to the lower of the two exponents.
template <class Combine>
Dyadic aligned(const Dyadic& a, const Dyadic& b, Combine combine) {
  const std::int64_t shift = a.exponent() - b.exponent(), of_a = std::max<std::int64_t>(shift, 0), of_b = of_a - shift;
  const std::int64_t lower = std::min(a.exponent(), b.exponent());
  const Significand &m = a.significand(), &n = b.significand();
  if (bits(m) + of_a <= narrow_bits && bits(n) + of_b <= narrow_bits)
    return {Significand(combine(narrow(m) * (Narrow{1} << of_a), narrow(n) * (Narrow{1} << of_b))), lower};
  if (shift == 0) return {Significand(combine(m, n)), lower};
  return {Significand(of_a > 0 ? combine(Significand(m << of_a), n) : combine(m, Significand(n << of_b))), lower};
}

}  // namespace

Dyadic::Dyadic(double value) {
  if (!std::isfinite(value)) throw std::domain_error("an infinity or a NaN denotes no number");
  if (value == 0) return;
  // value = ±fraction · 2^(biased − 1075), the leading bit of the fraction hidden unless it is subnormal.
  const auto raw = std::bit_cast<std::uint64_t>(value);
  auto fraction = static_cast<std::int64_t>(raw & ((std::uint64_t{1} << 52) - 1));
  auto biased = static_cast<std::int64_t>(raw >> 52 & 0x7ff);
  if (biased == 0) {
    biased = 1;
  } else {
    fraction |= std::int64_t{1} << 52;
  }
  const int zeros = std::countr_zero(static_cast<std::uint64_t>(fraction));
  significand_ = (value < 0 ? -fraction : fraction) >> zeros;
  exponent_ = biased - 1075 + zeros;
}

Dyadic::Dyadic(const Integer& significand, std::int64_t exponent) : Dyadic(to_significand(significand), exponent) {}

Rational Dyadic::rational() const { return scaled(to_integer(significand_), exponent_); }

Dyadic operator+(const Dyadic& a, const Dyadic& b) {
  // An exponent of 0 says nothing where the value is 0, and aligning to it could cost thousands of bits.
  if (sign(a) == 0) return b;
  if (sign(b) == 0) return a;
  return aligned(a, b, [](const auto& m, const auto& n) { return m + n; });
}

Dyadic operator-(const Dyadic& a, const Dyadic& b) {
  if (sign(a) == 0) return -b;
  if (sign(b) == 0) return a;
  return aligned(a, b, [](const auto& m, const auto& n) { return m - n; });
}

Dyadic operator*(const Dyadic& a, const Dyadic& b) {
  const Significand &m = a.significand_, &n = b.significand_;
  if (bits(m) + bits(n) <= narrow_bits) return {Significand(narrow(m) * narrow(n)), a.exponent_ + b.exponent_};
  const bool are_pairs = m.backend().size() <= 2 && n.backend().size() <= 2;
  return {are_pairs ? product_of_pairs(m, n) : Significand(m * n), a.exponent_ + b.exponent_};
}

std::strong_ordering operator<=>(const Dyadic& a, const Dyadic& b) {
  const int of_a = sign(a);
  const int of_b = sign(b);
  if (of_a != of_b || of_a == 0) return of_a <=> of_b;
  if (const auto magnitudes = floor_log2(a) <=> floor_log2(b); magnitudes != 0) {
    return of_a > 0 ? magnitudes : 0 <=> magnitudes;
  }
  return sign(a - b) <=> 0;
}

std::int64_t floor_log2(const Dyadic& value) {
  const auto& backend = value.significand().backend();
  const auto size = static_cast<std::int64_t>(backend.size());
  return value.exponent() + 64 * size - 1 - std::countl_zero(std::uint64_t{backend.limbs()[size - 1]});
}

double round_to_binary64(const Dyadic& value) {
  return sign(value) == 0 ? 0.0 : round_to_binary64(sign(value) < 0, leading(value));
}

}  // namespace durero::number
