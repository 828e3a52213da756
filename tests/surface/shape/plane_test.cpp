#include "durero/surface/shape/plane.hpp"

#include "support/catch.hpp"

using namespace durero;
using surface::Point;

namespace {

constexpr scene::Plane plane{{1, 2, 3}, {0, 0, -1}};

}  // namespace

TEST_CASE("the power of a point is its advance along the normal") {
  CHECK(potencia(plane, Point<double>{1, 2, 3}) == 0);
  CHECK(potencia(plane, Point<double>{-100, 50, 3}) == 0);
  CHECK(potencia(plane, Point<double>{0, 0, 0}) == 3);
  CHECK(potencia(plane, Point<double>{0, 0, 5}) == -2);
}

TEST_CASE("along a ray the power of a plane is linear") {
  const model::Rayo ray({0, 0, 0}, {5, 7, 2});
  const surface::Linear<double> power = potencia(plane, surface::along<double>(ray));
  CHECK(power.at_zero == 3);
  CHECK(power.slope == -2);
}

TEST_CASE("only all of space contains a plane") {
  CHECK(surface::ball(plane).radius == std::numeric_limits<double>::infinity());
  CHECK(surface::box(plane).low.x == -std::numeric_limits<double>::infinity());
  CHECK(surface::box(plane).high.z == std::numeric_limits<double>::infinity());
}
