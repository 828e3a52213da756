#pragma once
/// Polygons for the tests of this layer.

#include <rapidcheck.h>

#include <ostream>

#include "durero/polygon/convex.hpp"

namespace durero::test {

/// A square across z around (x, y, z), with sides of 2·half.
inline polygon::Polygon square_at(const polygon::Rational& x, const polygon::Rational& y, const polygon::Rational& half,
                                  const polygon::Rational& z = 0) {
  return {{x - half, y - half, z}, {x + half, y - half, z}, {x + half, y + half, z}, {x - half, y + half, z}};
}

/// A point of the grid.
inline rc::Gen<polygon::RationalPoint> any_corner() {
  const auto number = rc::gen::inRange(-6, 7);
  return rc::gen::apply([](int x, int y, int z) { return polygon::RationalPoint{x, y, z}; }, number, number, number);
}

/// A triangle with an area, of such corners.
inline rc::Gen<polygon::Polygon> any_triangle() {
  return rc::gen::suchThat(
      rc::gen::apply(
          [](const polygon::RationalPoint& a, const polygon::RationalPoint& b, const polygon::RationalPoint& c) {
            return polygon::Polygon{a, b, c};
          },
          any_corner(), any_corner(), any_corner()),
      [](const polygon::Polygon& triangle) { return polygon::doubled_area(triangle) != polygon::RationalPoint{}; });
}

}  // namespace durero::test

namespace durero::polygon {

inline std::ostream& operator<<(std::ostream& out, const RationalPoint& p) {
  return out << '(' << p.x << ", " << p.y << ", " << p.z << ')';
}

}  // namespace durero::polygon
