#pragma once
/// The objects of a POV-Ray text that are triangles: mesh2, of vertices and triangles by their numbers, polygon, and
/// prism of straight sides.

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "pov_shapes.hpp"
#include "pov_words.hpp"

namespace durero::io {

/// A mesh as it stands in the text.
struct PovMesh {
  using Corners = std::array<std::uint32_t, 3>;
  std::vector<glm::dvec3> vertices{}, normals{};
  std::vector<Corners> faces{}, faces_of_normals{};
  std::size_t left_out = 0;  ///< parts that tell of looks

  /// Each face as a shape, with the normals of its corners where the mesh has some.
  std::vector<PovShape> triangles() const;
};

/// Reads it from behind its { up to what stands behind its lists.
PovMesh read_pov_mesh(PovWords& in);

/// Reads a polygon from behind its { up to what stands behind its points, as triangles. Its first outline is around all
/// others, which are those of holes; nothing where they are not, or touch themselves or one another.
std::optional<std::vector<PovShape>> read_pov_polygon(PovWords& in);

/// Reads a prism likewise: its sides, and its bottom and its top where it is closed. Nothing where its sides are
/// curved, or its outlines are none of a polygon.
std::optional<std::vector<PovShape>> read_pov_prism(PovWords& in);

/// Whether an object of that word is a group of triangles, which bounds no solid.
bool is_of_triangles(std::string_view word);

}  // namespace durero::io
