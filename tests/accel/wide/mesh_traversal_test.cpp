#include "durero/accel/wide/mesh_traversal.hpp"

#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <vector>

#include "accel/each_alone.hpp"
#include "durero/accel/wide/wide_bvh.hpp"
#include "support/catch.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;
using accel::WideBvh;
using trace::SingleRays;
using trace::SingleSearch;

namespace {

/// A wavy sheet of 2n² triangles of binary32 over a square of side `size` from `at` on.
scene::Scene sheet(std::size_t n, double size, const glm::dvec3& at) {
  scene::Scene scene;
  const auto vertex = [&](std::size_t i, std::size_t j) {
    const double x = static_cast<double>(i) / static_cast<double>(n),
                 y = static_cast<double>(j) / static_cast<double>(n);
    return glm::dvec3(glm::vec3(at + size * glm::dvec3(x, y, 0.2 * std::sin(9 * x) * std::cos(7 * y))));
  };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      add(scene, scene::Triangle{{vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)}});
      add(scene, scene::Triangle{{vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)}});
    }
  return scene;
}

/// Rays of a pinhole towards a square of side `size` from `at` on; the last have nothing before them.
std::vector<scene::Query> camera(const glm::dvec3& eye, const glm::dvec3& at, double size, int side) {
  std::vector<scene::Query> queries;
  for (int i = 0; i < side * side; ++i) {
    const glm::dvec3 pixel((i / 8 % (side / 8) * 8 + i % 8 + 0.3) / side, (i / side / 8 * 8 + i / 8 % 8 + 0.7) / side,
                           0);
    queries.push_back({ray(eye, at + 1.2 * size * pixel - eye)});
  }
  return queries;
}

/// The point with coordinates 0, a and b on the axis along v and on the next two.
glm::dvec3 across(const glm::dvec3& v, double a, double b) {
  return v.x != 0 ? glm::dvec3(0, a, b) : v.y != 0 ? glm::dvec3(b, 0, a) : glm::dvec3(a, b, 0);
}

/// Three square sheets of 2n² triangles, across the axes through the origin, with vertices at multiples of −size/16.
scene::Scene corner(int n, double size) {
  scene::Scene scene;
  for (const glm::dvec3& axis : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)})
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const auto vertex = [&](int k, int l) { return across(axis, -size * (i + k) / 16, -size * (j + l) / 16); };
        add(scene, scene::Triangle{{vertex(0, 0), vertex(1, 0), vertex(0, 1)}});
        add(scene, scene::Triangle{{vertex(1, 0), vertex(1, 1), vertex(0, 1)}});
      }
  return scene;
}

/// The same places as parallel rays, of a sheet of that size.
std::vector<scene::Query> along(std::vector<scene::Query> queries, double size, const glm::dvec3& v) {
  for (scene::Query& query : queries) {
    const glm::dvec3 at = query.rayo.p().xyz() + query.rayo.v().xyz();  // in the square
    query = {ray(size * (glm::dvec3(at.x, at.y, 0) - (2 / v.z) * v), v)};
  }
  return queries;
}

/// Rays at the vertices and the edges' middles of the triangles, each four in a row beside each other.
std::vector<scene::Query> at_vertices(const scene::Scene& scene, const glm::dvec3& eye) {
  std::vector<scene::Query> queries;
  for (std::size_t i = 0; i < scene.shapes<scene::Triangle>().size(); ++i) {
    const scene::Triangle triangle = scene.shapes<scene::Triangle>()[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec3 vertex = triangle.vertices[k], next = triangle.vertices[(k + 1) % 3];
      queries.push_back({ray(eye, vertex - eye)});
      queries.push_back({ray(eye, (vertex + next) / 2.0 - eye)});
    }
  }
  return queries;
}

/// Segments to a light from each hit.
std::vector<scene::Query> shadows(const WideBvh& tree, const std::vector<scene::Query>& queries,
                                  const glm::dvec3& light) {
  std::vector<scene::Query> segments;
  trace::Counts unseen;
  for (const scene::Query& query : queries) {
    const scene::Hit hit = trace::first_hit_among(tree, query.rayo, query.en, unseen);
    if (hit.resultado == model::Resultado::hit) segments.push_back({ray(hit.punto, light - hit.punto), hit.elementos});
  }
  return segments;
}

/// The part of the queries that bundles answer.
double answered(const WideBvh& tree, const std::vector<scene::Query>& queries, SingleSearch search) {
  std::size_t count = 0;
  const trace::Unbundled left(tree, queries, search, [&](auto, const auto&, std::uint64_t which) {
    count += static_cast<std::size_t>(std::popcount(which));
  });
  return static_cast<double>(count) / static_cast<double>(queries.size());
}

}  // namespace

