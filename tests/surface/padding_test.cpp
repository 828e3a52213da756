// How much of what the radius of a ball is made greater by the roundings take.
#include <fmt/core.h>

#include "durero/conform/random.hpp"
#include "durero/surface/surfaces.hpp"
#include "support/catch.hpp"
#include "support/exact_ratio.hpp"
#include "support/exact_vector.hpp"

using namespace durero;
using namespace durero::test;
using conform::Random;

namespace {

/// No less than the way from the ball's centre to any point of the element at the height s and at `across` from the
/// axis. With n = d·d a point is centro + (s/n)·d + e with e·d = 0 and |e| ≤ across; n is within 2⁻⁵⁰ of 1.
Fraction farthest(const glm::dvec3& centro, const glm::dvec3& vector, const surface::Ball& ball, double s,
                  const Dyadic& across) {
  const Exact_Vector d(vector);
  const Dyadic n = dot(d, d);
  const Exact_Vector way = n * (Exact_Vector(centro) - Exact_Vector(ball.centre)) + Dyadic(s) * d;
  const Dyadic square_of_way = dot(way, way), along = dot(way, d);
  const Dyadic aside = root(n * square_of_way - square(along)) * (Dyadic(1) + Dyadic(0x1p-50));
  return {root(square_of_way + shifted(n * across * aside, 1) + square(n * across)), n};
}

/// The part of what was added to the radius of a ball through these points that they take.
double part_of_padding(const Fraction& way, const surface::Ball& ball, const Fraction& radius) {
  const Dyadic over = way.n * radius.w - radius.n * way.w;
  return number::sign(over) <= 0 ? 0 : ratio(over, (Dyadic(ball.radius) * radius.w - radius.n) * way.w);
}
double part_of_padding(const Fraction& way, const surface::Ball& ball, const Dyadic& radius) {
  return part_of_padding(way, ball, Fraction{radius, 1});
}

}  // namespace

TEST_CASE("the ball of an element holds all of it") {
  Random random(1);
  double of_cylinder = 0, of_cone = 0, of_truncated_cone = 0;
  for (int i = 0; i < 4000; ++i) {
    const double size = random.signed_power(-40, 60);
    const glm::dvec3 centro = size * random.in_cube(1), d = random.direction();
    const double r = std::abs(random.number(-20, 20)), h = std::abs(random.number(-20, 20));
    const surface::Ball about = surface::ball(scene::Cylinder{centro, r, d, h});
    const Dyadic radius = root(square(Dyadic(r)) + square(Dyadic(h / 2)));
    for (const double s : {0.0, h}) {
      of_cylinder = std::max(of_cylinder, part_of_padding(farthest(centro, d, about, s, r), about, radius));
    }
    const double k = r / 1024;
    const surface::Ball over = surface::ball(scene::Cone{centro, k, d, h});
    const Dyadic base = Dyadic(k) * Dyadic(h), height = shifted(Dyadic(h) - Dyadic(k) * base, -1);
    const Dyadic reach = number::sign(height) > 0 ? Dyadic(h) - height : base;  // of the ball, were it exact
    of_cone = std::max(of_cone, part_of_padding(farthest(centro, d, over, 0, base), over, reach));
    of_cone = std::max(of_cone, part_of_padding(farthest(centro, d, over, h, 0), over, reach));
    const surface::Ball round = surface::ball(scene::TruncatedCone{centro, r, k, d, h});
    const Dyadic wide = Dyadic(r) + base, spread = (wide - r) * (wide + r);
    // Where both rims are equally far: (h² − spread)/2h, times h.
    const Dyadic middle = shifted(square(Dyadic(h)) - spread, -1);
    if (number::sign(middle) <= 0) continue;  // the ball is about the base: no square root is exact there
    const Dyadic to_rim = root(square(middle) + square(wide * Dyadic(h)));  // times h
    for (const auto& [s, across] : {std::pair(0.0, wide), std::pair(h, Dyadic(r))}) {
      const Fraction way = farthest(centro, d, round, s, across);
      of_truncated_cone = std::max(of_truncated_cone, part_of_padding(way, round, Fraction{to_rim, h}));
    }
  }
  fmt::print(
      "balls: worst part of what the radius is made greater by: {:.4f} cylinder, {:.4f} cone, {:.4f} truncated "
      "cone\n",
      of_cylinder, of_cone, of_truncated_cone);
  CHECK(of_cylinder <= 1);
  CHECK(of_cone <= 1);
  CHECK(of_truncated_cone <= 1);
  // A ball's radius is greater by 2⁻⁴⁰ of it: no measurement comes near, as the part for the centre is more.
  CHECK(surface::ball(scene::Cylinder{{0, 0, 0}, 3, {0, 0, 1}, 8}).radius >= 5 * (1 + 0x1p-40));
}
