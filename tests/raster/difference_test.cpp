#include "durero/raster/difference.hpp"

#include <stdexcept>

#include "support/catch.hpp"

using namespace durero;
using namespace durero::raster;

TEST_CASE("the difference has each byte's, and counts pixels") {
  render::Image one({2, 2}), other({2, 2});
  one.rgb = {1, 2, 3, 250, 0, 0, 7, 7, 7, 0, 0, 9};
  other.rgb = {1, 2, 3, 10, 0, 5, 7, 7, 7, 0, 0, 8};
  const PictureDifference apart = difference(one, other);
  CHECK(apart.image.rgb == std::vector<std::uint8_t>{0, 0, 0, 240, 0, 5, 0, 0, 0, 0, 0, 1});
  CHECK(apart.pixels == 2);
  CHECK(apart.greatest == 240);
  CHECK_THROWS_AS(difference(one, render::Image({4, 1})), std::invalid_argument);
}
