#include "number/integers.hpp"

#include <algorithm>
#include <type_traits>

namespace durero::number {
namespace {

static_assert(std::is_same_v<mp_limb_t, std::uint64_t>, "GMP's limbs have 64 bits");

}  // namespace

Integer to_integer(const Dyadic::Significand& value) {
  Integer result;
  const auto& backend = value.backend();
  auto* data = result.backend().data();
  const auto size = static_cast<mp_size_t>(backend.size());
  std::copy_n(backend.limbs(), size, mpz_limbs_write(data, size));
  mpz_limbs_finish(data, value.sign() < 0 ? -size : size);
  return result;
}

Dyadic::Significand to_significand(const Integer& value) {
  Dyadic::Significand result;
  const auto* data = value.backend().data();
  const std::size_t size = mpz_size(data);
  if (size == 0) return result;
  auto& backend = result.backend();
  backend.resize(static_cast<unsigned>(size), static_cast<unsigned>(size));
  std::copy_n(mpz_limbs_read(data), size, backend.limbs());
  if (value.sign() < 0) backend.negate();
  return result;
}

Leading leading(const Integer& value) {
  const auto* data = value.backend().data();
  return leading_of_limbs(mpz_limbs_read(data), mpz_size(data), 0);
}

std::int64_t bit_count(const Integer& value) {
  return static_cast<std::int64_t>(mpz_sizeinbase(value.backend().data(), 2));
}

std::int64_t trailing_zeros(const Integer& value) {
  return static_cast<std::int64_t>(mpz_scan1(value.backend().data(), 0));
}

Division divided(const Integer& n, const Integer& d) {
  Division result;
  mpz_tdiv_qr(result.quotient.backend().data(), result.remainder.backend().data(), n.backend().data(),
              d.backend().data());
  return result;
}

IntegerRoot integer_root(const Integer& value) {
  IntegerRoot result;
  mpz_sqrtrem(result.root.backend().data(), result.remainder.backend().data(), value.backend().data());
  return result;
}

bool is_square(const Integer& value) { return mpz_perfect_square_p(value.backend().data()) != 0; }

Rational scaled(const Integer& significand, std::int64_t exponent) {
  Rational result = significand;
  auto* data = result.backend().data();
  if (exponent >= 0) {
    mpq_mul_2exp(data, data, static_cast<mp_bitcnt_t>(exponent));
  } else {
    mpq_div_2exp(data, data, static_cast<mp_bitcnt_t>(-exponent));
  }
  return result;
}

Rational fraction_of(double value) {
  Rational result;
  mpq_set_d(result.backend().data(), value);
  return result;
}

Limbs<2> root_of_limbs(const Limbs<4>& radicand) {
  Limbs<2> root;
  Limbs<4> remainder;
  mpn_sqrtrem(root.data(), remainder.data(), radicand.data(), 4);
  return root;
}

Limbs<3> quotient_of_limbs(const Limbs<4>& dividend, const Limbs<2>& divisor) {
  Limbs<3> quotient;
  Limbs<2> remainder;
  mpn_tdiv_qr(quotient.data(), remainder.data(), 0, dividend.data(), 4, divisor.data(), 2);
  return quotient;
}

}  // namespace durero::number
