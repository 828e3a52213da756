// Every engine has the bytes of `exact` on meshes: closed and open ones, rays at their edges and vertices, from inside
// and from their faces, with vertices of binary32, which the fast engine keeps in blocks, and of binary64.
#include <cmath>
#include <map>

#include "durero/model/operaciones.hpp"
#include "durero/scene/mesh_edit.hpp"
#include "engine/same_bytes.hpp"
#include "support/sanitized.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;

namespace {

struct Mesh {
  scene::Scene scene;
  std::vector<glm::dvec3> vertices;
};

/// A wavy sheet of 2·k² triangles over the unit square; its coordinates are of binary32 where `single`.
Mesh sheet(std::size_t k, bool single) {
  Mesh mesh;
  for (std::size_t i = 0; i <= k; ++i)
    for (std::size_t j = 0; j <= k; ++j) {
      const double x = double(i) / double(k), y = double(j) / double(k);
      const glm::dvec3 vertex(x, y, 0.2 * std::sin(9 * x) * std::cos(7 * y));
      mesh.vertices.push_back(single ? glm::dvec3(glm::vec3(vertex)) : vertex);
    }
  for (std::size_t i = 0; i < k; ++i)
    for (std::size_t j = 0; j < k; ++j) {
      const auto at = [&](std::size_t a, std::size_t b) { return mesh.vertices[(i + a) * (k + 1) + j + b]; };
      add(mesh.scene, scene::Triangle{std::array{at(0, 0), at(1, 0), at(0, 1)}});
      add(mesh.scene, scene::Triangle{std::array{at(1, 0), at(1, 1), at(0, 1)}});
    }
  return mesh;
}

/// Triangles at random, many of which lie before each other; their coordinates are of binary32.
Mesh soup(std::size_t count, Random& random) {
  Mesh mesh;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec3 centre = random.in_cube(1);
    std::array<glm::dvec3, 3> vertices;
    for (glm::dvec3& vertex : vertices) {
      vertex = glm::dvec3(glm::vec3(centre + random.in_cube(0.7)));
      mesh.vertices.push_back(vertex);
    }
    add(mesh.scene, scene::Triangle{vertices});
  }
  return mesh;
}

/// Rays of a pinhole, by squares of eight, so that they walk in bundles; and rays that start where they hit.
Queries seen_from(const Mesh& mesh, const glm::dvec3& eye, Random& random) {
  Queries queries;
  for (int i = 0; i < 1024; ++i) {
    const int x = i / 64 % 4 * 8 + i % 8, y = i / 256 * 8 + i / 8 % 8;
    queries.push_back({ray(eye, glm::dvec3((x - 15.5) / 20, (y - 15.5) / 20, 0) - eye)});
  }
  const std::vector<scene::Hit> hits = engine::first_hits(*engine::find("analytic")->prepare(mesh.scene), queries);
  for (const scene::Hit& hit : hits)
    if (hit.resultado == model::Resultado::hit) queries.push_back({ray(hit.punto, random.direction()), hit.elementos});
  return queries;
}

/// Bunches of rays at vertices, at points of edges and anywhere; of each three, the last starts on the face that the
/// ray before it hits.
Queries rays_at(const Mesh& mesh, Random& random, std::size_t count) {
  const auto analytic = engine::find("analytic")->prepare(mesh.scene);
  const auto vertex = [&] { return mesh.vertices[random.below(mesh.vertices.size())]; };
  Queries queries;
  while (queries.size() < count) {
    const glm::dvec3 from = random.in_cube(2), a = vertex(), b = vertex();
    for (int i = 0; i < 20; ++i) {
      const glm::dvec3 to = i % 3 == 0 ? a : i % 3 == 1 ? (a + b) / 2.0 : a + 0.1 * random.in_cube(1);
      queries.push_back({ray(from, (to - from) * (i % 2 == 0 ? 1 : 0.5))});
      const scene::Hit hit = engine::first_hit(*analytic, queries.back());
      if (i % 3 == 2 && hit.resultado == model::Resultado::hit)
        queries.push_back({ray(hit.punto, vertex() - hit.punto), hit.elementos});
    }
  }
  return queries;
}

