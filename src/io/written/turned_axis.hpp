#pragma once
/// Directions as turns, which programs have that put shapes about +z elsewhere.

#include <cmath>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <numbers>

namespace durero::io {

/// The turn about an axis across +z that brings +z into a direction.
struct TurnedAxis {
  glm::dvec2 axis;  ///< x and y, of length 1
  double degrees;   ///< from 0 to 180
  bool is_exact;    ///< whether the direction is along an axis of space: by whole right angles
};

/// Precondition: the direction is not null.
inline TurnedAxis turned_axis(const glm::dvec3& v) {
  const double aside = std::hypot(v.x, v.y);
  if (aside == 0) return {{1, 0}, v.z < 0 ? 180.0 : 0.0, true};
  const double degrees = v.z == 0 ? 90 : std::atan2(aside, v.z) * 180 / std::numbers::pi;
  return {{-v.y / aside, v.x / aside}, degrees, v.z == 0 && (v.x == 0 || v.y == 0)};
}

}  // namespace durero::io
