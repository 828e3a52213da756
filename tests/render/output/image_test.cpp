#include "durero/render/output/image.hpp"

#include <png.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "support/catch.hpp"

using namespace durero;

TEST_CASE("a linear component goes through the sRGB curve and is rounded to 255 steps") {
  using render::srgb_byte;
  CHECK(srgb_byte(0) == 0);
  CHECK(srgb_byte(0.001) == 3);       // 12.92 · 0.001 · 255 = 3.29
  CHECK(srgb_byte(0.0031308) == 10);  // 10.31, where the curve leaves the straight line
  CHECK(srgb_byte(0.0033) == 11);     // 1.055 · 0.0033^(1/2.4) − 0.055 = 0.04208; the line would say 10.87
  CHECK(srgb_byte(0.02) == 39);       // 0.15170; the line would say 66
  CHECK(srgb_byte(0.18) == 118);      // the grey card, 0.46136
  CHECK(srgb_byte(0.5) == 188);       // 0.73536
  CHECK(srgb_byte(0.999) == 255);     // 0.99956
  CHECK(srgb_byte(1) == 255);
  const double half = 0.5 / 255 / 12.92;  // halfway between the bytes 0 and 1, but for rounding
  CHECK(srgb_byte(half * (1 - 0x1p-50)) == 0);
  CHECK(srgb_byte(half * (1 + 0x1p-50)) == 1);
}

TEST_CASE("every byte comes from the colour that its value on the curve stands for") {
  for (int byte = 0; byte < 256; ++byte) {
    const double value = byte / 255.0;  // the inverse of the curve, as the standard gives it
    CHECK(render::srgb_byte(value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4)) == byte);
  }
}

TEST_CASE("a component out of range is cut, and no number is black") {
  const double infinity = std::numeric_limits<double>::infinity();
  render::Image image({2, 1});
  image.set(0, 0, {-3, 7, 0.2});
  image.set(1, 0, {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()});
  CHECK(image.rgb == std::vector<std::uint8_t>{0, 255, 124, 255, 0, 0});
}

TEST_CASE("every byte is that whose step holds the value: no linear component is farther than half a step off") {
  // Steps of the curve, in long double by its inverse: byte b is for values in [(b − ½)/255, (b + ½)/255).
  const auto linear = [](long double value) {
    return value <= 0.04045L ? value / 12.92L : std::pow((value + 0.055L) / 1.055L, 2.4L);
  };
  for (int byte = 0; byte < 255; ++byte) {
    const auto border = static_cast<double>(linear((byte + 0.5L) / 255));
    CHECK(render::srgb_byte(border * (1 - 1e-7)) == byte);
    CHECK(render::srgb_byte(border * (1 + 1e-7)) == byte + 1);
  }
}

TEST_CASE("bytes that are looked up are those that the curve gives, on either side of what is looked up") {
  const auto by_the_curve = [](double c) {
    const double value = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
    return static_cast<int>(std::floor(value * 255 + 0.5));
  };
  constexpr int parts = 1 << 16;
  for (int i = 1; i < parts; ++i)
    for (const double c : {double(i) / parts, std::nextafter(double(i) / parts, 0), (i - 0.5) / parts})
      if (render::srgb_byte(c) != by_the_curve(c)) FAIL(c);
  CHECK(render::srgb_byte(std::nextafter(0.0031308, 1)) == by_the_curve(std::nextafter(0.0031308, 1)));
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
