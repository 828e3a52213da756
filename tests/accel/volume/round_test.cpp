#include "durero/accel/volume/round.hpp"

#include <cmath>

#include "durero/scene/shapes.hpp"
#include "durero/trace/finding.hpp"
#include "support/catch.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;
using accel::Ellipsoid;
using accel::verdict;
using accel::Verdict;

namespace {

template <class V>
Verdict of(const V& volume, const glm::dvec3& p, const glm::dvec3& v, double limit = trace::no_limit) {
  return verdict(volume, trace::Ray(ray(p, v)), limit);
}

}  // namespace

TEST_CASE("a ball is met, missed, or lies behind or beyond the limit") {
  const surface::Ball ball{{0, 0, 0}, 1};
  CHECK(of(ball, {-3, 0, 0}, {1, 0, 0}) == Verdict::met);
  CHECK(of(ball, {-3, 0, 0}, {1, 0, 0}, 2) == Verdict::met);
  CHECK(of(ball, {-3, 0, 0}, {1, 0, 0}, 1.9) == Verdict::beyond);
  CHECK(of(ball, {3, 0, 0}, {1, 0, 0}) == Verdict::missed);
  CHECK(of(ball, {-3, 1.1, 0}, {1, 0, 0}) == Verdict::missed);
  CHECK(of(ball, {0, 0, 0}, {1, 0, 0}, 0.1) == Verdict::met);
}

TEST_CASE("an ellipsoid is met where it is, in its proportions") {
  const Ellipsoid tall{{0, 0, 0}, {0, 0, 1}, 0.5, 1};  // of radius 1 and half height 2
  CHECK(of(tall, {-3, 0, 1.9}, {1, 0, 0}) == Verdict::met);
  CHECK(of(tall, {-3, 0, 2.1}, {1, 0, 0}) == Verdict::missed);
  CHECK(of(tall, {-3, 0.9, 0}, {1, 0, 0}) == Verdict::met);
  CHECK(of(tall, {-3, 1.1, 0}, {1, 0, 0}) == Verdict::missed);
  CHECK(of(tall, {0, 0, -5}, {0, 0, 1}, 3) == Verdict::met);
  CHECK(of(tall, {0, 0, -5}, {0, 0, 1}, 2.9) == Verdict::beyond);
  CHECK(of(tall, {0, 0, 5}, {0, 0, 1}) == Verdict::missed);
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

TEST_CASE("rays that touch exactly meet, from near and from afar") {
  // (4, −3, 0) of the ball of radius 5, along (3, 4, 0); scaled and moved by whole numbers nothing is rounded.
  for (const double scale : {1.0, 0x1p-60, 0x1p60, 7.0})
    for (const double away : {1.0, 1e3, 1e6, 1e9, 1e12}) {
      const glm::dvec3 centre = scale * glm::dvec3(1, 2, 3), v = scale * glm::dvec3(3, 4, 0);
      const glm::dvec3 p = scale * (glm::dvec3(1 + 4, 2 - 3, 3) - away * glm::dvec3(3, 4, 0));
      CHECK(of(surface::Ball{centre, 5 * scale}, p, v, away) == Verdict::met);
      CHECK(of(Ellipsoid{centre, {0, 0, 1}, 1, 5 * scale}, p, v, away) == Verdict::met);
      CHECK(of(Ellipsoid{centre, {0, 0, 1}, 0x1p-10, 5 * scale}, p, v, away) == Verdict::met);
      CHECK(of(Ellipsoid{centre, {0, 0, 1}, 0x1p10, 5 * scale}, p, v, away) == Verdict::met);
    }
}
