#include "durero/conform/families/rays_towards.hpp"

#include "durero/trace/analytic.hpp"
#include "support/catch.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;

TEST_CASE("rays towards the elements of a scene: always the same, and many of them hit") {
  scene::Scene scene;
  add(scene, scene::Sphere{{0, 0, 5}, 1});
  add(scene, scene::Cylinder{{300, 0, 5}, 1, {0, 1, 0}, 2});
  const auto rays = conform::rays_towards(scene, 400, 1);
  CHECK(rays == conform::rays_towards(scene, 400, 1));
  CHECK(rays != conform::rays_towards(scene, 400, 2));
  REQUIRE(rays.size() == 400);
  std::size_t hits[2] = {0, 0};
  for (const scene::Query& query : rays) {
    const scene::Hit hit = trace::first_hit(scene, query.rayo);
    for (const scene::ElementRef e : hit.elementos) ++hits[e.tipo == model::Tipo::soy_esfera ? 0 : 1];
  }
  CHECK(hits[0] > 60);
  CHECK(hits[1] > 60);
}

TEST_CASE("towards what has no ball there are no rays") {
  scene::Scene scene;
  CHECK(conform::rays_towards(scene, 9, 1).empty());
  add(scene, scene::Plane{{0, 0, 0}, {0, 1, 0}});
  add(scene, scene::Sphere{{0, 0, 0}, 1e-200});
  CHECK(conform::rays_towards(scene, 9, 1).empty());
}
