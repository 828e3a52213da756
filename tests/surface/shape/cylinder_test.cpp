#include "durero/surface/shape/cylinder.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "support/catch.hpp"

using namespace durero;
using surface::Point;

namespace {

constexpr scene::Cylinder cylinder{{0, 1, 0}, 3, {0, 1, 0}, 8};

}  // namespace

TEST_CASE("the power of a point is that of its distance from the axis, at any advance") {
  for (const double y : {-90.0, 1.0, 5.0, 1000.0}) {
    CHECK(potencia(cylinder, Point<double>{3, y, 0}) == 0);
    CHECK(potencia(cylinder, Point<double>{0, y, 1}) == -8);
    CHECK(potencia(cylinder, Point<double>{4, y, 3}) == 16);
  }
  CHECK(avance(cylinder, Point<double>{3, 7, 0}) == 6);
}

TEST_CASE("the ball and the box of a cylinder reach both rims, and hardly further") {
  const surface::Ball ball = surface::ball(cylinder);
  CHECK(glm::distance(ball.centre, glm::dvec3(0, 5, 0)) <= 0x1p-40);
  CHECK(ball.radius >= 5);  // √(3² + 4²)
  CHECK(ball.radius <= 5 + 0x1p-20);
  const surface::Box box = surface::box(cylinder);
  const glm::dvec3 low(-3, 1, -3), high(3, 9, 3);
  for (int i = 0; i < 3; ++i) {
    CHECK(box.low[i] <= low[i]);
    CHECK(box.high[i] >= high[i]);
    CHECK(std::abs(box.low[i] - low[i]) <= 0x1p-20);
    CHECK(std::abs(box.high[i] - high[i]) <= 0x1p-20);
  }
}
