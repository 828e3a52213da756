#include "io/mesh/rounded_map.hpp"

#include <algorithm>
#include <cmath>

#include "support/catch.hpp"
#include "support/doubles.hpp"
#include "support/property.hpp"

using namespace durero;
using io::AffineMap;
using io::RoundedMap;

namespace {

glm::dvec3 vector_of(const rc::Gen<double>& number) { return {*number, *number, *number}; }

/// A map that scales, turns and shifts by so much.
AffineMap turned(const rc::Gen<double>& number, const glm::dvec3& shift) {
  const std::array<double, 4> rotation{*number, *number, *number, *number};
  RC_PRE(std::ranges::count(rotation, 0) < 4);
  return AffineMap::of_parts(shift, rotation, vector_of(number));
}

bool agree(const AffineMap& map, const glm::dvec3& p, double denominator = 1) {
  const glm::dvec3 exact = map.point(p, denominator), quick = RoundedMap(map).point(p, denominator);
  return exact == quick && std::signbit(exact.x) == std::signbit(quick.x);
}

}  // namespace

TEST_CASE("a map made ready for many points gives the images of the exact one") {
  test::property("of ordinary numbers", [] {
    const auto numbers = *rc::gen::element(test::moderate(), test::dyadicGrid());
    const AffineMap map = turned(numbers, vector_of(numbers)).after(turned(numbers, vector_of(numbers)));
    RC_ASSERT(agree(map, vector_of(numbers)));
    RC_ASSERT(agree(map, vector_of(numbers), 255));
  });
  test::property("of numbers of every size", [] {
    const auto numbers = test::anyFinite();
    RC_ASSERT(agree(turned(numbers, vector_of(numbers)), vector_of(numbers)));
    RC_ASSERT(agree(AffineMap::of_parts(vector_of(numbers), {0, 0, 0, 1}, vector_of(numbers)), vector_of(numbers)));
  });
  test::property("where the shift takes the image away, but for its rounding", [] {
    const auto numbers = test::moderate();
    const AffineMap linear = turned(numbers, {0, 0, 0});
    const glm::dvec3 p = vector_of(numbers);
    const AffineMap back = AffineMap::of_parts(-linear.point(p, 1), {0, 0, 0, 1}, {1, 1, 1});
    RC_ASSERT(agree(back.after(linear), p));
  });
}

TEST_CASE("an image by the middle of two numbers is taken from the exact map") {
  constexpr double a = 0x1p-20;
  const auto scaled = [](double by) { return AffineMap::of_parts({0, 0, 0}, {0, 0, 0, 1}, {by, 1, 1}); };
  const AffineMap one = AffineMap::of_parts({1, 0, 0}, {0, 0, 0, 1}, {1, 1, 1});
  // 1 + 2⁻⁵³ · (1 + a)(1 − a + a²) = 1 + 2⁻⁵³ + 2⁻¹¹³, and the same with the other sign of a.
  const AffineMap above = one.after(scaled(0x1p-53 * (1 + a))).after(scaled(1 - a + a * a));
  const AffineMap below = one.after(scaled(0x1p-53 * (1 - a))).after(scaled(1 + a + a * a));
  CHECK(RoundedMap(above).point({1, 0, 0}, 1).x == 1 + 0x1p-52);
  CHECK(RoundedMap(below).point({1, 0, 0}, 1).x == 1);
  // 1 + 3 · 2⁻⁵³ − 3 · 2⁻¹¹³, whose leading double lies above it.
  const AffineMap under = one.after(scaled(0x1.8p-52 * (1 - a))).after(scaled(1 + a + a * a));
  CHECK(RoundedMap(under).point({1, 0, 0}, 1).x == 1 + 0x1p-52);
  CHECK(RoundedMap(one).point({0x1p-53, 0, 0}, 1).x == 1);
  CHECK(RoundedMap(one).point({0x1.8p-52, 0, 0}, 1).x == 1 + 0x1p-51);
}
