#pragma once
/// Roots of polynomials whose coefficients are known to about 50 bits: whether there may be some.

#include <vector>

#include "durero/number/ball.hpp"
#include "durero/written/surface.hpp"

namespace durero::written {

/// The ball itself, with a middle and a radius of 1 at most: a formula of any depth stays within what RealBall asks of
/// it.
number::RealBall brought_back(const number::RealBall& ball);
/// An exact number, which is within it as it is.
inline const number::Dyadic& brought_back(const number::Dyadic& value) { return value; }

/// c₀ + c₁t + c₂t² + …
using RoughPolynomial = std::vector<number::RealBall>;

/// Whether a polynomial may have a root on that part of a ray. False is certain.
bool may_have_root(const RoughPolynomial& polynomial, RayPart part);

}  // namespace durero::written
