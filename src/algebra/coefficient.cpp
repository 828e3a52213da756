/// The one passage from FLINT's integers to GMP's, which the build as WebAssembly has not.
#include "integer_polynomial.hpp"

namespace durero::algebra {

number::Integer IntegerPolynomial::coefficient(slong i) const {
  number::Integer found;
  fmpz_get_mpz(found.backend().data(), value_->coeffs + i);
  return found;
}

}  // namespace durero::algebra
