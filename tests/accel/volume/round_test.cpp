#include "durero/accel/volume/round.hpp"

#include <cmath>

#include "durero/scene/shapes.hpp"
#include "durero/trace/finding.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;
using accel::Ellipsoid;
using accel::verdict;
using accel::VolumeTest;

namespace {

template <class V>
VolumeTest of(const V& volume, const glm::dvec3& p, const glm::dvec3& v, double limit = trace::no_limit) {
  return verdict(volume, trace::Ray(ray(p, v)), limit);
}

}  // namespace

TEST_CASE("a ball is met, missed, or lies behind or beyond the limit") {
  const surface::Ball ball{{0, 0, 0}, 1};
  CHECK(of(ball, {-3, 0, 0}, {1, 0, 0}) == VolumeTest::met);
  CHECK(of(ball, {-3, 0, 0}, {1, 0, 0}, 2) == VolumeTest::met);
  CHECK(of(ball, {-3, 0, 0}, {1, 0, 0}, 1.9) == VolumeTest::beyond);
  CHECK(of(ball, {3, 0, 0}, {1, 0, 0}) == VolumeTest::missed);
  CHECK(of(ball, {-3, 1.1, 0}, {1, 0, 0}) == VolumeTest::missed);
  CHECK(of(ball, {0, 0, 0}, {1, 0, 0}, 0.1) == VolumeTest::met);
}

TEST_CASE("an ellipsoid is met where it is, in its proportions") {
  const Ellipsoid tall{{0, 0, 0}, {0, 0, 1}, 0.5, 1};  // of radius 1 and half height 2
  CHECK(of(tall, {-3, 0, 1.9}, {1, 0, 0}) == VolumeTest::met);
  CHECK(of(tall, {-3, 0, 2.1}, {1, 0, 0}) == VolumeTest::missed);
  CHECK(of(tall, {-3, 0.9, 0}, {1, 0, 0}) == VolumeTest::met);
  CHECK(of(tall, {-3, 1.1, 0}, {1, 0, 0}) == VolumeTest::missed);
  CHECK(of(tall, {0, 0, -5}, {0, 0, 1}, 3) == VolumeTest::met);
  CHECK(of(tall, {0, 0, -5}, {0, 0, 1}, 2.9) == VolumeTest::beyond);
  CHECK(of(tall, {0, 0, 5}, {0, 0, 1}) == VolumeTest::missed);
}

TEST_CASE("the ellipsoid around a cylinder is the least, and that around a ball the ball") {
  const Ellipsoid around = ellipsoid_around(accel::outline(scene::Cylinder{{0, 0, -3}, 2, {0, 0, 1}, 6}));
  CHECK(around.rho == Approx(2 * std::sqrt(1.5)));
  CHECK(around.rho / around.lambda == Approx(3 * std::sqrt(3.0)));
  const Ellipsoid ball = ellipsoid_around(accel::outline(scene::Sphere{{1, 2, 3}, 2}));
  CHECK(ball.lambda == 1);
  CHECK(ball.rho == 2);
  const Ellipsoid flat = ellipsoid_around(accel::outline(scene::Disc{{1, 2, 3}, 2, {1, 0, 0}}));
  CHECK(flat.lambda == 1024);
  CHECK(flat.rho == Approx(2));
}

TEST_CASE("rays that touch exactly meet, from near and from afar, whatever is rounded") {
  // With whole numbers a and b the point (2ab, b² − a², 0) of a ball of radius a² + b² is touched along (a² − b², 2ab,
  // 0): all of that is whole, and below 2⁵³ however far the ray starts, but not the products that a test makes of it.
  Random random(1);
  for (std::size_t i = 0; i < fewer_when_sanitized(20000); ++i) {
    const int most = random.chance(1, 2) ? 4096 : 8;
    const double a = random.integer(1, most), b = random.integer(1, most),
                 away = std::ldexp(1.0, random.integer(0, 26));
    const glm::dvec3 centre = random.lattice_vector(1 << 20), v(a * a - b * b, 2 * a * b, 0);
    const glm::dvec3 p = centre + glm::dvec3(2 * a * b, b * b - a * a, 0) - away * v;
    const double radius = a * a + b * b, scale = std::ldexp(1.0, random.integer(-40, 40));
    const auto check = [&](const auto& volume) { REQUIRE(of(volume, scale * p, scale * v, away) == VolumeTest::met); };
    check(surface::Ball{scale * centre, scale * radius});
    check(Ellipsoid{scale * centre, {0, 0, 1}, std::ldexp(1.0, random.integer(-10, 10)), scale * radius});
    check(Ellipsoid{scale * centre, random.direction(), 1, scale * radius});
  }
}
