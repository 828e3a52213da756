// A closed mesh has no cracks: no ray from inside escapes, and a ray through a shared edge or vertex names every
// triangle that holds the point.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iostream>
#include <vector>

#include "durero/trace/analytic.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/sanitized.hpp"

using namespace durero;
using namespace durero::test;
using model::Resultado;

namespace {

double any_neighbour(Random& random, double x) {
  const int way = random.integer(-1, 1);
  return way == 0 ? x : std::nextafter(x, way * HUGE_VAL);
}

/// From inside towards a point of an edge, as near as doubles allow: p + v is rounded, and may be beside the edge by a
/// unit in the last place of any coordinate.
model::Rayo towards_edge(Random& random, const Mesh& mesh) {
  const glm::dvec3 p = random.in_cube(0.125), at = any_edge_point(random, mesh, 1 << 20).on(mesh);
  glm::dvec3 v = at - p;
  if (random.chance(1, 2)) v *= random.uniform(0.25, 4);
  for (int i = 0; i < 3; ++i) v[i] = any_neighbour(random, v[i]);
  return {model::Punto(p), model::Vector(v)};
}

void no_ray_escapes(std::uint64_t meshes, std::size_t rays_a_mesh) {
  std::atomic<std::uint64_t> lost = 0, several = 0, lost_seed = 0;
  tbb::parallel_for(std::uint64_t{0}, meshes, [&](std::uint64_t i) {
    const std::uint64_t seed = 7000 + i;
    Random random(seed);
    const Mesh mesh = rough_mesh(random, 2);
    const scene::Scene scene = scene_of(mesh);
    std::vector<scene::Query> queries;
    for (std::size_t n = 0; n < rays_a_mesh; ++n) queries.push_back({towards_edge(random, mesh), {}});
    const trace::Tables tables(scene);
    for (const scene::Hit& hit : trace::first_hits(tables, queries)) {
      several += hit.elementos.size() > 1;
      if (hit.resultado == Resultado::hit) continue;
      ++lost;
      lost_seed = seed;
    }
  });
  std::cout << meshes * rays_a_mesh << " rays at edges and vertices from inside, " << lost << " lost, " << several
            << " through several triangles\n";
  INFO("replay: Random random(" << lost_seed << ")");
  CHECK(lost == 0);
  CHECK(several > 0);
}

/// The triangles that hold a point of an edge, or of a vertex.
scene::ElementSet those_that_hold(const Mesh& mesh, const EdgePoint& at) {
  const auto& edge = mesh.triangles[at.triangle];
  const std::uint32_t from = edge[at.edge], to = edge[(at.edge + 1) % 3];
  scene::ElementSet all;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto has = [&](std::uint32_t vertex) { return std::ranges::count(mesh.triangles[i], vertex) > 0; };
    if (has(from) && (at.share == 0 || has(to))) all.push_back({model::Tipo::soy_triangulo, i});
  }
  return all;
}

}  // namespace

TEST_CASE("no ray from inside a closed mesh escapes, at edges and vertices as near as doubles allow") {
  no_ray_escapes(20, fewer_when_sanitized(20'000));
}

TEST_CASE("no ray of ten million from inside a closed mesh escapes", "[long]") { no_ray_escapes(100, 100'000); }

TEST_CASE("a ray through a shared edge or vertex names every triangle that holds the point, and no other") {
  Random random(7);
  for (int n = 0; n < 10; ++n) {
    const Mesh mesh = lattice_mesh(random, 2);
    const scene::Scene scene = scene_of(mesh);
    for (int i = 0; i < 200; ++i) {
      const EdgePoint at = any_edge_point(random, mesh, 64);
      glm::dvec3 p;
      for (int k = 0; k < 3; ++k) p[k] = random.integer(-4096, 4096);
      const glm::dvec3 point = at.on(mesh);
      const model::Rayo ray{model::Punto(p), model::Vector(point - p)};
      const scene::Hit hit = trace::first_hit(scene, ray);
      REQUIRE(hit.resultado == Resultado::hit);
      if (hit.t != 1) {  // the mesh is rough: another triangle may stand before the point
        CHECK(hit.t < 1);
        continue;
      }
      CHECK(hit.punto == point);
      CHECK(hit.elementos == those_that_hold(mesh, at));
      CHECK(hit.elementos.size() >= 2);
      // And from the other side, where nothing stands between.
      const model::Rayo inwards{model::Punto(p + 2.0 * (point - p)), model::Vector(p - point)};
      const scene::Hit from_outside = trace::first_hit(scene, inwards);
      REQUIRE(from_outside.resultado == Resultado::hit);
      if (from_outside.t == 1) CHECK(from_outside.elementos == hit.elementos);
    }
  }
}
