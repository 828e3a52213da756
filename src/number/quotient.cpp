#include "durero/number/quotient.hpp"

#include "number/binary64.hpp"
#include "number/integers.hpp"

namespace durero::number {
namespace {

/// |n/d| · 2^exponent, cut after at least 65 bits. Precondition: neither is 0.
Leading leading_quotient(const Integer& n, const Integer& d, std::int64_t exponent) {
  // n · 2^shift has at least 65 bits more than d, so the quotient has at least 65; where n is longer by itself it
  // stays.
  const std::int64_t shift = std::max<std::int64_t>(0, 65 + bit_count(d) - bit_count(n));
  Integer dividend = n;
  dividend <<= shift;
  const auto [quotient, remainder] = divided(dividend, d);
  Leading result = leading(quotient);
  result.exponent += exponent - shift;
  result.inexact = result.inexact || !remainder.is_zero();
  return result;
}

}  // namespace

double round_quotient(const Integer& n, const Integer& d) {
  if (n.is_zero()) return 0.0;
  return round_to_binary64((n.sign() < 0) != (d.sign() < 0), leading_quotient(n, d, 0));
}

double round_quotient(const Dyadic& n, const Dyadic& d) {
  if (sign(n) == 0) return 0.0;
  const Leading magnitude =
      leading_quotient(to_integer(n.significand()), to_integer(d.significand()), n.exponent() - d.exponent());
  return round_to_binary64(sign(n) != sign(d), magnitude);
}

SquareRoot square_root(const Dyadic& of, std::int64_t bits) {
  Integer significand = to_integer(of.significand());
  // Cut or extend to 2·bits or 2·bits + 1 bits, whichever leaves an even exponent.
  std::int64_t shift = 2 * bits - bit_count(significand);
  if ((of.exponent() - shift) % 2 != 0) ++shift;
  bool exact = true;
  if (shift >= 0) {
    significand <<= shift;
  } else {
    exact = trailing_zeros(significand) >= -shift;
    significand >>= -shift;
  }
  const auto [root, remainder] = integer_root(significand);
  const std::int64_t exponent = (of.exponent() - shift) / 2;
  return {Dyadic(root, exponent), Dyadic(Integer(1), exponent), exact && remainder.is_zero()};
}

}  // namespace durero::number
