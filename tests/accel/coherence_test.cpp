#include "durero/accel/coherence.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "durero/surface/exact_element.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;
using surface::Ball;

namespace {

/// Exactly. Precondition: the origin lies outside the ball.
bool meets(const model::Rayo& rayo, const Ball& ball) {
  return !surface::exact::reach(scene::Sphere{ball.centre, ball.radius}, rayo).empty();
}

double angle(const glm::dvec3& a, const glm::dvec3& b) {
  return std::acos(std::clamp(glm::dot(glm::normalize(a), glm::normalize(b)), -1.0, 1.0));
}

/// A point in the ball, often near its surface.
glm::dvec3 point_in(Random& random, const Ball& ball) {
  const glm::dvec3 out = random.direction();
  return ball.centre + out * ball.radius * random.any_of(std::array{0.0, 0.5, 0.999, 0.999999999999});
}

/// A ray from one ball that touches both on either side of the centres' line, turned by `inwards` from that.
model::Rayo tangent(Random& random, const Ball& from, const Ball& to, double inwards) {
  const glm::dvec3 along = to.centre - from.centre;
  const glm::dvec3 across = glm::normalize(glm::cross(along, random.direction()));
  const double most = std::asin((from.radius + to.radius) / glm::length(along)), turned = most - inwards;
  const glm::dvec3 unit = glm::normalize(along);
  const glm::dvec3 out = std::cos(most) * across - std::sin(most) * unit;  // across the tangent
  return ray(from.centre - from.radius * out, std::cos(turned) * unit + std::sin(turned) * across);
}

}  // namespace

TEST_CASE("a ray that starts in a ball and meets another goes in a direction within the bound") {
  Random random(1);
  std::size_t met = 0, beside = 0;
  const std::size_t all = fewer_when_sanitized(100'000);
  for (std::size_t i = 0; i < all; ++i) {
    const Ball from{random.in_cube(2), random.uniform(0.01, 1)}, to{random.in_cube(4), random.uniform(0.01, 1)};
    const glm::dvec3 along = to.centre - from.centre;
    const double sum = from.radius + to.radius, d = glm::length(along);
    if (d < 1.001 * sum) {
      if (d < sum) CHECK(accel::may_reach(from, random.direction(), to));
      continue;
    }
    const glm::dvec3 p = point_in(random, from);
    const glm::dvec3 q = point_in(random, random.chance(3, 4) ? to : Ball{to.centre, 3 * to.radius});
    const model::Rayo rayo = ray(p, q - p);
    const bool may = accel::may_reach(from, accel::direction(q - p), to);
    if (meets(rayo, to)) {
      ++met;
      INFO("pair " << i);
      REQUIRE(may);
    }
    if (angle(q - p, along) > std::asin(sum / d) + 1e-6) {
      ++beside;
      INFO("pair " << i);
      REQUIRE_FALSE(may);
    }
  }
  CHECK(met > all / 4);
  CHECK(beside > all / 100);
}

TEST_CASE("the bound is attained by the tangents that cross between the balls") {
  Random random(2);
  std::size_t met = 0;
  for (int i = 0; i < 1000; ++i) {
    const Ball from{random.in_cube(1), random.uniform(0.1, 1)};
    const glm::dvec3 towards = random.direction();
    const Ball to{from.centre + towards * random.uniform(2.5, 9), random.uniform(0.1, 1)};
    const model::Rayo inside = tangent(random, from, to, 1e-5), beyond = tangent(random, from, to, -1e-5);
    met += meets(inside, to);
    CHECK(accel::may_reach(from, accel::direction(inside.v().xyz()), to));
    CHECK_FALSE(meets(beyond, to));
    CHECK_FALSE(accel::may_reach(from, accel::direction(beyond.v().xyz()), to));
  }
  CHECK(met == 1000);
}

TEST_CASE("no point of the one ball is nearer to one of the other than the bound says") {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const Ball from{random.in_cube(1), random.uniform(0.1, 1)}, to{random.in_cube(6), random.uniform(0.1, 1)};
    const double gap = glm::length(to.centre - from.centre) - from.radius - to.radius;
    const accel::ApparentBall seen = accel::seen_from_within(from, to);
    CHECK(seen.around == !(gap > 1e-12));
    if (seen.around) continue;
    CHECK(seen.near <= gap);
    CHECK(seen.near >= gap - 1e-12);
  }
}
