#pragma once
/// A mesh as the bytes of a PLY file.

#include <string>

#include "io/written/triangle_sets.hpp"

namespace durero::io {

/// `binary_little_endian`, of doubles: points and, where it is told so, normals.
std::string ply_mesh_bytes(const IndexedMesh& mesh, bool with_normals);

}  // namespace durero::io
