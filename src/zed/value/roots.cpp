#include "durero/zed/value/roots.hpp"

#include <algorithm>

namespace durero::zed {
namespace {

using number::Integer;
using number::Rational;
using number::Surd;

bool is_rational(const Real& value) { return value.is_surd() && value.surd().y.is_zero(); }

Real real_of(const Integer& value) { return Real(Surd(Rational(value))); }

}  // namespace

Integer floor_of(const Real& value) {
  Integer low = -1, high = 1;
  while (real_of(low) > value) low *= 2;
  while (real_of(high) <= value) high *= 2;
  while (high - low > 1) {  // low ≤ value < high
    Integer middle = (low + high) / 2;
    if (middle <= low) middle = low + 1;
    (real_of(middle) <= value ? low : high) = middle;
  }
  return low;
}

std::optional<Cuts> roots(std::span<const Polynomial> polynomials) {
  Cuts cuts;
  for (const Polynomial& polynomial : polynomials) {
    if (sign(polynomial.square) == 0) {
      if (sign(polynomial.slope) == 0) continue;
      cuts.push_back((Real() - polynomial.constant) / polynomial.slope);
      continue;
    }
    if (!is_rational(polynomial.constant) || !is_rational(polynomial.slope) || !is_rational(polynomial.square))
      return std::nullopt;
    const Rational c = polynomial.constant.surd().x, b = polynomial.slope.surd().x, a = polynomial.square.surd().x;
    const Rational discriminant = b * b - 4 * a * c;
    if (discriminant < 0) continue;
    const Rational radicand = discriminant / (4 * a * a);
    for (const int side : {-1, 1}) cuts.emplace_back(Surd(Rational(-b / (2 * a)), side, radicand));
  }
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  return cuts;
}

Real below(const Real& high) { return real_of(floor_of(high) - 1); }
Real above(const Real& low) { return real_of(floor_of(low) + 1); }

Real between(const Real& low, const Real& high) {
  Rational from = floor_of(low), to = floor_of(high) + 1;
  for (;;) {
    const Rational middle = (from + to) / 2;
    const Real here{Surd(middle)};
    if (here <= low) {
      from = middle;
    } else if (here >= high) {
      to = middle;
    } else {
      return here;
    }
  }
}

}  // namespace durero::zed
