#include "durero/accel/slab.hpp"

#include <limits>

#include "support/catch.hpp"
#include "support/property.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
const surface::Box unit{{-1, -1, -1}, {1, 1, 1}};

accel::BoxInterval of(const glm::dvec3& p, const glm::dvec3& v, double limit = infinity) {
  return stretch(unit, accel::Beam(trace::Ray(ray(p, v))), limit);
}

}  // namespace

TEST_CASE("a box is entered and left where its planes are crossed") {
  const accel::BoxInterval through = of({-3, 0, 0}, {1, 0, 0});
  CHECK(through.entry == 2);
  CHECK(through.exit == 4);
  CHECK(through.meets());
  CHECK(of({0, 0, 0}, {0, 0, -1}).entry == 0);
  CHECK(of({-3, 0, 0}, {1, 0, 0}, 2).meets());
}

TEST_CASE("a box that the ray misses, that is behind it, or beyond the limit is not met") {
  CHECK_FALSE(of({-3, 1.5, 0}, {1, 0, 0}).meets());
  CHECK_FALSE(of({-3, 3, 0}, {1, 1, 0}).meets());
  CHECK_FALSE(of({3, 0, 0}, {1, 0, 0}).meets());
  CHECK_FALSE(of({-3, 0, 0}, {1, 0, 0}, 1.875).meets());
}

TEST_CASE(
    "a ray in the plane of a face, along an edge or through a corner meets the box, whatever the signs of zeros") {
  for (const double zero : {0.0, -0.0}) {
    CHECK(of({-3, 1, 0}, {1, zero, zero}).meets());
    CHECK(of({-3, 1, -1}, {1, zero, zero}).meets());
    CHECK(of({-3, -1, -1}, {1, 1, zero}).meets());
    CHECK_FALSE(of({-3, -2.5, -1}, {1, 0.125, zero}).meets());
    CHECK(of({-2, 0, 1}, {1, 1, zero}).meets());
    CHECK(of({zero, zero, zero}, {zero, zero, 1}).meets());
  }
}
