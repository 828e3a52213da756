#include "durero/accel/direction_cube.hpp"

#include <algorithm>
#include <cmath>

namespace durero::accel {

CubePoint place_of(const glm::dvec3& direction) {
  int axis = 0;
  for (const int i : {1, 2})
    if (std::abs(direction[i]) > std::abs(direction[axis])) axis = i;
  const double size = std::abs(direction[axis]);
  return {static_cast<std::uint32_t>(2 * axis + (direction[axis] < 0 ? 1 : 0)), direction[(axis + 1) % 3] / size,
          direction[(axis + 2) % 3] / size};
}

glm::dvec3 direction_of(const CubePoint& place) {
  const int axis = static_cast<int>(place.face / 2);
  glm::dvec3 direction{};
  direction[axis] = place.face % 2 == 0 ? 1 : -1;
  direction[(axis + 1) % 3] = place.u;
  direction[(axis + 2) % 3] = place.v;
  return direction;
}

std::uint32_t quarter_of(const Square& square, const CubePoint& place) {
  const double half = square.side / 2;
  return (place.u < square.u + half ? 0U : 1U) + (place.v < square.v + half ? 0U : 2U);
}

Square quarter(const Square& square, std::uint32_t which) {
  const double half = square.side / 2;
  return {square.face, square.u + (which % 2 == 0 ? 0 : half), square.v + (which < 2 ? 0 : half), half};
}

// The directions within an angle below 90° of an axis are convex, so a cone that contains the corners' directions
// contains the pyramid. The angle of a whole face is arccos(1/√3).
DirectionCone cone_of(const Square& square, double more) {
  const auto at = [&](double du, double dv) {
    return direction(direction_of({square.face, square.u + du * square.side, square.v + dv * square.side}));
  };
  const glm::dvec3 middle = at(0.5, 0.5);
  double cosine = 1;
  for (const double du : {0, 1})
    for (const double dv : {0, 1}) cosine = std::min(cosine, cosine_between(middle, at(du, dv)));
  return cone(middle, cosine, more);
}

}  // namespace durero::accel
