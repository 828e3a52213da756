#include "durero/scene/srgb.hpp"

#include <cmath>

#include "support/catch.hpp"

using namespace durero;

TEST_CASE("the curve of sRGB and its inverse give each other's values, and meet where the line ends") {
  for (int i = 0; i <= 1000; ++i) {
    const double value = i / 1000.0;
    CHECK(std::abs(scene::srgb_of_linear(scene::linear_of_srgb(value)) - value) < 1e-5);
  }
  CHECK(scene::linear_of_srgb(0) == 0);
  CHECK(scene::linear_of_srgb(1) == 1);
  CHECK(std::abs(scene::srgb_of_linear(0.18) - 0.46136) < 1e-5);
  CHECK(std::abs(scene::linear_of_srgb(0.46136) - 0.18) < 1e-5);
}

TEST_CASE("a linear component goes through the sRGB curve and is rounded to 255 steps") {
  using scene::srgb_byte;
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
    CHECK(scene::srgb_byte(value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4)) == byte);
  }
}

TEST_CASE("every byte is that whose step holds the value: no linear component is farther than half a step off") {
  // Steps of the curve, in long double by its inverse: byte b is for values in [(b − ½)/255, (b + ½)/255).
  const auto linear = [](long double value) {
    return value <= 0.04045L ? value / 12.92L : std::pow((value + 0.055L) / 1.055L, 2.4L);
  };
  for (int byte = 0; byte < 255; ++byte) {
    const auto border = static_cast<double>(linear((byte + 0.5L) / 255));
    CHECK(scene::srgb_byte(border * (1 - 1e-7)) == byte);
    CHECK(scene::srgb_byte(border * (1 + 1e-7)) == byte + 1);
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
      if (scene::srgb_byte(c) != by_the_curve(c)) FAIL(c);
  CHECK(scene::srgb_byte(std::nextafter(0.0031308, 1)) == by_the_curve(std::nextafter(0.0031308, 1)));
}

TEST_CASE("a colour as text has two digits for each of red, green and blue, cut at both ends") {
  CHECK(scene::srgb_text({0, 1, 0.0033}) == "#00ff0b");
  CHECK(scene::srgb_text({-1, 7, 1}) == "#00ffff");
}
