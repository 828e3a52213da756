#include <array>
#include <cmath>
#include <cstdint>

#include "conform/families/recipes.hpp"
#include "durero/contract/contract.hpp"

namespace durero::conform::recipes {
namespace {

using model::Tipo;

enum class Way : std::uint8_t { across, rim, from_disc, in_plane, touching };
constexpr std::array ways{Way::across, Way::rim, Way::rim, Way::from_disc, Way::in_plane, Way::touching};

/// A ray from a point of the disc, on it exactly or nearly.
DrawnRay from_disc(Draws& random, const FramedShape& disc) {
  const FramedPoint at = random.chance(1, 2) ? rim_point(random, disc) : surface_point(random, disc);
  const glm::dvec3 w = random.chance(1, 3) ? tangent_vector(random, at) : any_vector(random, disc);
  DrawnRay ray{at.position, random.signed_power(-3, 3) * w};
  if (random.chance(2, 3)) ray.on.push_back(0);
  return ray;
}

/// A ray in the plane of the disc, from before it, from within or from behind; the ends of most such stretches are
/// irrational.
DrawnRay in_plane(Draws& random, const FramedShape& disc) {
  const FramedPoint at = random.chance(1, 3) ? rim_point(random, disc) : surface_point(random, disc);
  const glm::dvec3 w = perpendicular_vector(random, disc);
  const bool at_zero = !disc.lattice && disc.centro == glm::dvec3(0);
  const double side = random.integer(-1, 1), back = side * steps(w, disc.radius(), random.integer(-3, 6));
  return {(at_zero ? disc.centro : at.position) - back * w, std::ldexp(1, random.integer(-3, 3)) * w};
}

/// A disc that closes the base of an element, or its far end.
FramedShape closing(Draws& random, const FramedShape& element, bool at_base) {
  FramedShape disc = closing_disc(element, at_base);
  disc.d = random.sign() * element.d;
  return disc;
}

}  // namespace

/// A disc, and up to three other elements. A tilted disc at 0 has rays exactly in its plane.
FramedShapes with_disc(Draws& random, int) {
  FramedShapes shapes{any_shape(random, Tipo::soy_disco)};
  if (!shapes[0].lattice && random.chance(1, 2)) shapes[0].centro = glm::dvec3(0);
  if (random.chance(1, 3)) shapes.push_back(any_shape(random, Tipo::soy_disco));
  for (int left = random.integer(0, 2); left > 0; --left) shapes.push_back(any_shape(random, any_type(random)));
  return shapes;
}

DrawnRay disc(Draws& random, int log2_distance, ShapeSpan shapes) {
  const FramedShape& disc = shapes.front();
  const auto through = [&](const FramedPoint& at, const glm::dvec3& w) {
    return arriving(random, at.position, w, steps(w, disc.radius(), log2_distance));
  };
  switch (random.any_of(ways)) {
    case Way::across: {
      const FramedPoint at = surface_point(random, disc);
      return through(at, any_vector(random, disc));
    }
    case Way::rim: {
      const FramedPoint at = rim_point(random, disc);
      return one_in_three_nudged(random, through(at, any_vector(random, disc)));
    }
    case Way::from_disc:
      return from_disc(random, disc);
    case Way::in_plane:
      return in_plane(random, disc);
    case Way::touching: {
      const FramedPoint at = rim_point(random, disc);
      return one_in_three_nudged(random, through(at, at.around));
    }
  }
  contract::unreachable();
}

/// An element with an axis, whose base or far end or both are closed exactly.
FramedShapes capped(Draws& random, int) {
  FramedShape element;
  do element = any_shape(random, any_axial_type(random));
  while (!element.has_exact_radius() || random.rounded(element.radius()) != element.radius());
  // The far end of a tilted element is where its radius or its centre is rounded.
  const bool has_far_rim = element.lattice && !has_apex(element.tipo);
  const bool base = !has_far_rim || random.chance(2, 3), far_end = has_far_rim && (!base || random.chance(1, 2));
  FramedShapes shapes{element};
  if (base) shapes.push_back(closing(random, element, true));
  if (far_end) shapes.push_back(closing(random, element, false));
  return shapes;
}

DrawnRay cap(Draws& random, int log2_distance, ShapeSpan shapes) {
  const FramedShape& element = shapes.front();
  const FramedShape& disc = random.any_of(shapes.subspan(1));
  const FramedPoint at = rim_point(random, disc);
  if (random.chance(1, 2)) {
    const glm::dvec3 w = any_vector(random, disc);
    return one_in_three_nudged(random, arriving(random, at.position, w, steps(w, disc.radius(), log2_distance)));
  }
  const FramedPoint side = surface_point(random, element);
  const glm::dvec3 p = side.position - (random.integer(1, 4) / 4.0) * side.radial;
  const glm::dvec3 w = random.chance(2, 3) ? at.position - p : any_vector(random, element);
  return one_in_three_nudged(random, {p, std::ldexp(1, random.integer(-3, 3)) * w});
}

DrawnRay solid(Draws& random, ShapeSpan shapes) {
  if (random.chance(1, 2)) return cap(random, random.integer(0, 4), shapes);
  const FramedShape& disc = random.any_of(shapes.subspan(1));
  const FramedPoint across = surface_point(random, disc);
  if (random.chance(1, 2)) {
    const glm::dvec3 w = any_vector(random, disc);
    return arriving(random, across.position, w, steps(w, disc.radius(), random.integer(0, 4)));
  }
  const FramedPoint side = surface_point(random, shapes.front());
  const glm::dvec3 p = side.position - (random.integer(1, 4) / 4.0) * side.radial;
  return {p, std::ldexp(1, random.integer(-3, 3)) * (across.position - p)};
}

}  // namespace durero::conform::recipes
