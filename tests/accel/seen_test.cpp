#include "durero/accel/seen.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "durero/conform/random.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"

using namespace durero;
using namespace durero::test;
using accel::ApparentBall;
using accel::DirectionCone;
using surface::Ball;

TEST_CASE("from within a ball it is seen everywhere, from outside where it lies") {
  CHECK(accel::seen({{1, 2, 3}, 1}, {1, 2.5, 3}).around);
  CHECK(accel::seen({{1, 2, 3}, 1}, {1, 3, 3}).around);
  CHECK(accel::seen({{1, 2, 3}, HUGE_VAL}, {0, 0, 0}).around);
  CHECK(accel::seen({{1, 2, 3}, 0}, {1, 2, 3}).around);
  const ApparentBall ball = accel::seen({{4, 0, 0}, 2}, {0, 0, 0});
  CHECK_FALSE(ball.around);
  CHECK(ball.towards == glm::dvec3(1, 0, 0));
  CHECK(ball.sine == Approx(0.5));
  CHECK(ball.sine >= 0.5);
  CHECK(ball.near <= 2);
  CHECK(ball.near == Approx(2));
  CHECK(ball.far >= 6);
}

TEST_CASE("a ball in whose direction a cone has a direction is seen in the cone") {
  conform::Random random(1);
  int seen = 0, unseen = 0;
  for (int i = 0; i < static_cast<int>(fewer_when_sanitized(100'000)); ++i) {
    const glm::dvec3 from = random.in_cube(2), middle = random.in_cube(4);
    const Ball ball{middle, random.uniform(0.01, 1.5)};
    const double angle = random.uniform(0.001, 1.5);
    const DirectionCone cone = accel::cone(random.direction(), std::cos(angle), 0);
    const ApparentBall as_seen = accel::seen(ball, from);
    const glm::dvec3 point = middle + random.direction() * ball.radius * 0.999999;
    const double away = std::acos(accel::cosine_between(cone.axis, accel::direction(point - from)));
    if (away < angle && !accel::may_be_seen(as_seen, cone)) FAIL("missed: " << i);
    const double between = std::acos(accel::cosine_between(cone.axis, accel::direction(middle - from)));
    const double distance = std::sqrt(glm::dot(middle - from, middle - from));
    if (distance <= ball.radius) continue;
    const bool truly = between < angle + std::asin(ball.radius / distance) + 1e-6;
    if (accel::may_be_seen(as_seen, cone) && !truly) FAIL("seen beside it: " << i);
    ++(truly ? seen : unseen);
  }
  CHECK(seen > unseen / 10);
  CHECK(unseen > seen / 10);
}

TEST_CASE("a cone is covered where all of it is within an angle of the centre") {
  const ApparentBall ball = accel::seen({{2, 0, 0}, 1}, {0, 0, 0});  // 30° about the axis
  CHECK(is_covered(accel::cone({1, 0, 0}, std::cos(0.5), 0), ball, 0.5));
  CHECK_FALSE(is_covered(accel::cone({1, 0, 0}, std::cos(0.53), 0), ball, 0.5));
  CHECK_FALSE(is_covered(accel::cone({1, 0.1, 0}, std::cos(0.5), 0), ball, 0.5));
  CHECK(is_covered(accel::cone({1, 0.1, 0}, std::cos(0.4), 0), ball, 0.5));
  CHECK_FALSE(is_covered(accel::cone({-1, 0, 0}, std::cos(0.4), 0), ball, 0.5));
  CHECK_FALSE(is_covered(accel::cone({1, 0, 0}, std::cos(0.4), 0), accel::seen({{2, 0, 0}, 3}, {0, 0, 0}), 0.5));
}
