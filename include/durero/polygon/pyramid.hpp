#pragma once
/// A pyramid is what lies behind or before a polygon as it is seen from a point, its apex.

#include <optional>
#include <vector>

#include "durero/polygon/convex.hpp"

namespace durero::polygon {

/// A point that polygons are seen from, or a direction, from without end.
struct Apex {
  RationalPoint at;  ///< the point; far: a vector towards it, not null
  bool far = false;  ///< whether it lies without end in that direction

  /// How far the apex lies inside of a half-space; of a far one only the sign has a meaning.
  Rational depth_in(const PlaneSide& half) const { return dot(half.normal, at) - (far ? Rational(0) : half.offset); }
};

/// The half-space on the side of the apex of a polygon's plane; nothing where the apex lies in that plane.
std::optional<PlaneSide> side_of(const Apex& apex, const Polygon& polygon);

/// The half-spaces whose intersection is the pyramid: all points that lie on a line with the apex and a point of the
/// polygon, on the same side of the apex. One for each edge; none where the apex lies in the polygon's plane, since the
/// pyramid has no volume then.
std::vector<PlaneSide> pyramid(const Apex& apex, const Polygon& polygon);

/// The half-spaces whose intersection is the part of the pyramid that the polygon hides from its apex, the polygon
/// included; none where the pyramid has no volume. The last one is the side of its plane.
std::vector<PlaneSide> hidden(const Apex& apex, const Polygon& polygon);

/// The projection from the apex of a point on the boundary of a half-space: where the ray from the apex through the
/// point meets the plane. Nothing where it does not meet it, or everywhere.
std::optional<RationalPoint> projected(const Apex& apex, const RationalPoint& w, const PlaneSide& plane);

}  // namespace durero::polygon