TEST_CASE("bundles answer nearly all coherent rays of a mesh, as each is answered alone") {
  struct Place {
    double size;
    glm::dvec3 at;
  };
  for (const auto& [size, at] :
       {Place{1, {0, 0, 0}}, Place{1e-3, {700, -300, 5}}, Place{0x1p24, {0x1p25, 3, -0x1p26}}}) {
    CAPTURE(size);
    const scene::Scene scene = sheet(24, size, at);
    const WideBvh tree(scene);
    REQUIRE(tree.bundles());
    const std::vector<scene::Query> rays = camera(at + size * glm::dvec3(0.4, 0.6, -1.7), at, size, 64);
    check_each_alone(tree, rays);
    const std::vector<scene::Query> segments = shadows(tree, rays, at + size * glm::dvec3(2, -1.5, -1));
    REQUIRE(segments.size() > 1000);
    check_each_alone(tree, segments);
    if (size != 1) continue;
    CHECK(answered(tree, rays, SingleSearch::nearest) > 0.85);
    CHECK(answered(tree, segments, SingleSearch::any) > 0.8);
    CHECK(answered(tree, segments, SingleSearch::nearest) > 0.8);
  }
}

TEST_CASE("bundles lose no hit at a vertex or an edge, where boxes are touched at their corners") {
  for (const double scale : {1.0, 0x1p-12}) {
    const scene::Scene scene = sheet(16, scale, {0, 0, 0});
    const WideBvh tree(scene);
    for (const glm::dvec3& eye : {glm::dvec3(-0.5, -0.25, -3), glm::dvec3(1.5, 0.5, 2), glm::dvec3(1000, -3000, 2000)})
      check_each_alone(tree, at_vertices(scene, scale * eye));
  }
}

TEST_CASE("rays of one direction, of mixed signs, along the axes and out of range are answered or handed back") {
  Random random(5);
  const scene::Scene scene = sheet(20, 1, {0, 0, 0});
  const WideBvh tree(scene);
  std::vector<scene::Query> queries;
  for (int i = 0; i < 300; ++i) {
    const glm::dvec3 p(0.003 * i, 0.4, -1);
    queries.push_back({ray(p, {0.1, 0.05, 1})});
    if (i % 50 == 0) queries.push_back({ray(p, {0, 0, 1})});
    if (i % 70 == 0) queries.push_back({ray(p, {-0.1, 0.05, 1})});
    if (i % 90 == 0) queries.push_back({ray(p, {0x1p-80, 0.05, 1})});
    if (i == 200) queries.push_back({ray({0.5, 0.5, -0x1p90}, {0, 0, 0x1p60})});
  }
  for (int i = 0; i < 64; ++i) queries.push_back({random_ray(random)});
  for (int i = 0; i < 256; ++i) queries.push_back({ray({0.001 * i, 0.4, -1}, {0.1, 0.05, 1})});
  check_each_alone(tree, queries);
  CHECK(answered(tree, queries, SingleSearch::nearest) > 0.2);
}

TEST_CASE("rays along the axes walk in bundles") {
  for (const double zero : {0.0, -0.0})
    for (const double size : {1.0, 0x1p-12, 0x1p24}) {
      CAPTURE(zero, size);
      const scene::Scene scene = sheet(24, size, {0, 0, 0});
      const WideBvh tree(scene);
      const auto from = [&](const glm::dvec3& v) { return along(camera({0.4, 0.6, -1.7}, {0, 0, 0}, 1, 64), size, v); };
      for (const std::vector<scene::Query>& rays :
           {from({zero, zero, 1}), from({0.125, zero, 1}), from({zero, -0x1p-30, 0x1p-28})}) {
        check_each_alone(tree, rays);
        CHECK(answered(tree, rays, SingleSearch::nearest) > 0.85);
      }
    }
}

