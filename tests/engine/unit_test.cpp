// A scene whose lengths lie outside the range of the bounds is answered in another unit of length: with the bytes of
// `exact`, and by as few tests as any other.
#include "engine/unit.hpp"

#include <cmath>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <string>

#include "durero/accel/structure.hpp"
#include "durero/accel/wide/wide_bvh.hpp"
#include "durero/surface/exact.hpp"
#include "durero/trace/ray.hpp"
#include "engine/fast.hpp"
#include "engine/rescaled.hpp"
#include "engine/same_bytes.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;

namespace {

std::size_t not_ordinary(const scene::Scene& scene) {
  std::size_t n = 0;
  scene.for_each([&](scene::ElementRef, const auto& shape) { n += trace::ordinary(shape) ? 0 : 1; });
  return n;
}

/// Spheres, so many, side by side, all lengths times some factor, which need be no power of two.
scene::Scene spheres(std::size_t n, double factor) {
  Random random(n);
  scene::Scene scene;
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec3 centre = random.in_cube(1);
    add(scene, scene::Sphere{centre * factor, 0.5 / std::cbrt(static_cast<double>(n)) * factor});
  }
  return scene;
}

/// Rays of a scene around the origin of size 2^exponent: whose direction has any length, that run along an axis, that
/// start on an element, and segments.
Queries rays(const scene::Scene& scene, Random& random, int exponent) {
  Queries queries;
  const auto far = [&](const glm::dvec3& x) { return x * std::ldexp(1, exponent); };
  while (queries.size() < 60) {
    const model::Rayo made = random_ray(random);
    const glm::dvec3 p = far(made.p().xyz()), v = made.v().xyz();
    if (glm::any(glm::isinf(p)) || glm::any(glm::isinf(far(v)))) continue;
    const model::Rayo rayo = ray(p, v);
    queries.push_back({rayo});
    queries.push_back({ray(p, far(v))});
    queries.push_back({ray(p, v * 0x1p150)});
    queries.push_back({ray({p.x, 0, 0}, {-std::copysign(1, p.x), 0, 0})});
    queries.push_back({ray({p.x, p.y, 0x1p-1070}, v)});
    const scene::Hit hit = surface::exact::first_hit(scene, rayo);
    if (hit.resultado == model::Resultado::hit)
      queries.push_back({{model::Punto(hit.punto), model::Vector(random.direction())}, hit.elementos});
  }
  return queries;
}

bool is_rescaled(const scene::Scene& scene) {
  const auto fast = engine::find("fast")->prepare(scene);
  return dynamic_cast<const engine::Rescaled<engine::Fast>*>(fast.get()) != nullptr;
}

}  // namespace

TEST_CASE("a scene in the range of the bounds keeps its unit") {
  Random random(1);
  for (const std::size_t n : {0, 1, 50}) {
    const scene::Scene scene = random_scene(random, n);
    CHECK(!engine::unit_of(scene));
    CHECK(!is_rescaled(scene));
  }
  CHECK(!engine::unit_of(spheres(20, 0x1p96)));
}

TEST_CASE("any other gets the unit in which the most elements are in the range") {
  for (const double factor : {1e40, 1e-40, 0x1p120, 0x1p-150, 1e150, 1e-150, 1e300, 1e-280}) {
    const scene::Scene scene = spheres(50, factor);
    INFO(factor);
    REQUIRE(not_ordinary(scene) == 50);
    const auto unit = engine::unit_of(scene);
    REQUIRE(unit);
    CHECK(not_ordinary(engine::in_unit(scene, *unit)) == 0);
    CHECK(is_rescaled(scene));
  }
  scene::Scene mixed = spheres(50, 1e40);
  add(mixed, scene::Sphere{{0, 0, 0}, 1e-40});
  REQUIRE(engine::unit_of(mixed));
  CHECK(not_ordinary(engine::in_unit(mixed, *engine::unit_of(mixed))) == 1);
  add(mixed, scene::Sphere{{0, 0, 0}, 0x1.8p-1073});  // whose half is none
  CHECK(!engine::unit_of(mixed));
}

TEST_CASE("a direction and a slope are no lengths") {
  scene::Scene scene;
  add(scene, scene::TruncatedCone{{0x1p200, 0, 0}, 0x1p190, 0.5, {0, 0, 1}, 0x1p191});
  const auto unit = engine::unit_of(scene);
  REQUIRE(unit);
  const scene::Scene scaled = engine::in_unit(scene, *unit);
  const auto& cone = scaled.shapes<scene::TruncatedCone>()[0];
  CHECK(cone.proporcion == 0.5);
  CHECK(cone.vector == glm::dvec3(0, 0, 1));
  CHECK(cone.centro.x == std::ldexp(1, 200 + *unit));
  CHECK(cone.radio == std::ldexp(1, 190 + *unit));
  CHECK(cone.altura == std::ldexp(1, 191 + *unit));
}

TEST_CASE("every answer has the same bytes in another unit") {
  for (const int exponent : {101, 133, -133, 400, -400, 1000, -980}) {
    Random random(static_cast<std::uint64_t>(2000 + exponent));
    const scene::Scene scene = engine::in_unit(random_scene(random, 12), exponent);
    REQUIRE(is_rescaled(scene));
    check_same(scene, rays(scene, random, exponent), "lengths times 2^" + std::to_string(exponent));
  }
}

TEST_CASE("a coordinate that cancels to less than a normal number is rounded in its own unit") {
  // The plane is met at its point, whose coordinates are 2^-1040 or 0 and no rounding of those in the unit.
  scene::Scene scene;
  add(scene, scene::Sphere{{0, 0, 0}, 0x1p-1000});
  add(scene, scene::Plane{{0x1p-1040, 0, 0}, {1, 0, 0}});
  REQUIRE(is_rescaled(scene));
  Queries queries{{ray({0x1p-1000, 0x1p-1001, 0}, {-1, -0.5, 0.75})}, {ray({0x1p-1000, 0, 0}, {-3, 1, 1})}};
  check_same(scene, queries, "subnormal coordinates");
}

TEST_CASE("a ray is tested against as few elements in another unit, however many there are") {
  const auto tests_a_ray = [](std::size_t n) {
    const scene::Scene scene = spheres(n, 1e40);
    Random random(3);
    Queries queries;
    for (int i = 0; i < 100; ++i) {
      const model::Rayo made = random_ray(random);
      queries.push_back({ray(made.p().xyz() * 1e40, made.v().xyz())});
    }
    const engine::Figures figures = engine::find("fast")->measure(scene, queries);
    CHECK(figures.size.apart == 0);
    CHECK(figures.work.rays == 100);
    return static_cast<double>(figures.work.candidates) / 100;
  };
  CHECK(tests_a_ray(6400) < 8 * tests_a_ray(100));  // 64 times as many; one after the other they would be 64-fold
}
