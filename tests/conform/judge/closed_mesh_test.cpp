// Closed meshes of many faces: which are closed, which origins are inside, and where rays leave them.
#include "conform/judge/closed_mesh.hpp"

#include "conform/families/draws.hpp"
#include "durero/conform/families/families.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/surface/exact.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::conform;

namespace {

constexpr Precision binary64{NumberFormat::binary64};

scene::Scene solid(std::uint64_t seed, std::size_t faces = 1000) {
  return generate(*find_family("mesh_solid"), seed, 0, {.faces = faces})->the_case.scene;
}

model::Rayo ray(const glm::dvec3& p, const glm::dvec3& v) { return {model::Punto(p), model::Vector(v)}; }

bool has_zone(const ClosedMesh& mesh, const glm::dvec3& p) {
  return zone_of(mesh, ray(p, {1, 2, -3}), binary64).has_value();
}

}  // namespace

TEST_CASE("a mesh without one of its faces is open, and with one twice it is as well") {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const scene::Scene whole = solid(seed);
    CHECK(closed_mesh(SceneTree(whole, 1)));
    scene::Mesh mesh = whole.meshes()[0];
    const model::Cara last = mesh.caras.back();
    mesh.caras.pop_back();
    scene::Scene open;
    open.apply_total(scene::MeshAddition{mesh});
    CHECK_FALSE(closed_mesh(SceneTree(open, 1)));
    mesh.caras.insert(mesh.caras.end(), {last, last});
    scene::Scene twice;
    twice.apply_total(scene::MeshAddition{mesh});
    CHECK_FALSE(closed_mesh(SceneTree(twice, 1)));
  }
  CHECK_FALSE(closed_mesh(SceneTree(scene::Scene(), 1)));
}

TEST_CASE("an origin well inside has a zone that ends behind the exact hit, and one outside or on the mesh has none") {
  Random random(7);
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const scene::Scene whole = solid(seed);
    for (const std::size_t rays : {1, 1000}) {  // without the tree, and with it
      const SceneTree tree(whole, rays);
      const ClosedMesh mesh = closed_mesh(tree).value();
      for (int i = 0; i < 20; ++i) {
        const glm::dvec3 way = random.direction(), p = 0.3 * random.in_cube(1);
        const auto zone = zone_of(mesh, ray(p, way), binary64);
        REQUIRE(zone);
        const scene::Hit hit = surface::exact::first_hit(whole, ray(p, way), {});
        REQUIRE(hit.resultado == model::Resultado::hit);
        CHECK(number::round_to_binary64(zone->end) > hit.t);
        CHECK_FALSE(has_zone(mesh, p + 3.0 * way));
      }
      const auto triangles = whole.shapes<scene::Triangle>();
      for (std::size_t face = 0; face < triangles.size(); face += 37) {
        const auto [a, b, c] = triangles[face].vertices;
        CHECK_FALSE(has_zone(mesh, a));
        CHECK_FALSE(has_zone(mesh, 0.5 * (a + b)));
        CHECK_FALSE(has_zone(mesh, (a + b + c) / 3.0 * (1 - 0x1p-52)));
        CHECK(has_zone(mesh, 0.99 * (a + b + c) / 3.0));
      }
    }
  }
}

TEST_CASE("a ray that meets an edge tells nothing of the inside, and another direction is taken") {
  // The first fixed direction goes from (0, 0, 0) through the first vertex of this tetrahedron.
  scene::Scene scene;
  scene::Mesh mesh{.m = model::Elemento("m")};
  mesh.puntos = {{1009, -709, 307}, {-2000, 0, 0}, {0, 2000, 0}, {0, 0, -2000}};
  mesh.caras = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  scene.apply_total(scene::MeshAddition{mesh});
  const SceneTree tree(scene, 1);
  const ClosedMesh closed = closed_mesh(tree).value();
  CHECK(has_zone(closed, {0, 0, 0}));
  CHECK(has_zone(closed, {-10, 10, -5}));
  CHECK_FALSE(has_zone(closed, {2018, -1418, 614}));
}
