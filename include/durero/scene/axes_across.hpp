#pragma once
/// Where angles about an axis count from: the text leaves it open, and all that draws a surface must agree.

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace durero::scene {

/// Two unit vectors that make a right-handed frame with an axis d.
struct AxesAcross {
  glm::dvec3 first;   ///< the direction of angle 0
  glm::dvec3 second;  ///< a quarter of a turn on, d × first
};

/// Angle 0 is along the axis of space that d has the least of, of equal ones the first, freed of its part along d.
/// Precondition: d is a unit vector.
inline AxesAcross axes_across(const glm::dvec3& d) {
  int least = 0;
  for (int i = 1; i < 3; ++i)
    if (std::abs(d[i]) < std::abs(d[least])) least = i;
  glm::dvec3 axis(0);
  axis[least] = 1;
  const glm::dvec3 first = glm::normalize(axis - d[least] * d);
  return {first, glm::cross(d, first)};
}

}  // namespace durero::scene
