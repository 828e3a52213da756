#pragma once
/// Points of a plane by their numbers, and the decisions that a triangulation of them takes.

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <utility>
#include <vector>

namespace durero::io {

/// The points and how often they were asked how they lie. Precondition of all: finite coordinates.
class PlanePoints {
 public:
  using Number = std::uint32_t;  ///< of a point, from 0

  explicit PlanePoints(std::vector<glm::dvec2> points) : points_(std::move(points)) {}

  std::size_t size() const noexcept { return points_.size(); }
  /// The order of the points: by the first coordinate, then by the second.
  bool is_before(Number a, Number b) const { return order(a) < order(b); }
  bool are_one(Number a, Number b) const { return points_[a] == points_[b]; }
  /// See turn.hpp.
  int turn(Number a, Number b, Number c) const;
  /// True where d lies inside the circle through a, b and c. The points of one circle lie as if each were lifted off
  /// the paraboloid, by a height without a size, far more than all that are before it: the last of four is outside the
  /// circle of the others. So no two triangulations of different edges are both Delaunay's. Precondition: a → b → c
  /// goes left, and d is none of them.
  bool is_within_circle(Number a, Number b, Number c, Number d) const;

  std::uint64_t decisions() const noexcept { return decisions_; }

 private:
  std::pair<double, double> order(Number a) const { return {points_[a].x, points_[a].y}; }

  std::vector<glm::dvec2> points_;
  mutable std::uint64_t decisions_ = 0;
};

}  // namespace durero::io
