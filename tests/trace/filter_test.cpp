// The filter over balls never passes over a ball that a ray may meet, and how much of what it allows for errors they
// take: a ball is made smaller, or the limit lower, until the filter drops it, and that is compared with where exact
// arithmetic would.
#include "durero/trace/filter.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <string>

#include "durero/conform/random.hpp"
#include "durero/trace/finding.hpp"
#include "support/catch.hpp"
#include "support/exact_ratio.hpp"
#include "support/exact_vector.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;
using conform::Random;
using trace::Ray;

namespace {

/// A ball's centre and a ray.
struct Encounter {
  glm::dvec3 centre;
  model::Rayo rayo;
  Ray traced = Ray(rayo);
  Exact_Vector q = Exact_Vector(rayo.p().xyz()) - Exact_Vector(centre), v = Exact_Vector(rayo.v().xyz());
  Dyadic B = dot(q, v), speed = length(v);
};

trace::Balls balls_of(const glm::dvec3& centre, double radius) {
  trace::Balls balls;
  balls.push_back({centre, radius});
  balls.pad();
  return balls;
}

bool passes(const Encounter& encounter, double radius, double limit = trace::no_limit) {
  std::array<std::uint32_t, trace::Balls::block> passed;
  return filter(balls_of(encounter.centre, radius), encounter.traced, limit, 0, 1, passed.data()) > 0;
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
Dyadic allowance(const Encounter& encounter, double radius, double limit = 0) {
  const Dyadic added =
      Dyadic(encounter.traced.allowance()) + Dyadic(balls_of(encounter.centre, radius).radius[0]) - Dyadic(radius);
  const Dyadic by_length = Dyadic(radius) * (Dyadic(encounter.traced.length()) - encounter.speed);
  const Dyadic by_square = Dyadic(limit) * (Dyadic(encounter.traced.length_squared()) - square(encounter.speed));
  return added * encounter.speed + by_length + by_square;
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
Encounter any_encounter(Random& random, bool behind) {
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
    Encounter encounter{centre, ray(p, v)};
    if (number::sign(encounter.B) == (behind ? 1 : -1) && encounter.traced.ordinary) return encounter;
  }
}

/// The ball that the ray just touches, beside it or behind it.
void measure_radius(Random& random, bool behind, Worst_Parts& parts) {
  const Encounter encounter = any_encounter(random, behind);
  const Dyadic beside = length(cross(encounter.q, encounter.v));
  if (behind && encounter.B < beside) return;
  const Fraction due{behind ? encounter.B : beside, encounter.speed};
  const double high = 2 * number::round_quotient(due.n, due.w);
  if (passes(encounter, 0) || high == 0) return;
  const double got = least(0, high, [&](double radius) { return passes(encounter, radius); });
  parts.note(behind ? "a ball behind" : "a ball beside",
             part_taken(due.n, Dyadic(got) * encounter.speed, allowance(encounter, got)));
}

/// The limit at which a ball begins.
void measure_limit(Random& random, Worst_Parts& parts) {
  const Encounter encounter = any_encounter(random, false);
  const Dyadic beside = length(cross(encounter.q, encounter.v));
  const double radius = number::round_quotient(beside, encounter.speed) * random.uniform(1, 4);
  const Fraction due{-encounter.B - Dyadic(radius) * encounter.speed, square(encounter.speed)};
  if (number::sign(due.n) <= 0) return;
  const double high = 2 * number::round_quotient(due.n, due.w);
  if (passes(encounter, radius, 0)) return;
  const double got = least(0, high, [&](double limit) { return passes(encounter, radius, limit); });
  // Limits times |v|² are lengths times |v|.
  parts.note("a limit before the ball", part_taken(due.n, Dyadic(got) * due.w, allowance(encounter, radius, got)));
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
