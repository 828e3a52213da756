#pragma once
/// A convex polygon of rational points in space is cut by planes exactly: kept, split, or taken away from.

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "durero/number/rational.hpp"

namespace durero::polygon {

using number::Rational;

/// A point of space, or a vector.
struct RationalPoint {
  Rational x, y, z;  ///< the coordinates
  bool operator==(const RationalPoint&) const = default;
};

/// The point that a stored one denotes.
RationalPoint exact(const glm::dvec3& point);

/// The nearest point whose coordinates are stored.
glm::dvec3 rounded(const RationalPoint& point);

/// @{ Vector arithmetic.
RationalPoint operator+(const RationalPoint& a, const RationalPoint& b);
RationalPoint operator-(const RationalPoint& a, const RationalPoint& b);
RationalPoint operator*(const Rational& s, const RationalPoint& a);
Rational dot(const RationalPoint& a, const RationalPoint& b);
RationalPoint cross(const RationalPoint& a, const RationalPoint& b);
/// @}

/// A closed half-space { w | normal·w ≥ offset }.
struct PlaneSide {
  RationalPoint normal;  ///< not the null vector; it points inwards
  Rational offset;       ///< of the plane normal·w = offset

  /// How far w lies inside, in lengths of the normal; negative outside, 0 on the plane.
  Rational depth(const RationalPoint& w) const { return dot(normal, w) - offset; }
};

/// The half-space on the other side of the same plane.
PlaneSide opposite(const PlaneSide& half);

/// The corners of a flat convex polygon with an area, one way around; it contains its inside and its edges. Without
/// corners it is empty.
using Polygon = std::vector<RationalPoint>;

/// Twice the area of a polygon, as a vector across it: of coplanar polygons that go the same way around it adds up.
RationalPoint doubled_area(const Polygon& polygon);

/// Whether a point of its plane lies in a polygon.
bool contains(const Polygon& polygon, const RationalPoint& w);

/// The two parts of a polygon that a plane cuts. A part without an area is empty.
struct PolygonParts {
  Polygon inside;   ///< the part within the half-space
  Polygon outside;  ///< the part within the opposite one
};
/// The parts of a polygon within a half-space and without it.
PolygonParts split(const Polygon& polygon, const PlaneSide& half);

/// The part of a polygon within all of some half-spaces; empty where it has no area.
Polygon clipped(Polygon polygon, std::span<const PlaneSide> body);

/// The part of a polygon outside of a body, the intersection of half-spaces, as polygons that share no area with each
/// other. Where the body takes nothing of it, the polygon itself.
std::vector<Polygon> without(const Polygon& polygon, std::span<const PlaneSide> body);

}  // namespace durero::polygon
