#include "durero/render/output/image.hpp"

#include <png.h>

#include <limits>
#include <stdexcept>

#include "support/catch.hpp"

using namespace durero;

TEST_CASE("a component out of range is cut, and no number is black") {
  const double infinity = std::numeric_limits<double>::infinity();
  render::Image image({2, 1});
  image.set(0, 0, {-3, 7, 0.2});
  image.set(1, 0, {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()});
  CHECK(image.rgb == std::vector<std::uint8_t>{0, 255, 124, 255, 0, 0});
}

TEST_CASE("a PNG says that its pixels are sRGB") {
  const std::string bytes = render::encode_png(render::Image({1, 1}));
  const std::size_t chunk = bytes.find("sRGB");
  REQUIRE(chunk != bytes.npos);
  CHECK(bytes.substr(chunk - 4, 9) == std::string("\0\0\0\1sRGB\0", 9));  // one byte: the perceptual intent
  CHECK(chunk < bytes.find("IDAT"));
  // For readers that do not know it, the nearest gamma, 1/2.2 in 100000ths, and the primaries.
  CHECK(bytes.find(std::string("gAMA\0\0\xB1\x8F", 8)) < bytes.find("IDAT"));
  CHECK(bytes.find("cHRM") < bytes.find("IDAT"));
}

TEST_CASE("a PNG carries its notes along: ASCII in tEXt, other text in iTXt, and nothing else") {
  const render::Image image({1, 1});
  const render::Note notes[] = {{"Software", "Durero"}, {"Comment", "durero render größer.json"}};
  const std::string bytes = render::encode_png(image, notes);
  CHECK(bytes.find(std::string("\0\0\0\x0FtEXtSoftware\0Durero", 23)) < bytes.find("IDAT"));
  CHECK(bytes.find(std::string("iTXtComment\0\0\0\0\0", 16) + notes[1].text) < bytes.find("IDAT"));
  CHECK(bytes.find("tIME") == bytes.npos);
  CHECK(bytes == render::encode_png(image, notes));
  const std::string without = render::encode_png(image);
  CHECK(without.find("EXt") == without.npos);
  CHECK(without.find("TXt") == without.npos);
}

TEST_CASE("what libpng refuses is said") {
  CHECK_THROWS_AS(render::encode_png(render::Image({0, 1})), std::runtime_error);
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
