// The filter over balls never passes over a ball that a ray may meet, and how much of what it allows for errors they
// take: a ball is made smaller, or the limit lower, until the filter drops it, and that is compared with where exact
// arithmetic would.
#include "durero/trace/tables.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <string>

#include "durero/conform/random.hpp"
#include "durero/surface/surfaces.hpp"
#include "support/catch.hpp"
#include "support/exact_ratio.hpp"
#include "support/exact_vector.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;
using conform::Random;
using trace::Beam;

namespace {

/// A ball's centre and a ray.
struct Shot {
  glm::dvec3 centre;
  model::Rayo rayo;
  Beam beam = Beam(rayo);
  Exact_Vector q = Exact_Vector(rayo.p().xyz()) - Exact_Vector(centre), v = Exact_Vector(rayo.v().xyz());
  Dyadic B = dot(q, v), speed = length(v);
};

trace::Balls balls_of(const glm::dvec3& centre, double radius) {
  trace::Balls balls;
  balls.push_back({centre, radius});
  balls.pad();
  return balls;
}

bool passes(const Shot& shot, double radius, double limit = trace::no_limit) {
  std::array<std::uint32_t, trace::Balls::block> passed;
  return filter(balls_of(shot.centre, radius), shot.beam, limit, 0, 1, passed.data()) > 0;
}

/// The least number for which yes(x), where it is yes from some number on. Preconditions: yes(high), not yes(low).
template <class Yes>
double least(double low, double high, Yes yes) {
  for (;;) {
    const double middle = low + (high - low) / 2;
    if (middle <= low || middle >= high) return high;
    (yes(middle) ? high : low) = middle;
  }
}

/// What the filter adds to a radius, and to the way to a limit, times |v|: parts for both places, and for a longer v.
Dyadic allowance(const Shot& shot, double radius, double limit = 0) {
  const Dyadic added = Dyadic(shot.beam.allowance) + Dyadic(balls_of(shot.centre, radius).radius[0]) - Dyadic(radius);
  const Dyadic by_length = Dyadic(radius) * (Dyadic(shot.beam.length) - shot.speed);
  const Dyadic by_square = Dyadic(limit) * (Dyadic(shot.beam.length_squared) - square(shot.speed));
  return added * shot.speed + by_length + by_square;
}

/// The part of the allowance that errors took: 1 less (due − got)/allowance, of lengths times |v|.
double part_taken(const Dyadic& due, const Dyadic& got, const Dyadic& allowed) {
  const double share = ratio(due - got, allowed);
  return 1 - (due < got ? -share : share);
}

class Worst_Parts {
 public:
  void note(const std::string& name, double part) {
    const auto [place, first] = worst_.emplace(name, part);
    if (!first) place->second = std::max(place->second, part);
  }
  void check() const {
    for (const auto& [name, part] : worst_) {
      fmt::print("filter: worst part of the allowance that errors take: {:28} {:.4f}\n", name, part);
      INFO(name);
      CHECK(part <= 1);
    }
  }

 private:
  std::map<std::string, double> worst_;
};

/// A ray that comes from far or near past a ball at a place that is far or near, or at the origin of the numbers.
Shot any_shot(Random& random, bool behind) {
  const auto place = [&] {
    const double size = random.chance(1, 3) ? 0 : random.signed_power(-40, 40);
    return size * random.in_cube(1);
  };
  for (;;) {
    const glm::dvec3 centre = place(), p = place();
    const double size = random.signed_power(-30, 0);
    const glm::dvec3 towards = centre - p, aside = size * random.in_cube(1);
    const double extent = std::abs(towards.x) + std::abs(towards.y) + std::abs(towards.z);
    const glm::dvec3 v = (behind ? -1.0 : 1.0) * towards + extent * aside;
    if (v == glm::dvec3(0)) continue;
    Shot shot{centre, ray(p, v)};
    if (number::sign(shot.B) == (behind ? 1 : -1) && shot.beam.ordinary) return shot;
  }
}

/// The ball that the ray just touches, beside it or behind it.
void measure_radius(Random& random, bool behind, Worst_Parts& parts) {
  const Shot shot = any_shot(random, behind);
  const Dyadic beside = length(cross(shot.q, shot.v));
  if (behind && shot.B < beside) return;
  const Fraction due{behind ? shot.B : beside, shot.speed};
  const double high = 2 * number::round_quotient(due.n, due.w);
  if (passes(shot, 0) || high == 0) return;
  const double got = least(0, high, [&](double radius) { return passes(shot, radius); });
  parts.note(behind ? "a ball behind" : "a ball beside",
             part_taken(due.n, Dyadic(got) * shot.speed, allowance(shot, got)));
}

/// The limit at which a ball begins.
void measure_limit(Random& random, Worst_Parts& parts) {
  const Shot shot = any_shot(random, false);
  const Dyadic beside = length(cross(shot.q, shot.v));
  const double radius = number::round_quotient(beside, shot.speed) * random.uniform(1, 4);
  const Fraction due{-shot.B - Dyadic(radius) * shot.speed, square(shot.speed)};
  if (number::sign(due.n) <= 0) return;
  const double high = 2 * number::round_quotient(due.n, due.w);
  if (passes(shot, radius, 0)) return;
  const double got = least(0, high, [&](double limit) { return passes(shot, radius, limit); });
  // Limits times |v|² are lengths times |v|.
  parts.note("a limit before the ball", part_taken(due.n, Dyadic(got) * due.w, allowance(shot, radius, got)));
}

}  // namespace

TEST_CASE("the filter drops no ball that the ray may meet") {
  Random random(1);
  Worst_Parts parts;
  for (int i = 0; i < 4000; ++i) {
    measure_radius(random, false, parts);
    measure_radius(random, true, parts);
    measure_limit(random, parts);
  }
  parts.check();
}

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
double part_of_padding(const Fraction& way, const surface::Ball& ball, const Dyadic& radius) {
  const Dyadic over = way.n - radius * way.w;
  return number::sign(over) <= 0 ? 0 : ratio(over, (Dyadic(ball.radius) - radius) * way.w);
}

}  // namespace

TEST_CASE("the ball of an element holds all of it") {
  Random random(1);
  double of_cylinder = 0, of_cone = 0;
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
  }
  fmt::print("balls: worst part of what the radius is made greater by: {:.4f} cylinder, {:.4f} cone\n", of_cylinder,
             of_cone);
  CHECK(of_cylinder <= 1);
  CHECK(of_cone <= 1);
}

TEST_CASE("what the filter knows of a ray is greater by as much as is said") {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Shot shot = any_shot(random, false);
    const Dyadic square_of_v = dot(shot.v, shot.v), u(0x1p-53);
    const auto greater_by = [&](double computed, const Dyadic& meant, int least, int most) {
      return Dyadic(computed) >= meant * (Dyadic(1) + Dyadic(least) * u) &&
             Dyadic(computed) <= meant * (Dyadic(1) + Dyadic(most) * u);
    };
    CHECK(greater_by(shot.beam.length_squared, square_of_v, 60, 80));
    CHECK(greater_by(shot.beam.length, shot.speed, 30, 40));
  }
  // A ball's radius is greater by 2⁻⁴⁰ of it: no measurement comes near, as the part for the centre is more.
  CHECK(surface::ball(scene::Cylinder{{0, 0, 0}, 3, {0, 0, 1}, 8}).radius >= 5 * (1 + 0x1p-40));
}
