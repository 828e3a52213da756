#pragma once
/// The normals of a triangle's vertices, where a mesh of triangles stands for a smooth surface. They take part in how a
/// picture is shaded (normal_suave of spec/luz.tex), and in no intersection.

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec3.hpp>

namespace durero::scene {

/// Of the three vertices, in their order; each of any finite length but 0.
using VertexNormals = std::array<glm::dvec3, 3>;

/// Whether each of them has a direction.
inline bool have_directions(const VertexNormals& normals) {
  return std::ranges::all_of(normals, [](const glm::dvec3& n) {
    return n != glm::dvec3(0) && std::isfinite(n.x) && std::isfinite(n.y) && std::isfinite(n.z);
  });
}

}  // namespace durero::scene
