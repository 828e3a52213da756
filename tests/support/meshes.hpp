#pragma once
/// Closed meshes of triangles, and rays that aim at their edges and vertices: what a mesh is tested for cracks with.

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "durero/scene/scene.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

namespace durero::test {

/// Vertices, and triangles by the numbers of theirs. Closed: each edge is one of two triangles.
struct Mesh {
  std::vector<glm::dvec3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;

  scene::Triangle triangle(std::size_t i) const {
    const auto& [a, b, c] = triangles[i];
    return {{vertices[a], vertices[b], vertices[c]}};
  }
};

/// An octahedron with each triangle cut into four `levels` times, its vertices on the unit sphere about 0.
inline Mesh sphere_mesh(int levels) {
  Mesh mesh{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
            {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  for (; levels > 0; --levels) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t i, std::uint32_t j) {
      const auto [at, is_new] = middles.try_emplace(std::minmax(i, j), std::uint32_t(mesh.vertices.size()));
      if (is_new) mesh.vertices.push_back(glm::normalize(mesh.vertices[i] + mesh.vertices[j]));
      return at->second;
    };
    std::vector<std::array<std::uint32_t, 3>> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
  }
  return mesh;
}

/// The same with each vertex drawn nearer to 0 or pushed away, by up to a quarter. Every point nearer to 0 than 1/4 is
/// inside it: it is star-shaped about 0, and no triangle of a sphere mesh of two levels or more comes as near.
inline Mesh rough_mesh(Random& random, int levels) {
  Mesh mesh = sphere_mesh(levels);
  for (glm::dvec3& vertex : mesh.vertices) vertex *= random.uniform(0.75, 1.25);
  return mesh;
}

/// The same with integer coordinates that are multiples of 64, so that the points at the 64th parts of an edge are too.
inline Mesh lattice_mesh(Random& random, int levels) {
  Mesh mesh = rough_mesh(random, levels);
  for (glm::dvec3& vertex : mesh.vertices) vertex = 64.0 * glm::round(1024.0 * vertex);
  return mesh;
}

/// Triangle i has the name t and i.
inline scene::Scene scene_of(const Mesh& mesh) {
  scene::Scene scene;
  scene.put_off_audits();
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    add(scene, model::Elemento("t" + std::to_string(i)), mesh.triangle(i));
  return scene;
}

/// A point of an edge, by the triangle and the number of the edge in it, and the share of the edge that lies before it:
/// at a vertex where the share is 0.
struct EdgePoint {
  std::size_t triangle, edge;
  double share;

  glm::dvec3 on(const Mesh& mesh) const {
    const auto& numbers = mesh.triangles[triangle];
    const glm::dvec3 &from = mesh.vertices[numbers[edge]], &to = mesh.vertices[numbers[(edge + 1) % 3]];
    return from + share * (to - from);
  }
};

/// One in three at a vertex; `parts` of an edge otherwise.
inline EdgePoint any_edge_point(Random& random, const Mesh& mesh, int parts) {
  const std::size_t triangle = random.below(mesh.triangles.size()), edge = random.below(3);
  return {triangle, edge, random.chance(1, 3) ? 0 : double(random.integer(1, parts - 1)) / parts};
}

}  // namespace durero::test
