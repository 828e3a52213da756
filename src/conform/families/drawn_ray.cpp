#include "conform/families/drawn_ray.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "durero/contract/contract.hpp"

namespace durero::conform {
namespace {

enum class Coincidence : std::uint8_t { tangent, rim, rim_across_axis, apex, generator };
constexpr std::array coincidences{Coincidence::tangent, Coincidence::rim, Coincidence::rim_across_axis,
                                  Coincidence::apex, Coincidence::generator};

}  // namespace

DrawnRay scaled(DrawnRay ray, int k) {
  ray.p = times_power(ray.p, k);
  ray.v = times_power(ray.v, k);
  return ray;
}

DrawnRay arriving(Draws& random, const glm::dvec3& point, const glm::dvec3& w, double m) {
  return {point - m * w, std::ldexp(1, random.integer(-3, 3)) * w};
}

double steps(const glm::dvec3& w, double length, int e) {
  const double greatest = std::max({std::abs(w.x), std::abs(w.y), std::abs(w.z)});
  return std::ldexp(1, e + std::ilogb(length) - std::ilogb(greatest));
}

DrawnRay nudged(Draws& random, DrawnRay ray) {
  double& x = (random.chance(2, 3) ? ray.p : ray.v)[random.integer(0, 2)];
  if (x == 0 && random.chance(1, 2)) return ray;
  x = random.next(x, random.sign());
  return ray;
}

DrawnRay one_in_three_nudged(Draws& random, DrawnRay ray) {
  return random.chance(1, 3) ? nudged(random, std::move(ray)) : ray;
}

DrawnRay coincident(Draws& random, const FramedShape& shape, int e) {
  const FramedPoint rim = rim_point(random, shape);
  const auto through = [&](const glm::dvec3& point, const glm::dvec3& w) {
    return arriving(random, point, w, steps(w, shape.radius(), e));
  };
  switch (random.any_of(coincidences)) {
    case Coincidence::tangent: {
      const FramedPoint at = surface_point(random, shape);
      return through(at.position, tangent_vector(random, at));
    }
    case Coincidence::rim:
      return through(rim.position, inwards(any_vector(random, shape), rim));
    case Coincidence::rim_across_axis:
      return through(rim.position, inwards(perpendicular_vector(random, shape), rim));
    case Coincidence::apex:
      if (has_apex(shape.tipo)) return through(shape.apex(), any_vector(random, shape));
      return through(rim.position, -rim.radial);
    case Coincidence::generator:
      return through(surface_point(random, shape).position, rim.along);
  }
  contract::unreachable();
}

DrawnRay ordinary(Draws& random, const FramedShape& shape, int e) {
  if (random.chance(1, 3)) return coincident(random, shape, e);
  const FramedPoint at = surface_point(random, shape);
  glm::dvec3 w = any_vector(random, shape);
  if (random.chance(7, 8)) w = inwards(w, at);
  return arriving(random, at.position, w, steps(w, shape.radius(), e));
}

}  // namespace durero::conform
