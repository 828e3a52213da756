#include "durero/number/rational.hpp"

#include <cmath>
#include <stdexcept>

#include "durero/number/quotient.hpp"
#include "number/integers.hpp"

namespace durero::number {

Rational exact(double value) {
  if (!std::isfinite(value)) throw std::domain_error("an infinity or a NaN denotes no number");
  return fraction_of(value);
}

std::optional<Rational> rational_sqrt(const Rational& value) {
  // In lowest terms a fraction is a square exactly where its numerator and its denominator are.
  const Integer n = numerator(value);
  const Integer d = denominator(value);
  if (n.sign() < 0 || !is_square(n) || !is_square(d)) return std::nullopt;
  return Rational(boost::multiprecision::sqrt(n), boost::multiprecision::sqrt(d));
}

double round_to_binary64(const Rational& value) { return round_quotient(numerator(value), denominator(value)); }

}  // namespace durero::number
