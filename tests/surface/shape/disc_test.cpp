#include "durero/surface/shape/disc.hpp"

#include "support/catch.hpp"

using namespace durero;
using surface::Point;

namespace {

constexpr scene::Disc disc{{1, 2, 3}, 4, {0, 0, -1}};

}  // namespace

TEST_CASE("the power of a point is that of the plane of a disc") {
  CHECK(potencia(disc, Point<double>{1, 2, 3}) == 0);
  CHECK(potencia(disc, Point<double>{-100, 50, 3}) == 0);
  CHECK(potencia(disc, Point<double>{0, 0, 0}) == 3);
}

TEST_CASE("along a ray the power of a disc is linear") {
  const surface::Linear<double> power = potencia(disc, surface::along<double>(model::Rayo({0, 0, 0}, {5, 7, 2})));
  CHECK(power.at_zero == 3);
  CHECK(power.slope == -2);
}

TEST_CASE("a ball about its centre contains a disc, and a box that is flat but for roundings") {
  CHECK(surface::ball(disc).centre == disc.centro);
  CHECK(surface::ball(disc).radius == 4);
  const surface::Box box = surface::box(disc);
  CHECK(box.low.x <= -3);
  CHECK(box.low.x > -3 - 0x1p-30);
  CHECK(box.high.y >= 6);
  CHECK(box.high.y < 6 + 0x1p-30);
  CHECK(box.low.z <= 3);
  CHECK(box.high.z >= 3);
  CHECK(box.high.z - box.low.z < 0x1p-20);  // a radius by the root of 2⁻⁴⁷
}
