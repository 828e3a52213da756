#include <cmath>
#include <limits>

#include "recipes.hpp"

namespace durero::conform::recipes {
namespace {

using model::Tipo;

/// The axis itself as direction, and p before, beside or after the element: in its surface, inside or outside it.
Shot parallel(Random& random, const Body& body) {
  const Touch at = touch(random, body);
  const glm::dvec3 aside = (random.integer(-2, 8) / 8.0) * at.radial;  // of the way to the axis
  const glm::dvec3 from = random.chance(1, 2) ? at.point : at.point - aside;
  const double back = body.altura * (random.integer(-8, 16) / 8.0);
  const Shot shot{from - back * body.d, random.signed_power(-3, 3) * body.d};
  return random.chance(1, 3) ? nudged(random, shot) : shot;
}

}  // namespace

Bodies near_axial(Random& random, int) {
  Bodies bodies = some_cylinders(random, 0);
  for (Body& body : bodies) {
    // Long enough that even a ray parallel to a tilted axis, of length 1 up to 2⁻⁵⁰, meets it.
    if (!body.lattice && random.chance(1, 3)) body.altura = std::ldexp(body.altura, random.integer(40, 60));
  }
  return bodies;
}

Shot near_axial(Random& random, int minus_log2_slope, Given bodies) {
  const Body& body = any_of(random, bodies);
  if (random.chance(1, 3)) return parallel(random, body);
  const Touch at = touch(random, body);
  const double slope = random.sign() * std::ldexp(1, -minus_log2_slope - std::ilogb(body.size) - 1);
  const glm::dvec3 w = random.sign() * (body.d + slope * at.radial);
  return arriving(random, at.point, w, std::ldexp(1, random.integer(-2, 12)));
}

Shot perpendicular(Random& random, int log2_distance, Given bodies) {
  const Body& body = any_of(random, bodies);
  const Touch at = random.chance(1, 3) ? rim_touch(random, body) : touch(random, body);
  glm::dvec3 w = perpendicular_vector(random, body);
  if (random.chance(3, 4)) w = inwards(w, at);
  return arriving(random, at.point, w, steps(w, body.radius(), log2_distance));
}

Shot near_generator(Random& random, int minus_log2_angle, Given bodies) {
  const Body& body = any_of(random, bodies);
  const Touch at = touch(random, body);
  glm::dvec3 w = random.sign() * at.along;
  if (random.chance(1, 2)) w += std::ldexp(1, -minus_log2_angle) * any_vector(random, body);
  const glm::dvec3 through = random.chance(7, 8) ? touch(random, body).point : at.point;
  return arriving(random, through, w, steps(w, body.radius(), random.integer(-1, 5)));
}

Shot second_nappe(Random& random, int eighths, Given bodies) {
  const Body& body = any_of(random, bodies);
  const Touch mirrored = touch_at(random, body, 1 + eighths / 8.0);
  const bool never_real = random.chance(1, 4);
  const Touch real = random.chance(1, 3) ? rim_touch(random, body) : touch(random, body);
  const glm::dvec3 to = never_real ? touch_at(random, body, 1 + random.integer(1, 8) / 8.0).point : real.point;
  return arriving(random, mirrored.point, to - mirrored.point, std::ldexp(1, random.integer(-3, 3)));
}

Shot axis_parallel(Random& random, int log2_distance, Given bodies) {
  const Body& body = any_of(random, bodies);
  const Touch at = random.chance(1, 2) ? rim_touch(random, body) : touch(random, body);
  const int axis = random.integer(0, 2);
  glm::dvec3 w(0);
  w[axis] = random.sign();
  if (random.chance(1, 3)) w[(axis + random.integer(1, 2)) % 3] = random.integer(-4, 4);
  if (random.chance(3, 4)) w = inwards(w, at);
  Shot shot = arriving(random, at.point, w, steps(w, body.radius(), log2_distance));
  for (int i = 0; i < 3; ++i) {
    if (shot.v[i] != 0 || random.chance(1, 3)) continue;
    const double tiny = std::ldexp(std::numeric_limits<double>::denorm_min(), random.integer(0, 51));
    const double magnitude = random.chance(1, 2) ? 0 : tiny;
    shot.v[i] = random.sign() * magnitude;
  }
  return shot;
}

Shot in_surface(Random& random, int eighths, Given bodies) {
  const Body& body = any_of(random, bodies);
  const double part = random.integer(0, 8) / 8.0;
  const Touch at = touch_at(random, body, part);
  const glm::dvec3 whole = body.tipo == Tipo::soy_cilindro ? body.altura * at.along : at.along;
  const double by = random.sign() * eighths / 8.0;
  Shot shot{at.point + by * whole, random.signed_power(-3, 3) * whole};
  const bool named = body.lattice && part + by >= 0 && part + by <= 1 && random.chance(1, 3);
  if (named) shot.on.push_back(static_cast<std::size_t>(&body - bodies.data()));
  return !named && random.chance(1, 4) ? nudged(random, shot) : shot;
}

}  // namespace durero::conform::recipes
