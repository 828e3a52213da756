#include "durero/surface/shape/cylinder.hpp"

#include <cmath>

#include "surface/axial.hpp"

namespace durero::surface {

Ball ball(const scene::Cylinder& cylinder) {
  const double half = cylinder.altura / 2;
  return ball_on_axis(cylinder.centro, cylinder.vector, half, std::sqrt(cylinder.radio * cylinder.radio + half * half));
}

Box box(const scene::Cylinder& c) { return box_of_discs(c.centro, c.vector, c.altura, c.radio, c.radio); }

}  // namespace durero::surface
