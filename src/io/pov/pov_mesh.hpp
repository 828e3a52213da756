#pragma once
/// The mesh2 of a POV-Ray text: vertices, and triangles by their numbers.

#include <array>
#include <cstdint>
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

}  // namespace durero::io
