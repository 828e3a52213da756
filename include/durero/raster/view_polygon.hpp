#pragma once
/// A polygon as an eye sees it: which directions meet it, and how far away.

#include <glm/vec3.hpp>
#include <vector>

#include "durero/polygon/convex.hpp"

namespace durero::raster {

/// A linear form of a direction, whose sign is decided by binary64 where its bound allows, and else exactly.
class DirectionForm {
 public:
  /// The form with those coefficients.
  explicit DirectionForm(polygon::RationalPoint coefficients);

  /// The sign of the form at a direction.
  int sign(const glm::dvec3& direction) const;
  /// The value, in binary64; `error` receives a bound on what is wrong with it.
  double value(const glm::dvec3& direction, double& error) const;
  /// The coefficients.
  const polygon::RationalPoint& exact() const { return exact_; }

 private:
  polygon::RationalPoint exact_;
  glm::dvec3 rounded_;
};

/// A polygon as it is seen from a point. It is seen from both sides, edges included, and edge-on not at all.
class ViewPolygon {
 public:
  /// The polygon with those corners, as that eye sees it.
  ViewPolygon(const polygon::Polygon& corners, const glm::dvec3& eye);

  /// Whether a ray from the eye meets the polygon.
  bool is_met(const glm::dvec3& direction) const;
  /// The parameter at which the ray meets the plane of the polygon, in binary64. Precondition: is_met().
  double parameter(const glm::dvec3& direction) const;
  /// Whether the ray meets the plane of this polygon before that of another one. Precondition: it meets both.
  bool is_before(const ViewPolygon& other, const glm::dvec3& direction) const;
  /// Whether the polygon is seen edge-on.
  bool is_edge_on() const { return edges_.empty(); }

 private:
  std::vector<DirectionForm> edges_;  // each not negative within
  DirectionForm nearness_;            // one over the parameter
};

}  // namespace durero::raster
