#include "durero/model/quadratic.hpp"

namespace durero::model {

RationalQuadratic through(const Rational& at_minus_one, const Rational& at_zero, const Rational& at_one) {
  return {(at_one + at_minus_one) / 2 - at_zero, (at_one - at_minus_one) / 2, at_zero};
}

std::vector<Surd> roots(const RationalQuadratic& q) {
  if (q.a.is_zero()) return q.b.is_zero() ? std::vector<Surd>{} : std::vector<Surd>{Surd(Rational(-q.c / q.b))};
  const Rational discriminant = q.b * q.b - 4 * q.a * q.c, middle = -q.b / (2 * q.a);
  if (discriminant.sign() < 0) return {};
  if (discriminant.is_zero()) return {Surd(middle)};
  const Rational half_width = 1 / (2 * abs(q.a));
  return {Surd(middle, -half_width, discriminant), Surd(middle, half_width, discriminant)};
}

}  // namespace durero::model
