#pragma once
/// How textures lie on a triangle, where they are not to follow its own (u, v): what a mesh says of its vertices.

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

namespace durero::scene {

/// Tangent and bitangent at a vertex: the directions in which u and v grow there, by how much.
using VertexTangents = std::array<glm::dvec3, 2>;

/// Of the three vertices, in their order.
struct Wrap {
  std::array<glm::dvec2, 3> uv{};                              ///< (u, v), linear in between
  std::optional<std::array<VertexTangents, 3>> tangents = {};  ///< linear in between; else those of uv, of the whole
  bool operator==(const Wrap&) const = default;
};

}  // namespace durero::scene
