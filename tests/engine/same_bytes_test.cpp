// Every engine that promises the bytes of `exact` has them: on each family of cases, on scenes of many elements, and on
// those that a structure may stumble over. They are held against `analytic`, which its own tests hold against `exact`.
#include "engine/same_bytes.hpp"

#include <string>

#include "durero/conform/families/families.hpp"
#include "durero/engine/engine.hpp"
#include "durero/scene/camera.hpp"
#include "durero/scene/stage.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;

namespace {

/// Rays at random; of each four, one starts on the element that the ray before it hits.
Queries random_queries(const scene::Scene& scene, Random& random, std::size_t count) {
  const auto analytic = engine::find("analytic")->prepare(scene);
  Queries queries;
  while (queries.size() < count) {
    queries.push_back({random_ray(random)});
    if (queries.size() % 4 != 3) continue;
    const scene::Hit hit = engine::first_hit(*analytic, queries.back());
    if (hit.resultado == model::Resultado::hit)
      queries.push_back({{model::Punto(hit.punto), model::Vector(random.direction())}, hit.elementos});
  }
  return queries;
}

}  // namespace

TEST_CASE("on every family") {
  for (const conform::Family& family : conform::families_of_few())
    for (std::uint64_t seed = 1; seed <= fewer_when_sanitized(40); ++seed) {
      const conform::Case made = generate(family, seed, 50);
      check_same(made.scene, made.rays, std::string(family.name) + " with seed " + std::to_string(seed));
    }
}

TEST_CASE("on every family, at length", "[long]") {
  for (const conform::Family& family : conform::families_of_few())
    for (std::uint64_t seed = 1000; seed < 3000; ++seed) {
      const conform::Case made = generate(family, seed, 200);
      check_same(made.scene, made.rays, std::string(family.name) + " with seed " + std::to_string(seed));
    }
}

TEST_CASE("on scenes of no element, of one, and of many") {
  for (const std::size_t elements : {0, 1, 2, 3, 17, 100, 1000})
    for (std::uint64_t seed = 1; seed <= fewer_when_sanitized(elements < 1000 ? 20 : 10); ++seed) {
      Random random(seed);
      const scene::Scene scene = random_scene(random, elements);
      check_same(scene, random_queries(scene, random, elements < 1000 ? 300 : 100),
                 std::to_string(elements) + " elements, seed " + std::to_string(seed));
    }
}

TEST_CASE("on elements that are all the same") {
  Random random(3);
  scene::Scene scene;
  for (int i = 0; i < 300; ++i) add(scene, scene::Sphere{{0, 0, 0}, 1});
  check_same(scene, random_queries(scene, random, 100), "300 spheres");
}

TEST_CASE("on huge elements and tiny ones together, and on such as are not ordinary") {
  Random random(4);
  scene::Scene scene = random_scene(random, 50);
  for (const double size : {1e-30, 1e-200, 1e-9, 1e9, 1e40, 1e300}) {
    add(scene, scene::Sphere{random.in_cube(1), size});
    add(scene, scene::Sphere{glm::dvec3(0, 0, size), size});
  }
  Queries queries = random_queries(scene, random, 300);
  for (std::size_t i = 0; i < 100; ++i) {
    const glm::dvec3 p = queries[i].rayo.p().xyz(), v = queries[i].rayo.v().xyz();
    queries.push_back({ray(p, v * 0x1p-400)});
    queries.push_back({ray(p * 0x1p60, v)});
    queries.push_back({ray(p, -p)});
    queries.push_back({ray(p * 0x1p60, -p)});
  }
  check_same(scene, queries, "seed 4");
}

TEST_CASE("on segments that nothing but an element out of range blocks") {
  scene::Scene scene;
  for (int i = 0; i < 40; ++i) add(scene, scene::Sphere{{2.0 * i, 50, 0}, 0.5});
  for (const double size : {1e-200, 1e300}) add(scene, scene::Sphere{{0, 0, size}, size});
  Queries queries;
  for (int i = 0; i < 20; ++i) queries.push_back({ray({0.1 * i, 0.25, -1}, {0, 0, 1.5})});
  check_same(scene, queries, "a sphere as flat as a plane");
}

TEST_CASE("on segments that end at lights") {
  for (std::uint64_t seed = 1; seed <= fewer_when_sanitized(20); ++seed) {
    Random random(seed);
    scene::Scene scene = random_scene(random, 5 * seed);
    for (int i = 0; i < 3; ++i) scene.stage().lights.push_back({random.in_cube(2), {1, 1, 1}});
    Queries queries = random_queries(scene, random, 300);
    for (scene::Query& query : queries) {
      const glm::dvec3 p = query.rayo.p().xyz();
      query.rayo = {model::Punto(p), model::Vector(random.any_of(scene.stage().lights).position - p)};
    }
    check_same(scene, queries, "lights with seed " + std::to_string(seed));
  }
}

TEST_CASE("on the rays of a camera's pixels") {
  for (std::uint64_t seed = 1; seed <= fewer_when_sanitized(20); ++seed) {
    Random random(seed);
    scene::Scene scene = random_scene(random, 5 * seed);
    const glm::dvec3 eye = random.in_cube(3), at = random.in_cube(1);
    scene.stage().camera = scene::Camera{eye, at, {0, 1, 0}, 50};
    scene.stage().resolution = scene::Resolution{24, 16};
    const scene::PrimaryRays rays(*scene.stage().camera, *scene.stage().resolution);
    Queries queries;
    for (std::uint32_t pixel = 0; pixel < 24 * 16; ++pixel) {
      const scene::Query query{rays.ray(pixel % 24, pixel / 24)};
      queries.push_back(query);
    }
    check_same(scene, queries, "a camera with seed " + std::to_string(seed));
  }
}

TEST_CASE("on rays along the axes, in the planes of boxes, and through their corners") {
  scene::Scene scene;
  for (int x = -2; x <= 2; ++x)
    for (int y = -2; y <= 2; ++y)
      for (int z = -2; z <= 2; ++z) add(scene, scene::Sphere{glm::dvec3(x, y, z), 0.5});
  Queries queries;
  for (int x = -6; x <= 6; ++x)
    for (int y = -6; y <= 6; ++y)
      for (const glm::dvec3 v :
           {glm::dvec3(0, 0, 1), glm::dvec3(0, -0.0, 2), glm::dvec3(1, 0, 1), glm::dvec3(1, 1, 1)}) {
        queries.push_back({ray({x * 0.5, y * 0.5, -4}, v)});
        queries.push_back({ray({x * 0.5, -4, y * 0.5}, {v.x, v.z, v.y})});
        queries.push_back({ray({4, x * 0.5, y * 0.5}, {-v.z, v.x, -v.y})});
      }
  check_same(scene, queries, "the lattice");
}

TEST_CASE("what stands before a light is the same by exact arithmetic and by closed forms") {
  for (std::uint64_t seed = 1; seed <= fewer_when_sanitized(20); ++seed) {
    Random random(seed);
    const scene::Scene scene = random_scene(random, 30);
    check_same_between(scene, *engine::find("analytic")->prepare(scene), *engine::find("exact")->prepare(scene),
                       random_queries(scene, random, 40), "analytic, seed " + std::to_string(seed));
  }
}
