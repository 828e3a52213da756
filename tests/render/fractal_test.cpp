#include "durero/render/fractal.hpp"

#include "support/catch.hpp"
#include "support/threads.hpp"

using namespace durero;
using render::draw_fractal;
using render::Fractal;
using render::Picture;

namespace {

const Fractal sponge = distance::MengerSponge{2}, julia = distance::QuaternionJulia{{-0.2, 0.6, 0.2, 0.2}, 8};

glm::dvec3 pixel(const Picture& picture, std::uint32_t x, std::uint32_t y) {
  return picture.rgb[std::size_t(y) * picture.resolution.width + x];
}

}  // namespace

TEST_CASE("A fractal is drawn with the same numbers for any number of threads") {
  for (const Fractal& fractal : {sponge, julia}) {
    const auto draw = [&] { return draw_fractal(fractal, {32, 20}, 2, {}).rgb; };
    CHECK(test::on_threads(1, draw) == test::on_threads(4, draw));
  }
}

TEST_CASE("A fractal stands on a grey floor, in the light of a sun and a sky") {
  const Picture picture = draw_fractal(sponge, {64, 40}, 16, {});
  const glm::dvec3 wall = pixel(picture, 26, 10), floor = pixel(picture, 58, 36), shadow = pixel(picture, 13, 24);
  CHECK(wall.r > 1.3 * wall.b);                       // of the colour of stone
  CHECK((floor.r < 1.3 * floor.b && floor.r > 0.3));  // grey, and lit
  CHECK(shadow.r < 0.6 * floor.r);                    // the sun is hidden
  CHECK((shadow.b > 0.05 && shadow.b > shadow.r));    // the sky is not
  for (const glm::dvec3& color : picture.rgb) CHECK((color.r >= 0 && color.r < 3));
}

TEST_CASE("Progress is told, and ends at one") {
  double last = 0;
  draw_fractal(sponge, {8, 5}, 1, [&](double share) { last = share; });
  CHECK(last == 1);
}
