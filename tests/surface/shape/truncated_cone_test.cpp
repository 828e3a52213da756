#include "durero/surface/shape/truncated_cone.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "durero/surface/shape/cone.hpp"
#include "durero/surface/shape/cylinder.hpp"
#include "support/catch.hpp"

using namespace durero;
using surface::Point;

namespace {

/// The radius of the base is 4, that of the top 1 at (0, 6, 0).
constexpr scene::TruncatedCone shape{{0, 0, 0}, 1, 0.5, {0, 1, 0}, 6};

}  // namespace

TEST_CASE("the power of a point is 0 at the radius of its height, above the apex of the double cone too") {
  CHECK(potencia(shape, Point<double>{4, 0, 0}) == 0);
  CHECK(potencia(shape, Point<double>{0, 4, -2}) == 0);
  CHECK(potencia(shape, Point<double>{0, 6, 1}) == 0);
  CHECK(potencia(shape, Point<double>{0, 8, 0}) == 0);
  CHECK(potencia(shape, Point<double>{1, 10, 0}) == 0);
  CHECK(potencia(shape, Point<double>{0, 6, 0}) == -1);
  CHECK(avance(shape, Point<double>{4, 10, 0}) == 10);
}

TEST_CASE("without radius it is a cone, without proportion a cylinder") {
  const Point<double> w{1, 2, -3};
  CHECK(potencia(scene::TruncatedCone{{1, 1, 0}, 0, 0.5, {0, 1, 0}, 6}, w) ==
        potencia(scene::Cone{{1, 1, 0}, 0.5, {0, 1, 0}, 6}, w));
  CHECK(potencia(scene::TruncatedCone{{1, 1, 0}, 2, 0, {0, 1, 0}, 6}, w) ==
        potencia(scene::Cylinder{{1, 1, 0}, 2, {0, 1, 0}, 6}, w));
}

TEST_CASE("the ball and the box of a truncated cone reach its rims, and hardly further") {
  const surface::Ball ball = surface::ball(shape);
  for (const glm::dvec3& w : {glm::dvec3(4, 0, 0), glm::dvec3(0, 0, -4), glm::dvec3(1, 6, 0), glm::dvec3(2.5, 3, 0)})
    CHECK(glm::distance(ball.centre, w) <= ball.radius);
  CHECK(ball.radius <= std::sqrt(16 + 1.75 * 1.75) * (1 + 0x1p-30));  // through both rims, about the height 1.75
  const surface::Box box = surface::box(shape);
  const glm::dvec3 low(-4, 0, -4), high(4, 6, 4);
  for (int i = 0; i < 3; ++i) {
    CHECK(box.low[i] <= low[i]);
    CHECK(box.high[i] >= high[i]);
    CHECK(std::abs(box.low[i] - low[i]) <= 0x1p-20);
    CHECK(std::abs(box.high[i] - high[i]) <= 0x1p-20);
  }
}
