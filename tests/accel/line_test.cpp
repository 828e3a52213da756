#include "durero/accel/line.hpp"

#include "durero/conform/random.hpp"
#include "durero/number/rational.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;
using accel::AxisRay;
using accel::PlaneCrossing;
using number::exact;

namespace {

AxisRay line(const glm::dvec3& p, const glm::dvec3& v) { return AxisRay(trace::Ray(ray(p, v))); }

/// By fractions.
int order(const glm::dvec3& p, const glm::dvec3& v, const PlaneCrossing& a, const PlaneCrossing& b) {
  const auto t = [&](const PlaneCrossing& c) {
    return number::Rational((exact(c.plane) - exact(p[c.axis])) / exact(v[c.axis]));
  };
  const int by_t = number::sign(number::Rational(t(a) - t(b)));
  return by_t != 0 ? by_t : static_cast<int>(v[a.axis] < 0) - static_cast<int>(v[b.axis] < 0);
}

}  // namespace

TEST_CASE("crossings come in the order of their parameters, also where these are nearer than any rounding") {
  conform::Random random(1);
  int ties = 0, unlike = 0;
  for (std::size_t i = 0; i < fewer_when_sanitized(40000); ++i) {
    // Through a point of two planes, or nearly: along small integers, scaled, and moved by a last bit at times.
    const glm::dvec3 corner = random.lattice_vector(4), way = random.lattice_vector(5);
    const double scale = random.number(-3, 3), far = random.integer(-9, 9);
    glm::dvec3 p = corner + far * way;
    const glm::dvec3 v = scale * way;
    if (p.x != 0 && random.chance(1, 3)) p.x = std::nextafter(p.x, random.sign() * 100);
    const AxisRay subject = line(p, v);
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) {
        if (v[a] == 0 || v[b] == 0) continue;
        const PlaneCrossing one = subject.crossing(a, corner[a]), other = subject.crossing(b, corner[b]);
        REQUIRE(subject.order(one, other) == order(p, v, one, other));
        if (a != b && subject.order(one, other) == 0) ++ties;
        if (a != b && one.backwards != other.backwards && one.t == other.t) ++unlike;
      }
  }
  CHECK(ties > 1000);
  CHECK(unlike > 1000);
}

TEST_CASE("a crossing is computed within four units of the last place, as its order supposes") {
  conform::Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const double p = random.number(-60, 60), v = random.number(-60, 60), plane = random.number(-60, 60);
    const PlaneCrossing crossing = line({p, 0, 0}, {v, 1, 1}).crossing(0, plane);
    const number::Rational t = (exact(plane) - exact(p)) / exact(v),
                           error = abs(number::Rational(exact(crossing.t) - t));
    REQUIRE(error <= exact(0x1p-51) * abs(exact(crossing.t)));
  }
}

TEST_CASE("a ray along a plane is above it or below it, and crosses it never") {
  for (const double zero : {0.0, -0.0}) {
    const AxisRay subject = line({0, 1, 2}, {1, zero, 0});
    for (const PlaneCrossing& event : {subject.start(), subject.crossing(0, 5), subject.crossing(0, 0x1p100)}) {
      CHECK(subject.above(1, 1, event));
      CHECK(subject.above(1, 0.5, event));
      CHECK_FALSE(subject.above(1, 1.5, event));
      CHECK(subject.order(subject.crossing(1, 1.5), event) > 0);
      CHECK(subject.order(event, AxisRay::end()) < 0);
    }
    CHECK(subject.order(subject.crossing(1, 7), subject.crossing(2, 8)) == 0);
    CHECK(subject.order(subject.crossing(1, 7), AxisRay::end()) < 0);
  }
}

TEST_CASE("in a plane a forward ray is above it, and a backward one is until right after") {
  const AxisRay subject = line({0, 0, 0}, {1, -1, 0});
  const PlaneCrossing forward = subject.crossing(0, 1), backward = subject.crossing(1, -1);
  CHECK(subject.order(forward, backward) < 0);
  CHECK(subject.above(0, 1, forward));
  CHECK(subject.above(1, -1, forward));
  CHECK_FALSE(subject.above(1, -1, backward));
  CHECK(subject.above(0, 0, subject.start()));
  CHECK(subject.above(1, 0, subject.start()));
}

TEST_CASE("what begins beyond the limit is passed over only where it surely does") {
  const AxisRay subject = line({0, 0, 0}, {3, 1, 1});
  const PlaneCrossing third = subject.crossing(0, 1);
  CHECK_FALSE(AxisRay::beyond(third, std::nextafter(1.0 / 3, 0.0)));
  CHECK_FALSE(AxisRay::beyond(third, 1.0 / 3));
  CHECK(AxisRay::beyond(third, 0.333));
  CHECK_FALSE(AxisRay::beyond(subject.start(), 0));
}