TEST_CASE("bundles along an axis lose no hit on the faces of boxes, with or without width, however far") {
  struct Asked {
    double size, far;
    glm::dvec3 v;
  };
  for (const auto& [size, far, v] : {Asked{1, 4, {0, 0, 1}}, Asked{1, 4, {0, -1, -0.0}}, Asked{1, 4, {1, 0, 0}},
                                     Asked{0x1p-12, 0x1p28, {-0.0, 0, -0x1p-30}},
                                     Asked{0x1p-40, 0x1p28, {0, 0x1p-30, 0}}, Asked{0x1p28, 0x1p29, {0x1p-30, 0, 0}}}) {
    CAPTURE(size, v.x, v.y, v.z);
    const scene::Scene scene = corner(20, size);
    const WideBvh tree(scene);
    REQUIRE(tree.bundles());
    std::vector<scene::Query> rays;
    for (int i = 0; i <= 20; ++i)
      for (int j = 0; j <= 20; ++j)
        rays.insert(rays.end(), 8, {ray(across(v, -size * i / 16, -size * j / 16) - far * glm::sign(v), v)});
    check_each_alone(tree, rays);
    std::vector<scene::Query> segments;  // towards a light, along a sheet
    for (int i = 0; i < 256; ++i) {
      const glm::dvec3 p = across(v, 0, -size * i / 256) - size * glm::sign(v);
      segments.push_back({ray(p, across(v, 0, -size / 2) + size / 8 * glm::sign(v) - p)});
    }
    check_each_alone(tree, segments);
  }
}

TEST_CASE("rays along the plane of the triangle that they start on have no nearest point") {
  const scene::Scene scene = sheet(8, 1, {0, 0, 0});
  const WideBvh tree(scene);
  std::vector<scene::Query> queries;
  for (std::uint32_t e = 0; e < 20; ++e) {
    const scene::Triangle triangle = scene.shapes<scene::Triangle>()[e];
    const auto& [a, b, c] = triangle.vertices;
    const glm::dvec3 along = b - a + 0.25 * (c - a);
    for (int i = 0; i < 16; ++i)
      queries.push_back({ray((a + b + c) / 3.0, (1 + i / 16.0) * along), {{model::Tipo::soy_triangulo, e}}});
  }
  check_each_alone(tree, queries);
}

TEST_CASE("rays that go anywhere are answered one by one in a small mesh, but for segments") {
  Random random(8);
  std::vector<scene::Query> queries;
  for (int i = 0; i < 1000; ++i)
    queries.push_back({ray(random.in_cube(1) + glm::dvec3(0.5, 0.5, 0), random.direction())});
  const scene::Scene small = sheet(10, 1, {0, 0, 0}), large = sheet(150, 1, {0, 0, 0});
  const WideBvh in_cache(small), beyond(large);
  check_each_alone(in_cache, queries);
  check_each_alone(beyond, queries);
  CHECK(answered(in_cache, queries, SingleSearch::nearest) > 0.95);
  CHECK(answered(in_cache, queries, SingleSearch::any) < 0.1);
  CHECK(answered(beyond, queries, SingleSearch::nearest) < 0.1);
}

TEST_CASE("few rays, and counts that are no multiple of eight, have their answers") {
  const scene::Scene scene = sheet(12, 1, {0, 0, 0});
  const WideBvh tree(scene);
  const std::vector<scene::Query> rays = camera({0.4, 0.6, -1.7}, {0, 0, 0}, 1, 16);
  for (const std::size_t count : {1, 8, 9, 23, 63, 65, 100, 256})
    check_each_alone(tree, {rays.begin(), rays.begin() + static_cast<std::ptrdiff_t>(count)});
}

TEST_CASE("rays that may meet an element beside the blocks are handed back, and a scene of many has no bundles") {
  scene::Scene scene = sheet(24, 1, {0, 0, 0});
  add(scene, scene::Sphere{{0.5, 0.5, -0.5}, 0.15});
  const WideBvh tree(scene);
  REQUIRE(tree.bundles());
  const std::vector<scene::Query> rays = camera({0.4, 0.6, -1.7}, {0, 0, 0}, 1, 64);
  check_each_alone(tree, rays);
  const double part = answered(tree, rays, SingleSearch::nearest);
  CHECK(part > 0.5);
  CHECK(part < 0.98);
  const std::vector<scene::Query> segments = shadows(tree, rays, {2, -1.5, -1});  // some start on the sphere
  check_each_alone(tree, segments);
  for (int i = 0; i < 20; ++i) add(scene, scene::Sphere{{0.1 * i, 0.5, -2}, 0.05});
  CHECK_FALSE(WideBvh(scene).bundles());
  scene::Scene with_plane = sheet(24, 1, {0, 0, 0});
  add(with_plane, scene::Plane{{0, 0, 4}, {0, 0, 1}});
  CHECK_FALSE(WideBvh(with_plane).bundles());
  CHECK_FALSE(WideBvh(sheet(4, 0x1p31, {0, 0, 0})).bundles());
  CHECK(WideBvh(sheet(4, 0x1p29, {0, 0, 0})).bundles());
}
