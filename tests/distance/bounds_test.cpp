#include "durero/distance/bounds.hpp"

#include "distance/shapes_gen.hpp"
#include "durero/distance/exact.hpp"
#include "durero/surface/surfaces.hpp"
#include "support/catch.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::test;
using distance::Bounds;

namespace {

void check(const Bounds& known, const algebra::Value& squared, double width) {
  RC_ASSERT(known.low >= 0);
  RC_ASSERT((algebra::compare(squared, number::square(number::Dyadic(known.low))) >= 0));
  RC_ASSERT(known.high - known.low <= width);
  RC_ASSERT((algebra::compare(squared, number::square(number::Dyadic(known.high))) <= 0));
}

}  // namespace

TEMPLATE_TEST_CASE("The exact distance lies within the bounds, which are narrow", "", scene::Sphere, scene::Cylinder,
                   scene::TruncatedCone, scene::Plane, scene::Disc) {
  property("of any shape and point", [] {
    const auto shape = any_shape<TestType>();
    const glm::dvec3 p = (*any_point()).xyz();
    check(distance::bounds(shape, p), distance::exact::nearest(shape, p).squared, 1e-6);
  });
}

TEST_CASE("The bounds of a cone and of a triangle") {
  property("a cone, whose apex an axis that is no unit vector cuts off", [] {
    const auto cone = any_shape<scene::Cone>();
    const glm::dvec3 p = (*any_point()).xyz();
    check(distance::bounds(cone, p), distance::exact::nearest(cone, p).squared, 1e-4);
  });
  property("a triangle, however thin", [] {
    auto triangle = any_shape<scene::Triangle>();
    if (*rc::gen::arbitrary<bool>()) triangle.vertices[2] = triangle.vertices[0] + 0x1p-30 * triangle.vertices[2];
    if (!model::Vertices::contains(model::Terna{model::Punto(triangle.vertices[0]), model::Punto(triangle.vertices[1]),
                                                model::Punto(triangle.vertices[2])}))
      return;
    const glm::dvec3 p = (*any_point()).xyz();
    check(distance::bounds(triangle, p), distance::exact::nearest(triangle, p).squared, 1e300);
  });
  const scene::Triangle corner{{glm::dvec3{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};
  const Bounds over = distance::bounds(corner, {1, 1, 3}), beside = distance::bounds(corner, {2, -3, 4});
  CHECK((over.low > 3 - 1e-10 && over.high < 3 + 1e-10));
  CHECK((beside.low > 5 - 1e-10 && beside.high < 5 + 1e-10));
}

TEST_CASE("A shape whose axis cuts it short, or that is out of range, has a bound from above that is true or none") {
  const scene::Cylinder thin{{0, 0, 0}, 0x1p-10, {0, 0, 1 - 0x1p-53}, 0x1p60};
  const glm::dvec3 p(0, 0, 0x1p60);
  const Bounds known = distance::bounds(thin, p);
  CHECK(known.high >= algebra::rounded_root(distance::exact::nearest(thin, p).squared));
  const Bounds unknown = distance::bounds(scene::Sphere{{0x1p101, 0, 0}, 1}, {0, 0, 0});
  CHECK(unknown.low == 0);
  CHECK(std::isinf(unknown.high));
  CHECK(distance::bounds(scene::Sphere{{0, 0, 0}, 1}, {0x1p101, 0, 0}).low == 0);
}

TEST_CASE("The distance from a box is not less than its bound") {
  const surface::Box box{{0, 0, 0}, {1, 2, 3}};
  CHECK(distance::least_distance(box, {0.5, 1, 1}) == 0);
  CHECK(distance::least_distance(box, {4, 6, 3}) <= 5);
  CHECK(distance::least_distance(box, {4, 6, 3}) > 5 - 1e-10);
  CHECK(distance::least_distance(box, {-3, -4, 2}) > 5 - 1e-10);
  CHECK(distance::least_distance({{-INFINITY, 0, 0}, {INFINITY, 2, 3}}, {1e9, 0, 4}) > 1 - 1e-10);
  CHECK(distance::least_distance(box, {1e200, 0, 0}) == 0);
}
