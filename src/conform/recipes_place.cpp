#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "recipes.hpp"

namespace durero::conform::recipes {
namespace {

using model::Tipo;

Shot one_in_three_nudged(Random& random, Shot shot) {
  return random.chance(1, 3) ? nudged(random, std::move(shot)) : shot;
}

/// The place of the coordinate of d with the greatest magnitude.
int longest(const glm::dvec3& d) {
  const glm::dvec3 a(std::abs(d.x), std::abs(d.y), std::abs(d.z));
  return a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
}

/// At right angles with d exactly, and with the coordinate i = 0: its two products with d are opposite.
glm::dvec3 across(const glm::dvec3& d, int i) {
  glm::dvec3 u(0);
  u[(i + 1) % 3] = -d[(i + 2) % 3];
  u[(i + 2) % 3] = d[(i + 1) % 3];
  return u;
}

/// A tilted cylinder at 0 whose altura is avance of the point 2^k on a coordinate axis: rays across the axis through
/// that point stay in the plane of the rim, though the axis is no exact unit vector.
Body tilted_with_exact_rims(Random& random) {
  Body body = tilted_body(random, Tipo::soy_cilindro);
  const int k = random.integer(2, 6);
  body.centro = glm::dvec3(0);
  body.altura = std::ldexp(std::abs(body.d[longest(body.d)]), k);
  body.size = std::ldexp(random.uniform(0.9, 1.5), k);
  return body;
}

/// A ray in the plane of a rim of such a cylinder. Precondition: centro = 0.
Shot in_plane_of_rim(Random& random, const Body& body) {
  const int i = longest(body.d);
  glm::dvec3 p(0);
  if (body.tipo == Tipo::soy_cilindro && random.chance(1, 2)) p[i] = body.altura / body.d[i];
  const glm::dvec3 u = random.sign() * across(body.d, i);
  if (u == glm::dvec3(0)) return {p, {1, 0, 0}};
  return {p + steps(u, body.radius(), 3) * u, std::ldexp(-1, random.integer(-3, 3)) * u};
}

/// A tangent at the base of a tilted element at 0 whose axis has a coordinate 0: across the axis, in the plane of the
/// base, at the point `radius` along that coordinate's axis.
std::optional<Shot> tangent_to_tilted(Random& random, const Body& body) {
  if (body.lattice || body.centro != glm::dvec3(0) || body.tipo == Tipo::soy_esfera) return std::nullopt;
  const double radius = body.radius();
  if (body.tipo == Tipo::soy_cono && std::fma(body.size, body.altura, -radius) != 0) return std::nullopt;
  for (int i = 0; i < 3; ++i) {
    if (body.d[i] != 0) continue;
    glm::dvec3 point(0);
    point[i] = random.sign() * radius;
    const glm::dvec3 u = random.sign() * across(body.d, i);
    return arriving(random, point, u, steps(u, radius, random.integer(0, 8)));
  }
  return std::nullopt;
}

glm::dvec3 entering_both(Random& random, const Body& body, const Touch& one, const Touch& other) {
  glm::dvec3 w;
  for (int i = 0; i < 16; ++i) {
    w = inwards(any_vector(random, body), one);
    if (inwards(w, other) == w) break;
  }
  return w;
}

/// A sphere through a point of the first element, from any side; or one that fits in a cylinder and touches it around.
void add_crossing_sphere(Random& random, Bodies& bodies) {
  const Body first = bodies[0];
  Body sphere = lattice_body(random, Tipo::soy_esfera);
  const bool fits = first.tipo == Tipo::soy_cilindro && random.chance(1, 2);
  const Touch shared = touch(random, first);
  if (fits) {
    sphere.size = first.size;
    sphere.centro = first.centro + std::floor(first.altura / 2) * first.d;
    for (int i = 0; i < 8; ++i) {
      const Touch at = touch_at(random, first, std::floor(first.altura / 2) / first.altura);
      bodies[0].marks.push_back(at);
      sphere.marks.push_back(at);
    }
  } else {
    sphere.centro = glm::dvec3(0);
    Touch at = touch(random, sphere);
    sphere.centro = shared.point - at.radial;
    at.point = shared.point;
    bodies[0].marks.push_back(shared);
    sphere.marks.push_back(at);
  }
  bodies.push_back(sphere);
}

/// A cone on the base of the first cylinder.
void add_cone_on_base(Random& random, Bodies& bodies) {
  Body cone = bodies[0];
  cone.tipo = Tipo::soy_cono;
  cone.size = std::ldexp(1, random.integer(-2, 2));
  cone.altura = bodies[0].size / cone.size;
  for (int i = 0; i < 8; ++i) {
    const Touch of_cone = touch_at(random, cone, 0);
    Touch of_cylinder = of_cone;
    of_cylinder.along = cone.d;
    bodies[0].marks.push_back(of_cylinder);
    cone.marks.push_back(of_cone);
  }
  bodies.push_back(cone);
}

}  // namespace

Shot apex(Random& random, int log2_distance, Given bodies) {
  const Body& body = any_of(random, bodies);
  const glm::dvec3 w = any_vector(random, body);
  return one_in_three_nudged(random, arriving(random, body.apex(), w, steps(w, body.radius(), log2_distance)));
}

Bodies rim(Random& random, int) {
  Bodies bodies = some_axial(random, 0);
  if (random.chance(1, 3)) bodies = {tilted_with_exact_rims(random)};
  return bodies;
}

Shot rim(Random& random, int log2_distance, Given bodies) {
  const Body& body = any_of(random, bodies);
  if (!body.lattice && body.centro == glm::dvec3(0)) return one_in_three_nudged(random, in_plane_of_rim(random, body));
  const Touch at = rim_touch(random, body);
  glm::dvec3 w = any_vector(random, body);
  if (random.chance(3, 4)) w = inwards(w, at);
  return one_in_three_nudged(random, arriving(random, at.point, w, steps(w, body.radius(), log2_distance)));
}

Shot inside(Random& random, int quarters, Given bodies) {
  const Body& body = any_of(random, bodies);
  const Touch side = touch(random, body);
  const glm::dvec3 p = side.point - (quarters / 4.0) * side.radial;
  const Touch exit = random.chance(1, 3) ? rim_touch(random, body) : touch(random, body);
  return {p, std::ldexp(1, random.integer(-3, 3)) * (exit.point - p)};
}

Bodies with_twin(Random& random, int) {
  Bodies bodies = some(random, 0);
  if (random.chance(1, 3)) bodies.push_back(bodies[0]);
  return bodies;
}

Shot on_surface(Random& random, int percent_named, Given bodies) {
  const std::size_t place = random.below(bodies.size());
  const Body& body = bodies[place];
  const Touch at = random.chance(1, 4) ? rim_touch(random, body) : touch(random, body);
  const glm::dvec3 w = random.chance(1, 4) ? tangent_vector(random, body, at) : any_vector(random, body);
  Shot shot{at.point, random.signed_power(-3, 3) * w};
  if (!body.lattice && random.chance(1, 2)) shot = nudged(random, shot);
  if (random.integer(0, 99) >= percent_named) return shot;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const bool twin = bodies[i].centro == body.centro && bodies[i].tipo == body.tipo;
    if (i == place || twin) shot.on.push_back(i);
  }
  return shot;
}

