#include "durero/number/dyadic.hpp"

#include <bit>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "number/binary64.hpp"
#include "number/integers.hpp"

namespace durero::number {
namespace {

using Significand = Dyadic::Significand;

/// a ± b, brought to the lower of the two exponents.
template <class Combine>
Dyadic aligned(const Dyadic& a, const Dyadic& b, Combine combine) {
  const std::int64_t shift = a.exponent() - b.exponent();
  if (shift == 0) return {combine(a.significand(), b.significand()), a.exponent()};
  if (shift > 0) return {combine(Significand(a.significand() << shift), b.significand()), b.exponent()};
  return {combine(a.significand(), Significand(b.significand() << -shift)), a.exponent()};
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

Rational Dyadic::rational() const {
  Rational result = to_integer(significand_);
  auto* data = result.backend().data();
  if (exponent_ >= 0) {
    mpq_mul_2exp(data, data, static_cast<mp_bitcnt_t>(exponent_));
  } else {
    mpq_div_2exp(data, data, static_cast<mp_bitcnt_t>(-exponent_));
  }
  return result;
}

Dyadic operator+(const Dyadic& a, const Dyadic& b) {
  // An exponent of 0 says nothing where the value is 0, and aligning to it could cost thousands of bits.
  if (sign(a) == 0) return b;
  if (sign(b) == 0) return a;
  return aligned(a, b, [](const Significand& m, const Significand& n) { return Significand(m + n); });
}

Dyadic operator-(const Dyadic& a, const Dyadic& b) {
  if (sign(a) == 0) return -b;
  if (sign(b) == 0) return a;
  return aligned(a, b, [](const Significand& m, const Significand& n) { return Significand(m - n); });
}

Dyadic operator*(const Dyadic& a, const Dyadic& b) {
  return {Significand(a.significand_ * b.significand_), a.exponent_ + b.exponent_};
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