/// The triangles of a scene as two meshes, whose points stand once, and other elements beside them, some of which are
/// triangles.
scene::Scene two_meshes(const scene::Scene& of, Random& random) {
  scene::Scene scene;
  for (int i = 0; i < 20; ++i) scene.apply(random_addition(random, "other" + std::to_string(i)));
  scene::Mesh meshes[] = {{model::Elemento("a")}, {model::Elemento("b")}};
  std::map<std::array<double, 3>, model::Ordinal> numbers[2];
  of.for_each([&]<class Shape>(scene::ElementRef e, const Shape& shape) {
    if constexpr (std::is_same_v<Shape, scene::Triangle>) {
      scene::Mesh& mesh = meshes[e.index % 2];
      const auto number = [&](const glm::dvec3& p) {
        const auto next = static_cast<model::Ordinal>(mesh.puntos.size());
        const auto [at, is_new] = numbers[e.index % 2].try_emplace({p.x, p.y, p.z}, next);
        if (is_new) mesh.puntos.push_back(p);
        return at->second;
      };
      const auto& [a, b, c] = shape.vertices;
      mesh.caras.push_back({number(a), number(b), number(c)});
    }
  });
  for (scene::Mesh& mesh : meshes)
    REQUIRE(scene.apply_total(scene::MeshEdit(scene::MeshAddition{std::move(mesh)})).ok());
  return scene;
}

/// Elements with the same geometry and rows, none in a mesh.
scene::Scene by_themselves(const scene::Scene& of) {
  scene::Scene scene;
  of.for_each([&](scene::ElementRef e, const auto& shape) { REQUIRE(scene.add(of.name(e), shape).ok()); });
  return scene;
}

}  // namespace

TEST_CASE("on meshes of binary32 and of binary64") {
  for (const bool single : {true, false})
    for (const std::size_t k : {1, 2, 3, 8, 20}) {
      const Mesh mesh = sheet(k, single);
      Random random(k);
      check_same(mesh.scene, rays_at(mesh, random, fewer_when_sanitized(400)),
                 std::string(single ? "binary32" : "binary64") + ", " + std::to_string(k));
    }
}

TEST_CASE("on triangles of binary32 before each other, by rays in bundles") {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Random random(seed);
    const Mesh mesh = soup(seed % 2 == 0 ? 60 : 400, random);
    check_same(mesh.scene, seen_from(mesh, {0.1, 0.2, -3}, random), "seed " + std::to_string(seed));
  }
}

TEST_CASE("on a mesh of binary32 among other elements, some of them triangles of binary64") {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Random random(seed);
    Mesh mesh = sheet(10, true);
    for (int i = 0; i < 40; ++i) mesh.scene.apply(random_addition(random, "other" + std::to_string(i)));
    check_same(mesh.scene, rays_at(mesh, random, fewer_when_sanitized(400)), "seed " + std::to_string(seed));
  }
}

TEST_CASE("on a scene with meshes, as on the same triangles by themselves") {
  for (const bool single : {true, false}) {
    Random random(single);
    const Mesh of = sheet(9, single);
    const Mesh meshes{two_meshes(of.scene, random), of.vertices};
    const scene::Scene flat = by_themselves(meshes.scene);
    REQUIRE(flat.size() == meshes.scene.size());
    const Queries queries = rays_at(meshes, random, fewer_when_sanitized(400));
    check_same(meshes.scene, queries, single ? "binary32" : "binary64");
    const auto analytic = engine::find("analytic")->prepare(meshes.scene);
    const auto of_flat = engine::find("analytic")->prepare(flat);
    CHECK(engine::first_hits(*analytic, queries) == engine::first_hits(*of_flat, queries));
  }
}

TEST_CASE("on meshes of many faces", "[long]") {
  for (const std::size_t k : {100, 300}) {
    const Mesh mesh = sheet(k, true);
    Random random(k);
    check_same(mesh.scene, rays_at(mesh, random, 20000), std::to_string(k));
  }
}