Bodies tangent(Random& random, int) {
  Bodies bodies = some(random, 0);
  if (!random.chance(1, 4)) return bodies;
  Body body;
  do body = tilted_body(random, any_axial_type(random));
  while (body.d.x != 0 && body.d.y != 0 && body.d.z != 0);
  body.centro = glm::dvec3(0);
  bodies[0] = body;
  return bodies;
}

Shot tangent(Random& random, int log2_distance, Given bodies) {
  const Body& body = any_of(random, bodies);
  if (const auto shot = tangent_to_tilted(random, body)) return one_in_three_nudged(random, *shot);
  const Touch at = touch(random, body);
  const glm::dvec3 u = tangent_vector(random, body, at);
  return one_in_three_nudged(random, arriving(random, at.point, u, steps(u, body.radius(), log2_distance)));
}

Shot zero_b(Random& random, int percent_from_centre, Given bodies) {
  const Body& body = any_of(random, bodies);
  // From the centre of a sphere or of a cylinder's base B = 0 whatever the axis.
  if (body.tipo != Tipo::soy_cono && random.integer(0, 99) < percent_from_centre) {
    glm::dvec3 w = any_vector(random, body);
    if (glm::dot(w, body.d) < 0) w = -w;
    return {body.centro, w};
  }
  // From the middle of a chord the roots are opposite.
  const Touch one = touch(random, body), other = touch(random, body);
  const Shot shot{0.5 * (one.point + other.point), std::ldexp(1, random.integer(-3, 3)) * (other.point - one.point)};
  return random.chance(1, 4) ? nudged(random, shot) : shot;
}

Bodies tie(Random& random, int) {
  switch (random.integer(0, 3)) {
    case 0: {
      // The same surface twice, one of them longer where it is a cylinder.
      Bodies bodies{any_body(random, any_type(random))};
      bodies.push_back(bodies[0]);
      if (bodies[0].tipo == Tipo::soy_cilindro) bodies[1].altura *= random.integer(1, 3);
      return bodies;
    }
    case 1: {
      Bodies bodies{lattice_body(random, Tipo::soy_cilindro)};
      add_cone_on_base(random, bodies);
      return bodies;
    }
    default: {
      Bodies bodies{lattice_body(random, any_type(random))};
      add_crossing_sphere(random, bodies);
      return bodies;
    }
  }
}

Shot tie(Random& random, int log2_distance, Given bodies) {
  const Body& body = bodies[0];
  if (body.marks.empty()) return ordinary(random, body, log2_distance);
  const std::size_t i = random.below(body.marks.size());
  const glm::dvec3 w = entering_both(random, body, body.marks[i], bodies[1].marks[i]);
  const Shot shot = arriving(random, body.marks[i].point, w, steps(w, body.radius(), log2_distance));
  return random.chance(1, 4) ? nudged(random, shot) : shot;
}

}  // namespace durero::conform::recipes
