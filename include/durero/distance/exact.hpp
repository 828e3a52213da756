#pragma once
/// The exact distance of a point from a shape as it is stored, and the nearest point. Every number is a surd or a
/// rational function of a root of a polynomial, and every decision is the sign of one. There is no tolerance.

#include <array>
#include <compare>

#include "durero/algebra/value.hpp"
#include "durero/scene/shape_view.hpp"

namespace durero::distance::exact {

/// The nearest point of a shape (cercanos.def.1).
struct Nearest {
  algebra::Value squared;               ///< of its distance (a_distancia.def.1)
  std::array<algebra::Value, 3> point;  ///< the first of the nearest points, by x, y, z (antes.def.1)
  bool many = false;                    ///< whether the shape has others that are as near
};

/// The nearest point of a shape.
Nearest nearest(scene::ShapeView shape, const glm::dvec3& p);

/// The order of two points by x, then by y, then by z (antes.def.1).
std::strong_ordering order(const std::array<algebra::Value, 3>& a, const std::array<algebra::Value, 3>& b);

/// Takes another nearest point beside those found so far: the nearer is kept, of points that are as near the first.
void take(Nearest& found, Nearest other);

}  // namespace durero::distance::exact
