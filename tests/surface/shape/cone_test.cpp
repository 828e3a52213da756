#include "durero/surface/shape/cone.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "support/catch.hpp"

using namespace durero;
using surface::Point;

namespace {

/// The radius of the base is 4, and the apex at (0, 8, 0).
constexpr scene::Cone cone{{0, 0, 0}, 0.5, {0, 1, 0}, 8};

}  // namespace

TEST_CASE("the power of a point is 0 where the distance from the axis is the radius there, on both nappes") {
  CHECK(potencia(cone, Point<double>{4, 0, 0}) == 0);
  CHECK(potencia(cone, Point<double>{0, 4, -2}) == 0);
  CHECK(potencia(cone, Point<double>{0, 8, 0}) == 0);
  CHECK(potencia(cone, Point<double>{1, 10, 0}) == 0);
  CHECK(potencia(cone, Point<double>{0, 0, 0}) == -16);
  CHECK(potencia(cone, Point<double>{1, 8, 0}) == 1);
  CHECK(avance(cone, Point<double>{4, 10, 0}) == 10);
}

TEST_CASE("the ball and the box of a cone reach its rim and its apex, and the box hardly further") {
  const surface::Ball ball = surface::ball(cone);
  for (const glm::dvec3& w : {glm::dvec3(4, 0, 0), glm::dvec3(0, 0, -4), glm::dvec3(0, 8, 0), glm::dvec3(2, 4, 0)})
    CHECK(glm::distance(ball.centre, w) <= ball.radius);
  CHECK(ball.radius <= 8);
  const surface::Box box = surface::box(cone);
  const glm::dvec3 low(-4, 0, -4), high(4, 8, 4);
  for (int i = 0; i < 3; ++i) {
    CHECK(box.low[i] <= low[i]);
    CHECK(box.high[i] >= high[i]);
    CHECK(std::abs(box.low[i] - low[i]) <= 0x1p-20);
    CHECK(std::abs(box.high[i] - high[i]) <= 0x1p-20);
  }
}
