#pragma once
/// What a power of points becomes along a line: a polynomial of degree at most two in the parameter.

#include <vector>

#include "durero/model/exact_point.hpp"

namespace durero::model {

/// a t² + b t + c
struct RationalQuadratic {
  Rational a, b, c;  ///< the coefficients

  /// Whether it is zero everywhere.
  bool is_zero() const { return a.is_zero() && b.is_zero() && c.is_zero(); }
};

/// The polynomial of degree at most two that takes these values at −1, 0 and 1.
RationalQuadratic through(const Rational& at_minus_one, const Rational& at_zero, const Rational& at_one);

/// The polynomial t ↦ f(p + t·v). Precondition: it has degree at most two, and p is rational.
template <class F>
RationalQuadratic restricted(F&& f, const ExactPoint& p, const ExactVector& v) {
  return through(f(along(p, v, -1)).x, f(p).x, f(along(p, v, 1)).x);
}

/// The real roots, ascending, each once. Precondition: not every coefficient is zero.
std::vector<Surd> roots(const RationalQuadratic& q);

}  // namespace durero::model
