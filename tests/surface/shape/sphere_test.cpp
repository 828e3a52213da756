#include "durero/surface/shape/sphere.hpp"

#include "support/catch.hpp"

using namespace durero;
using surface::Point;

namespace {

constexpr scene::Sphere sphere{{1, 2, 3}, 2};

}  // namespace

TEST_CASE("the power of a point is 0 on the sphere, negative inside, positive outside") {
  CHECK(potencia(sphere, Point<double>{3, 2, 3}) == 0);
  CHECK(potencia(sphere, Point<double>{1, 2, 1}) == 0);
  CHECK(potencia(sphere, Point<double>{1, 2, 3}) == -4);
  CHECK(potencia(sphere, Point<double>{3, 2, 4}) == 1);
}

TEST_CASE("the ball and the box of a sphere reach its points, and hardly further") {
  const surface::Ball ball = surface::ball(sphere);
  const surface::Box box = surface::box(sphere);
  CHECK(ball.centre == sphere.centro);
  CHECK(ball.radius >= 2);
  CHECK(ball.radius <= 2 + 0x1p-40);
  for (int i = 0; i < 3; ++i) {
    CHECK(box.low[i] <= sphere.centro[i] - 2);
    CHECK(box.low[i] >= sphere.centro[i] - 2 - 0x1p-40);
    CHECK(box.high[i] >= sphere.centro[i] + 2);
    CHECK(box.high[i] <= sphere.centro[i] + 2 + 0x1p-40);
  }
}
