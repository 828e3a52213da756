#include "durero/render/image.hpp"

#include <png.h>

#include "support/catch.hpp"

using namespace durero;

TEST_CASE("colours are cut to [0, 1] and rounded to 255 steps") {
  render::Image image({2, 1});
  image.set(0, 0, {0, 0.5, 1});
  image.set(1, 0, {-3, 7, 0.2});
  CHECK(image.rgb == std::vector<std::uint8_t>{0, 128, 255, 0, 255, 51});
}

TEST_CASE("a PNG reads back to the same pixels, and the same image gives the same bytes") {
  render::Image image({5, 3});
  for (std::uint32_t y = 0; y < 3; ++y)
    for (std::uint32_t x = 0; x < 5; ++x) image.set(x, y, {x / 4.0, y / 2.0, 0.25});
  const std::string bytes = render::encode_png(image);
  CHECK(bytes == render::encode_png(image));

  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  REQUIRE(png_image_begin_read_from_memory(&header, bytes.data(), bytes.size()));
  CHECK(header.width == 5);
  CHECK(header.height == 3);
  header.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> read(PNG_IMAGE_SIZE(header));
  REQUIRE(png_image_finish_read(&header, nullptr, read.data(), 0, nullptr));
  CHECK(read == image.rgb);
}
