#pragma once
/// Scenes and rays for the comparison with Embree. Their coordinates are numbers of binary32, which Embree takes, but
/// for the origins of shadow rays.

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <string_view>
#include <vector>

#include "durero/model/operaciones.hpp"
#include "durero/scene/hit.hpp"
#include "durero/scene/mesh_edit.hpp"
#include "durero/scene/query.hpp"
#include "durero/scene/scene.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

namespace durero::versus {

/// A cylinder or a cone between two points, or a sphere at the first.
struct CurvedElement {
  model::Tipo tipo;
  glm::dvec3 a, b;
  double radius, top;
};

/// The same elements for both: curved ones, or triangles.
struct BenchScene {
  scene::Scene durero;
  std::vector<CurvedElement> curved;
  std::vector<std::array<glm::dvec3, 3>> triangles;
};

inline double single(double x) { return static_cast<double>(static_cast<float>(x)); }
inline glm::dvec3 single(const glm::dvec3& x) { return {single(x.x), single(x.y), single(x.z)}; }

/// Elements in the unit cube, a third of each of spheres, cylinders and cones: the scene of trace_bench.
inline BenchScene curved_scene(std::size_t n) {
  test::Random random(1);
  BenchScene scenes;
  const double unit = 0.25 * std::cbrt(1 / static_cast<double>(n));
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec3 centro = single(random.in_cube(0.5) + 0.5);
    const double radio = single(unit * random.uniform(0.5, 1));
    const double altura = single(unit * random.uniform(1.5, 3));
    const glm::dvec3 axis = random.axis().xyz();
    const glm::dvec3 end = centro + altura * axis;
    if (i % 3 == 0) {
      test::add(scenes.durero, scene::Sphere{centro, radio});
      scenes.curved.push_back({model::Tipo::soy_esfera, centro, centro, radio, radio});
    } else if (i % 3 == 1) {
      test::add(scenes.durero, scene::Cylinder{centro, radio, axis, altura});
      scenes.curved.push_back({model::Tipo::soy_cilindro, centro, end, radio, radio});
    } else {
      test::add(scenes.durero, scene::Cone{centro, radio / altura, axis, altura});
      scenes.curved.push_back({model::Tipo::soy_cono, centro, end, radio, 0});
    }
  }
  return scenes;
}

inline void put(BenchScene& scenes, const std::array<glm::dvec3, 3>& vertices) {
  test::add(scenes.durero, scene::Triangle{vertices});
  scenes.triangles.push_back(vertices);
}

/// A wavy sheet of some n triangles over the unit square, as a mesh.
inline BenchScene mesh_scene(std::size_t n) {
  BenchScene scenes;
  scene::Mesh mesh{model::Elemento("sheet")};
  const auto k = static_cast<std::size_t>(std::sqrt(static_cast<double>(n) / 2));
  std::vector<glm::dvec3> at;
  for (std::size_t i = 0; i <= k; ++i)
    for (std::size_t j = 0; j <= k; ++j) {
      const double x = static_cast<double>(i) / static_cast<double>(k),
                   y = static_cast<double>(j) / static_cast<double>(k);
      const double z = 0.5 + 0.2 * std::sin(12 * x) * std::cos(9 * y) + 0.05 * std::sin(50 * x * y);
      at.push_back(single(glm::dvec3(x, y, z)));
    }
  mesh.puntos = at;
  mesh.caras.reserve(2 * k * k);
  for (std::size_t i = 0; i < k; ++i)
    for (std::size_t j = 0; j < k; ++j) {
      const auto o = static_cast<model::Ordinal>(i * (k + 1) + j), below = static_cast<model::Ordinal>(o + k + 1);
      mesh.caras.push_back({o, o + 1, below});
      mesh.caras.push_back({o + 1, below + 1, below});
    }
  for (const auto [a, b, c] : mesh.caras) scenes.triangles.push_back({at[a], at[b], at[c]});
  scenes.durero.apply_total(scene::MeshEdit(scene::MeshAddition{std::move(mesh)}));
  return scenes;
}

/// Triangles at random in the unit cube.
inline BenchScene soup_scene(std::size_t n) {
  test::Random random(1);
  BenchScene scenes;
  const double unit = 0.5 * std::cbrt(1 / static_cast<double>(n));
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec3 centre = random.in_cube(0.5) + 0.5;
    const glm::dvec3 b = centre + unit * random.direction(), c = centre + unit * random.direction();
    put(scenes, {single(centre), single(b), single(c)});
  }
  return scenes;
}

using Queries = std::vector<scene::Query>;

/// The even bits of a number.
inline std::uint32_t even_bits(std::uint64_t x) {
  std::uint32_t bits = 0;
  for (int i = 0; i < 16; ++i) bits |= static_cast<std::uint32_t>(x >> (2 * i) & 1) << i;
  return bits;
}

/// Rays of a pinhole, in Morton order.
inline Queries primary(std::uint32_t size) {
  Queries queries;
  for (std::uint64_t i = 0; i < std::uint64_t{size} * size; ++i) {
    const auto place = [&](std::uint32_t at) { return (2 * (at + 0.5) / size - 1) * 0.55 / 1.2; };
    const glm::dvec3 v = glm::normalize(glm::dvec3(place(even_bits(i)), place(even_bits(i >> 1)), 1));
    queries.push_back({test::ray({0.5, 0.5, single(-1.2)}, single(v))});
  }
  return queries;
}

/// Rays of uniform origins and directions.
inline Queries incoherent(std::size_t count) {
  test::Random random(2);
  Queries queries;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec3 from = single(random.in_cube(0.5) + 0.5);
    queries.push_back({test::ray(from, single(random.direction()))});
  }
  return queries;
}

/// Segments from each hit to one light.
inline Queries shadow(const std::vector<scene::Hit>& hits) {
  Queries queries;
  for (const scene::Hit& hit : hits)
    if (hit.resultado == model::Resultado::hit)
      queries.push_back({test::ray(hit.punto, glm::dvec3(0.3, 2.5, -0.8) - hit.punto), hit.elementos});
  return queries;
}

}  // namespace durero::versus
