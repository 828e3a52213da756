#include "plane_points.hpp"

#include <algorithm>

#include "turn.hpp"

namespace durero::io {

int PlanePoints::turn(Number a, Number b, Number c) const {
  ++decisions_;
  return io::turn(points_[a], points_[b], points_[c]);
}

bool PlanePoints::is_within_circle(Number a, Number b, Number c, Number d) const {
  ++decisions_;
  if (const int side = circle_side(points_[a], points_[b], points_[c], points_[d]); side != 0) return side > 0;
  const Number last = std::max({a, b, c, d}, [&](Number p, Number q) { return is_before(p, q); });
  if (last == d) return false;
  // The last corner lifts the plane of the three, at d by d's barycentric coordinate of that corner.
  if (last == a) return turn(d, b, c) > 0;
  return last == b ? turn(a, d, c) > 0 : turn(a, b, d) > 0;
}

}  // namespace durero::io
