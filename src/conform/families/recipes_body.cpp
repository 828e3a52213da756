#include "conform/families/recipes_body.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "durero/contract/contract.hpp"

namespace durero::conform::recipes {
namespace {

using Sides = std::array<glm::dvec3, 3>;

/// Vectors of whole numbers at right angles, all of one length that is a whole number, 36 at most: the columns of a
/// rotation by a quaternion of whole numbers, times its norm. One in two are the axes of coordinates.
Sides rotated_axes(Draws& random) {
  if (random.chance(1, 2)) return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const double s = random.integer(-3, 3), a = random.integer(-3, 3), b = random.integer(-3, 3),
               c = random.integer(1, 3);
  return {{{s * s + a * a - b * b - c * c, 2 * (a * b + s * c), 2 * (a * c - s * b)},
           {2 * (a * b - s * c), s * s - a * a + b * b - c * c, 2 * (b * c + s * a)},
           {2 * (a * c + s * b), 2 * (b * c - s * a), s * s - a * a - b * b + c * c}}};
}

/// Sides at right angles, from 1/8 to some 36 long. Every number of them and every length is an eighth.
Sides rectangular_sides(Draws& random) {
  Sides sides = rotated_axes(random);
  for (glm::dvec3& side : sides) side *= random.integer(1, 8) / 8.0;
  return sides;
}

double volume(const Sides& of) { return glm::dot(of[0], glm::cross(of[1], of[2])); }

/// Any sides that span space, of either hand; one in four at right angles, and then perhaps mirrored.
Sides any_sides(Draws& random) {
  Sides sides = rectangular_sides(random);
  if (random.chance(1, 4)) {
    sides[0] *= random.sign();
    return sides;
  }
  do {
    for (glm::dvec3& side : sides) side = random.lattice_vector(16) / 8.0;
  } while (volume(sides) == 0);
  return sides;
}

AskedBody body_of(Draws& random, BodyKind kind) {
  AskedBody body{.kind = kind, .centro = random.lattice_vector(16) / 2.0};
  switch (kind) {
    case BodyKind::caja:
    case BodyKind::elipsoide:
      body.sides = rectangular_sides(random);
      return body;
    case BodyKind::capsula: {
      body.sides = rotated_axes(random);
      const double across = random.integer(1, 8) / 8.0, along = random.integer(1, 16) / 8.0;
      body.sides = {across * body.sides[0], along * body.sides[1], across * body.sides[2]};
      return body;
    }
    case BodyKind::copia_caja:
    case BodyKind::copia_esfera:
      body.sides = any_sides(random);
      return body;
    case BodyKind::caja_redonda:
      body.sides = rectangular_sides(random);
      body.radio = random.integer(1, 16) / 8.0;
      return body;
    case BodyKind::toro: {
      body.sides = rotated_axes(random);
      const double ring = random.integer(1, 8) / 8.0;
      for (glm::dvec3& side : body.sides) side *= ring;
      body.radio = length_of(body.sides[0]) * random.integer(1, 7) / 8.0;
      return body;
    }
    case BodyKind::campo:
      break;
  }
  contract::unreachable();
}

AskedBody any_body(Draws& random) { return body_of(random, random.any_body_kind()); }

AskedBody times_power(AskedBody body, int k) {
  body.centro = conform::times_power(body.centro, k);
  for (glm::dvec3& side : body.sides) side = conform::times_power(side, k);
  body.radio = std::ldexp(body.radio, k);
  return body;
}

bool is_box(const AskedBody& body) { return body.kind == BodyKind::caja || body.kind == BodyKind::copia_caja; }

glm::dvec3 point_of(const AskedBody& body, const glm::dvec3& w) {
  return body.centro + w.x * body.sides[0] + w.y * body.sides[1] + w.z * body.sides[2];
}

/// A multiple of an eighth within a side, or its end.
double eighths(Draws& random) { return random.integer(-8, 8) / 8.0; }

/// A point of the unit ball's surface: of the lattice, or any.
glm::dvec3 of_ball(Draws& random) {
  static constexpr std::array<glm::dvec3, 4> rational{
      {{1, 0, 0}, {0.6, 0.8, 0}, {2.0 / 3, 2.0 / 3, 1.0 / 3}, {2.0 / 7, 3.0 / 7, 6.0 / 7}}};
  if (random.chance(1, 3)) return random.direction();
  glm::dvec3 w = rational[random.below(rational.size())];
  const auto turn = static_cast<int>(random.below(3));
  w = {w[turn], w[(turn + 1) % 3], w[(turn + 2) % 3]};
  for (int i = 0; i < 3; ++i) w[i] *= random.sign();
  return w;
}

/// A point of a rounded box: of a box, and beyond each side at whose bound it is by a part of the radius. Parts of the
/// radius that are 0 lie at a seam between a flat part and a round one.
glm::dvec3 rounded_parts(Draws& random, const AskedBody& body, int bounds) {
  glm::dvec3 w{eighths(random), eighths(random), eighths(random)}, out = of_ball(random);
  const auto first = static_cast<int>(random.below(3));
  if (bounds == 1) out = {1, 0, 0};
  if (bounds == 2) {
    const double turn = random.chance(1, 2) ? eighths(random) : random.uniform(-1, 1), square = turn * turn;
    out = {(1 - square) / (1 + square), 2 * turn / (1 + square), 0};
  }
  for (int i = 0; i < bounds; ++i) {
    const int at = (first + i) % 3;
    w[at] = random.sign() * (1 + body.radio * std::abs(out[i]) / length_of(body.sides[static_cast<std::size_t>(at)]));
  }
  return w;
}

/// A point of a torus, or with `out` not 1 so much of the tube's radius from the ring. Rays at the bounds touch it
/// where it is highest, or are in its equator.
glm::dvec3 torus_parts(Draws& random, const AskedBody& body, int bounds, double out = 1) {
  const double ratio = out * body.radio / length_of(body.sides[0]), turn = random.uniform(-1, 1), square = turn * turn;
  static constexpr std::array<glm::dvec2, 4> quarters{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
  glm::dvec2 around{(1 - square) / (1 + square), 2 * turn / (1 + square)}, tube = random.any_of(quarters);
  around *= random.sign();
  if (random.chance(1, 3)) around = random.any_of(quarters);
  if (bounds == 1) {
    const glm::dvec3 any = of_ball(random);
    const double size = std::hypot(any.x, any.y);
    tube = size > 0 ? glm::dvec2(any.x, any.y) / size : glm::dvec2(1, 0);
  }
  const double far = 1 + ratio * tube.x;
  return {around.x * far, ratio * tube.y * length_of(body.sides[0]) / length_of(body.sides[1]), around.y * far};
}

/// A point of the surface by the parts of the sides. `bounds` of its coordinates are at a bound: of a box in a side, an
/// edge or a corner; of a capsule at a seam, where there are some.
glm::dvec3 surface_parts(Draws& random, const AskedBody& body, int bounds) {
  if (body.kind == BodyKind::caja_redonda) return rounded_parts(random, body, bounds);
  if (body.kind == BodyKind::toro) return torus_parts(random, body, bounds);
  glm::dvec3 w = of_ball(random);
  if (is_box(body)) {
    w = {eighths(random), eighths(random), eighths(random)};
    const auto first = static_cast<int>(random.below(3));
    for (int i = 0; i < bounds; ++i) w[(first + i) % 3] = random.sign();
  } else if (body.kind == BodyKind::capsula) {
    const double ratio = length_of(body.sides[0]) / length_of(body.sides[1]);
    const double along = bounds > 1 || random.chance(1, 2) ? random.sign() : 0;
    if (along != 0 && bounds <= 1) return {w.x, along * (1 + ratio * std::abs(w.y)), w.z};
    const double turn = random.uniform(-1, 1), square = turn * turn;
    const glm::dvec2 round{(1 - square) / (1 + square), 2 * turn / (1 + square)};
    const double side = random.sign();
    return {side * round.x, along != 0 ? along : eighths(random), round.y};
  }
  return w;
}

/// A vector for a ray at a body: along or against a side, in the plane of two, of the lattice, or any.
glm::dvec3 vector_at(Draws& random, const AskedBody& body) {
  const std::size_t side = random.below(3);
  switch (random.below(5)) {
    case 0:
      return random.sign() * body.sides[side];
    case 1: {
      const double a = random.integer(-4, 4), b = random.integer(1, 4);
      return a * body.sides[side] + b * body.sides[(side + 1) % 3];
    }
    case 2:
      return random.direction();
    default:
      return random.lattice_vector(8);
  }
}

/// The unit vector outwards at a point of the surface by its parts; at an edge or a corner of a box between its sides'.
glm::dvec3 outwards(const AskedBody& body, const glm::dvec3& parts) {
  const auto& [x, y, z] = body.sides;
  const Sides normals{glm::cross(y, z), glm::cross(z, x), glm::cross(x, y)};
  const double side = std::copysign(1.0, volume(body.sides));
  glm::dvec3 out(0);
  if (body.kind == BodyKind::caja_redonda) {
    for (int i = 0; i < 3; ++i) {
      const glm::dvec3& along = body.sides[static_cast<std::size_t>(i)];
      out += std::copysign(std::max(0.0, std::abs(parts[i]) - 1), parts[i]) * along;
    }
    return out / length_of(out);
  }
  for (int i = 0; i < 3; ++i) {
    const glm::dvec3& normal = normals[static_cast<std::size_t>(i)];
    if (!is_box(body))
      out += parts[i] * side * normal;
    else if (std::abs(parts[i]) == 1)
      out += parts[i] * side / length_of(normal) * normal;
  }
  if (body.kind == BodyKind::capsula) out = parts.x * x + parts.z * z;
  if (body.kind == BodyKind::toro) {
    const double far = std::hypot(parts.x, parts.z);
    out = (far - 1) / far * (parts.x * x + parts.z * z) + parts.y * y;
  }
  return out / length_of(out);
}

double size_of(const AskedBody& body) {
  return std::max({length_of(body.sides[0]), length_of(body.sides[1]), length_of(body.sides[2]), body.radio});
}

DrawnRay towards(Draws& random, const AskedBody& body, const glm::dvec3& point, glm::dvec3 w, int e) {
  if (random.chance(7, 8) && glm::dot(w, point - body.centro) > 0) w = -w;
  return one_in_three_nudged(random, arriving(random, point, w, steps(w, size_of(body), e)));
}

DrawnRay ordinary_at(Draws& random, const AskedBody& body, int e) {
  const glm::dvec3 point = point_of(body, surface_parts(random, body, random.chance(2, 3) ? 1 : random.integer(2, 3)));
  return towards(random, body, point, vector_at(random, body), e);
}

}  // namespace

AskedBodies bodies(Draws& random, int count) {
  AskedBodies all(static_cast<std::size_t>(count));
  for (AskedBody& body : all) body = any_body(random);
  return all;
}
AskedBodies some_bodies(Draws& random, int) { return bodies(random, random.integer(1, 3)); }

DrawnRay bodies(Draws& random, int, BodySpan all) {
  const AskedBody& body = random.any_of(all);
  return ordinary_at(random, body, random.integer(0, 4));
}

DrawnRay bodies_far(Draws& random, int log2_distance, BodySpan all) {
  return ordinary_at(random, random.any_of(all), log2_distance);
}

/// Bodies that are the same at every scale.
AskedBodies bodies_scale(Draws& random, int log2_scale) {
  Draws always_the_same(0, random.options());
  AskedBodies all = bodies(always_the_same, 5);
  for (AskedBody& body : all) body = times_power(body, log2_scale);
  return all;
}

DrawnRay bodies_scale(Draws& random, int log2_scale, BodySpan all) {
  const AskedBody body = times_power(random.any_of(all), -log2_scale);
  return scaled(ordinary_at(random, body, random.integer(0, 4)), log2_scale);
}

/// Plates and needles: one side, or two, are shorter by the ratio. Those of a capsule across its axis are alike.
AskedBodies bodies_thin(Draws& random, int log2_ratio) {
  AskedBodies all = some_bodies(random, 0);
  for (AskedBody& body : all) {
    const bool is_needle = random.chance(1, 2);
    if (body.kind == BodyKind::capsula) {
      for (const std::size_t i : {0U, 2U}) body.sides[i] = conform::times_power(body.sides[i], -log2_ratio);
      continue;
    }
    if (body.kind == BodyKind::toro) {  // a thin ring
      body.radio = std::ldexp(body.radio, -log2_ratio);
      continue;
    }
    if (body.kind == BodyKind::caja_redonda && random.chance(1, 2)) body.radio = std::ldexp(body.radio, -log2_ratio);
    const std::size_t kept = random.below(3);
    for (std::size_t i = 0; i < 3; ++i) {
      if ((i == kept) != is_needle) body.sides[i] = conform::times_power(body.sides[i], -log2_ratio);
    }
  }
  return all;
}

DrawnRay bodies_edge(Draws& random, int log2_distance, BodySpan all) {
  const AskedBody& body = random.any_of(all);
  const glm::dvec3 point = point_of(body, surface_parts(random, body, random.integer(2, 3)));
  return towards(random, body, point, vector_at(random, body), log2_distance);
}

DrawnRay bodies_inside(Draws& random, int eighths_out, BodySpan all) {
  const AskedBody& body = random.any_of(all);
  const double out = eighths_out / 8.0;
  const glm::dvec3 p = point_of(
      body, body.kind == BodyKind::toro ? torus_parts(random, body, 1, out) : out * surface_parts(random, body, 1));
  const glm::dvec3 target = point_of(body, surface_parts(random, body, random.integer(1, 3)));
  const glm::dvec3 v = random.chance(1, 2) ? vector_at(random, body) : target - p;
  return one_in_three_nudged(random, {p, v == glm::dvec3(0) ? body.sides[0] : v});
}

/// Along the axes of coordinates, with zeros of either sign, through sides, edges and corners of boxes.
DrawnRay bodies_axis(Draws& random, int log2_distance, BodySpan all) {
  const AskedBody& body = random.any_of(all);
  glm::dvec3 w(0);
  for (int i = 0; i < 3; ++i) w[i] *= random.sign();
  const auto axis = static_cast<int>(random.below(3));
  w[axis] = random.sign();
  if (random.chance(1, 3)) w[(axis + 1) % 3] = random.sign();
  const glm::dvec3 point = point_of(body, surface_parts(random, body, random.integer(1, 3)));
  return arriving(random, point, w, steps(w, size_of(body), log2_distance));
}

/// Past an edge or a limb by a part of the size, inside of it or outside.
DrawnRay bodies_margin(Draws& random, int minus_log2_margin, BodySpan all) {
  const AskedBody& body = random.any_of(all);
  const glm::dvec3 parts = surface_parts(random, body, random.integer(2, 3));
  const glm::dvec3 out = outwards(body, parts), w = glm::cross(out, random.direction());
  const double past = random.sign() * std::ldexp(size_of(body), -minus_log2_margin);
  const glm::dvec3 point = point_of(body, parts) + past * out;
  return arriving(random, point, w, steps(w, size_of(body), random.integer(0, 3)));
}

DrawnRay bodies_surface(Draws& random, int minus_log2_step, BodySpan all) {
  const AskedBody& body = random.any_of(all);
  const glm::dvec3 point = point_of(body, surface_parts(random, body, random.integer(1, 2)));
  const glm::dvec3 w = vector_at(random, body);
  if (random.chance(1, 3)) return {point, w};
  return arriving(random, point, w, random.sign() * steps(w, size_of(body), -minus_log2_step));
}

}  // namespace durero::conform::recipes
