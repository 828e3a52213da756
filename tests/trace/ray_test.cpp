#include "durero/trace/ray.hpp"

#include <cmath>

#include "durero/conform/random.hpp"
#include "durero/scene/attributes.hpp"
#include "support/catch.hpp"
#include "support/exact_vector.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;
using trace::Ray;

namespace {

/// What a table stores of an attribute, with that number everywhere.
template <class Stored>
Stored filled(double x) {
  if constexpr (std::is_same_v<Stored, scene::Corners>)
    return {glm::dvec3(x), glm::dvec3(x), glm::dvec3(x)};
  else
    return Stored(x);
}

}  // namespace

TEST_CASE("what a ray knows of its lengths is greater by as much as is said") {
  conform::Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const double far = std::abs(random.signed_power(-40, 40)), fast = std::abs(random.signed_power(-40, 40));
    const glm::dvec3 p = random.in_cube(far), v = random.in_cube(fast);
    if (v == glm::dvec3(0)) continue;
    const Ray traced(ray(p, v));
    const Exact_Vector exact(v);
    const Dyadic u(0x1p-53);
    const auto greater_by = [&](double computed, const Dyadic& meant, int least, int most) {
      return Dyadic(computed) >= meant * (Dyadic(1) + Dyadic(least) * u) &&
             Dyadic(computed) <= meant * (Dyadic(1) + Dyadic(most) * u);
    };
    CHECK(greater_by(traced.length_squared(), dot(exact, exact), 60, 80));
    CHECK(greater_by(traced.length(), length(exact), 30, 40));
    CHECK(traced.speed >= traced.length() * (1 - 0x1p-46));
  }
}

TEST_CASE("a ray is ordinary where every number of it is 0 or of magnitude 2⁻¹⁰⁰ … 2¹⁰⁰") {
  const auto ordinary = [](const glm::dvec3& p, const glm::dvec3& v) { return Ray(ray(p, v)).ordinary; };
  for (const double number : {0.0, -0.0, 0x1p-100, -0x1p-100, 0x1p100, -0x1p100}) {
    CHECK(ordinary({number, 1, 1}, {1, 1, 1}));
    CHECK(ordinary({1, 1, number}, {1, 1, 1}));
    CHECK(ordinary({1, 1, 1}, {1, number, 1}));
  }
  for (const double number : {0x1.fffffffffffffp-101, -0x1p-1074, 0x1.0000000000001p100, -0x1p1023}) {
    CHECK_FALSE(ordinary({number, 1, 1}, {1, 1, 1}));
    CHECK_FALSE(ordinary({1, number, 1}, {1, 1, 1}));
    CHECK_FALSE(ordinary({1, 1, number}, {1, 1, 1}));
    CHECK_FALSE(ordinary({1, 1, 1}, {number, 1, 1}));
    CHECK_FALSE(ordinary({1, 1, 1}, {1, number, 1}));
    CHECK_FALSE(ordinary({1, 1, 1}, {1, 1, number}));
  }
}

TEST_CASE("an element is ordinary where every number of it is") {
  scene::for_each_shape([]<class Shape>(std::type_identity<Shape>) {
    const auto each = [](double others, auto change) {
      Shape shape;
      scene::for_each_attribute<Shape>(
          [&]<class Row>(const Row& row) { shape.*row.field = filled<typename Row::Stored>(others); });
      change(shape);
      return trace::ordinary(shape);
    };
    CHECK(each(1, [](Shape&) {}));
    scene::for_each_attribute<Shape>([&]<class Row>(const Row& row) {
      INFO(Shape::word << " " << row.word);
      CHECK(each(1, [&](Shape& shape) { shape.*row.field = filled<typename Row::Stored>(0x1p100); }));
      CHECK(each(1, [&](Shape& shape) { shape.*row.field = filled<typename Row::Stored>(0); }));
      CHECK_FALSE(each(1, [&](Shape& shape) { shape.*row.field = filled<typename Row::Stored>(0x1p101); }));
      CHECK_FALSE(each(1, [&](Shape& shape) { shape.*row.field = filled<typename Row::Stored>(-0x1p-101); }));
      if constexpr (std::is_same_v<typename Row::Stored, glm::dvec3>) {
        for (int axis = 0; axis < 3; ++axis) {
          CHECK_FALSE(each(1, [&](Shape& shape) { (shape.*row.field)[axis] = 0x1p-200; }));
        }
      }
      if constexpr (std::is_same_v<typename Row::Stored, scene::Corners>) {
        for (std::size_t i = 0; i < 3; ++i) {
          for (int axis = 0; axis < 3; ++axis)
            CHECK_FALSE(each(1, [&](Shape& shape) { (shape.*row.field)[i][axis] = 0x1p-200; }));
        }
      }
    });
  });
}
