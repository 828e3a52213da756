#include "integer_polynomial.hpp"

#include <algorithm>
#include <limits>

namespace durero::algebra {

using number::Dyadic;

Whole::Whole(const Dyadic::Significand& value) {
  fmpz_init(value_);
  const auto& limbs = value.backend();
  constexpr int limb_bits = std::numeric_limits<boost::multiprecision::limb_type>::digits;
  static_assert(limb_bits <= FLINT_BITS);
  for (std::size_t i = limbs.size(); i-- > 0;) {
    fmpz_mul_2exp(value_, value_, limb_bits);
    fmpz_add_ui(value_, value_, static_cast<ulong>(limbs.limbs()[i]));
  }
  if (value < 0) fmpz_neg(value_, value_);
}

IntegerPolynomial::IntegerPolynomial(const Polynomial& of) {
  fmpz_poly_init2(value_, static_cast<slong>(of.size()));
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  for (const Dyadic& each : of)
    if (number::sign(each) != 0) least = std::min(least, each.exponent());
  for (std::size_t i = 0; i < of.size(); ++i) {
    if (number::sign(of[i]) == 0) continue;
    Whole coefficient(of[i].significand());
    fmpz_mul_2exp(coefficient.get(), coefficient.get(), static_cast<ulong>(of[i].exponent() - least));
    fmpz_poly_set_coeff_fmpz(value_, static_cast<slong>(i), coefficient.get());
  }
  Whole content;  // not negative, unlike that of the primitive part, whose leading coefficient is positive
  fmpz_poly_content(content.get(), value_);
  if (!fmpz_is_zero(content.get())) fmpz_poly_scalar_divexact_fmpz(value_, value_, content.get());
}

// Horner's rule on integers: with t = m·2^e and e < 0 the value times 2^(−e·n) is Σ cᵢ·mⁱ·2^(−e·(n−i)).
int IntegerPolynomial::sign_at(const Dyadic& t) const {
  Whole m(t.significand()), sum, term;
  const bool is_fraction = t.exponent() < 0;
  const auto bits = static_cast<ulong>(is_fraction ? -t.exponent() : t.exponent());
  if (!is_fraction) fmpz_mul_2exp(m.get(), m.get(), bits);
  ulong shift = 0;
  for (slong i = degree(); i >= 0; --i) {
    fmpz_mul(sum.get(), sum.get(), m.get());
    fmpz_mul_2exp(term.get(), value_->coeffs + i, shift);
    fmpz_add(sum.get(), sum.get(), term.get());
    if (is_fraction) shift += bits;
  }
  return fmpz_sgn(sum.get());
}

IntegerPolynomial common_divisor(const IntegerPolynomial& a, const IntegerPolynomial& b) {
  IntegerPolynomial found;
  fmpz_poly_gcd(found.get(), a.get(), b.get());
  return found;
}

IntegerPolynomial without_repetition(const IntegerPolynomial& of) {
  IntegerPolynomial derivative;
  fmpz_poly_derivative(derivative.get(), of.get());
  const IntegerPolynomial repeated = common_divisor(of, derivative);
  if (repeated.degree() <= 0) return of;
  IntegerPolynomial once;
  fmpz_poly_div(once.get(), of.get(), repeated.get());  // exact: both are primitive
  return once;
}

}  // namespace durero::algebra
