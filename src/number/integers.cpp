#include "number/integers.hpp"

#include <algorithm>

namespace durero::number {

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

}  // namespace durero::number
