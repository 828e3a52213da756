#include <cmath>

#include "conform/families/recipes.hpp"

namespace durero::conform::recipes {

/// A plane or two, and up to two other elements.
FramedShapes with_plane(Draws& random, int) {
  FramedShapes shapes;
  for (int left = random.integer(1, 2); left > 0; --left)
    shapes.push_back(any_shape(random, any_unbounded_type(random)));
  for (int left = random.integer(0, 2); left > 0; --left) shapes.push_back(any_shape(random, any_type(random)));
  return shapes;
}

DrawnRay flat(Draws& random, int log2_distance, ShapeSpan shapes) {
  const FramedShape& plane = shapes.front();
  const FramedPoint at = surface_point(random, plane);
  const glm::dvec3 w = any_vector(random, plane);
  DrawnRay ray = arriving(random, at.position, w, steps(w, plane.radius(), log2_distance));
  if (!random.chance(1, 6)) return ray;
  ray.p = at.position;  // from the plane, on it or nearly
  if (plane.lattice || random.chance(1, 2)) ray.on.push_back(0);
  return ray;
}

DrawnRay grazing(Draws& random, int minus_log2_angle, ShapeSpan shapes) {
  const FramedShape& plane = shapes.front();
  FramedPoint at = surface_point(random, plane);
  glm::dvec3 w = tangent_vector(random, at);
  if (random.chance(1, 2)) {
    w += std::ldexp(1, -minus_log2_angle) / steps(w, 1, 0) * plane.d;
  } else if (random.chance(1, 2)) {
    at.position += static_cast<double>(random.integer(1, 8)) * plane.d;  // beside the plane
  }
  return arriving(random, at.position, w, std::ldexp(1, random.integer(-2, 12)));
}

}  // namespace durero::conform::recipes
