#include "durero/surface/shape/cone.hpp"

#include <algorithm>
#include <cmath>

#include "surface/axial.hpp"

namespace durero::surface {

// Through the base's rim and the apex; where that is smaller than the ball on the base itself, the latter.
Ball ball(const scene::Cone& cone) {
  const double k = cone.proporcion, h = cone.altura;
  const double height = std::max(0.0, h * (1 - k * k) / 2);
  const double radius = std::max(h - height, std::sqrt(height * height + k * h * (k * h)));
  return ball_on_axis(cone.centro, cone.vector, height, radius);
}

Box box(const scene::Cone& c) { return box_of_discs(c.centro, c.vector, c.altura, c.proporcion * c.altura, 0); }

}  // namespace durero::surface
