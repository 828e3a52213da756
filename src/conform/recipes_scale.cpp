#include <cmath>

#include "recipes.hpp"

namespace durero::conform::recipes {
namespace {

using model::Tipo;

template <class Type>
Bodies one_to_three(Random& random, Type type) {
  Bodies bodies(random.below(3) + 1);
  for (Body& body : bodies) body = any_body(random, type(random));
  return bodies;
}

/// Elements and rays are made at a moderate scale, where no product overflows, and then scaled.
Shot ordinary_scaled(Random& random, const Body& body, int k, int e) {
  return scaled(ordinary(random, scaled(body, -k), e), k);
}

double quarters(Random& random, int half) { return random.integer(-4 * half, 4 * half) / 4.0; }

}  // namespace

const Body& any_of(Random& random, Given bodies) { return bodies[random.below(bodies.size())]; }

Bodies some(Random& random, int) { return one_to_three(random, any_type); }
Bodies some_axial(Random& random, int) { return one_to_three(random, any_axial_type); }
Bodies some_cylinders(Random& random, int) {
  return one_to_three(random, [](Random&) { return Tipo::soy_cilindro; });
}
Bodies some_cones(Random& random, int) {
  return one_to_three(random, [](Random&) { return Tipo::soy_cono; });
}

Bodies as_many(Random& random, int count) {
  Bodies bodies(static_cast<std::size_t>(count));
  for (Body& body : bodies) body = any_body(random, any_type(random));
  return bodies;
}

Shot generic(Random& random, int, Given bodies) {
  const Body& body = any_of(random, bodies);
  return ordinary(random, body, random.integer(0, 4));
}

Shot far_origin(Random& random, int log2_distance, Given bodies) {
  return ordinary(random, any_of(random, bodies), log2_distance);
}

Bodies large_offset(Random& random, int log2_offset) {
  Bodies bodies = some(random, 0);
  // The farthest coordinate of each centre is at least 2^(log2_offset + 8) less the 300 of its place in the scene.
  const glm::dvec3 offset = std::ldexp(1, log2_offset + 8) * random.lattice_vector(4);
  for (Body& body : bodies) body.centro += offset;
  return bodies;
}

Bodies scaled_up(Random& random, int log2_scale) {
  Bodies bodies = some(random, 0);
  for (Body& body : bodies) body = scaled(body, log2_scale);
  return bodies;
}

Bodies huge_ratio(Random& random, int log2_ratio) {
  Bodies bodies = some(random, 0);
  // A great element that passes by the small ones: a point of its surface is near their place.
  Body great = scaled(any_body(random, any_type(random)), log2_ratio);
  great.centro = glm::dvec3(0);
  const Touch near = touch(random, great);
  great.centro = 32.0 * random.lattice_vector(16) - near.point;
  bodies.push_back(great);
  return bodies;
}

Shot near_small(Random& random, int, Given bodies) {
  const Body& body = any_of(random, bodies.first(bodies.size() - 1));
  return ordinary(random, body, random.integer(0, 3));
}

Shot direction_scale(Random& random, int log2_scale, Given bodies) {
  Shot shot = generic(random, 0, bodies);
  shot.v *= std::ldexp(1, log2_scale);
  return shot;
}

Bodies degenerate_numbers(Random& random, int log2_scale) { return scaled_up(random, log2_scale); }

Shot degenerate_numbers(Random& random, int log2_scale, Given bodies) {
  const Body& body = any_of(random, bodies);
  Shot shot = ordinary_scaled(random, body, log2_scale, random.integer(0, 4));
  if (random.chance(1, 2)) return shot;
  // A direction of another scale: t itself may be subnormal or overflow.
  const int k = random.integer(-1074, 1010) - log2_scale;
  for (int i = 0; i < 3; ++i) shot.v[i] = std::ldexp(shot.v[i], k);
  return shot;
}

Bodies long_thin(Random& random, int log2_ratio) {
  Bodies bodies = some_axial(random, 0);
  for (Body& body : bodies) {
    const double radius = body.radius();
    body.altura = std::ldexp(body.lattice ? radius : std::ldexp(1, std::ilogb(radius) + 1), log2_ratio);
    if (body.tipo == Tipo::soy_cono) body.size = std::ldexp(1, -log2_ratio);
  }
  return bodies;
}

Shot long_thin(Random& random, int log2_ratio, Given bodies) {
  const Body& body = any_of(random, bodies);
  return ordinary(random, body, random.integer(0, log2_ratio));
}

Shot near_origin(Random& random, int minus_log2_distance, Given bodies) {
  return ordinary(random, any_of(random, bodies), -minus_log2_distance);
}

Bodies grid(Random& random, int count) {
  Bodies bodies(static_cast<std::size_t>(count));
  for (Body& body : bodies) {
    body = lattice_body(random, any_type(random));
    const double x = quarters(random, 3), y = quarters(random, 3), z = quarters(random, 3);
    body.centro = {x, y, z};
    body.size = random.integer(1, 8) / 4.0;
    body.altura = random.integer(1, 16) / 4.0;
  }
  return bodies;
}

Shot grid(Random& random, int, Given) {
  const double x = quarters(random, 5), y = quarters(random, 5), z = quarters(random, 5);
  const double power = random.signed_power(-2, 1);
  return {{x, y, z}, power * random.lattice_vector(4)};
}

}  // namespace durero::conform::recipes
