#pragma once
/// The faces about each vertex.

#include <span>
#include <vector>

#include "durero/mesh/audit.hpp"

namespace durero::mesh {

/// The vertices whose faces fall into fans that share that vertex alone, in ascending order (singulares.def.1).
/// Precondition: each corner of a face is less than the count.
std::vector<SingularVertex> singular_vertices(std::size_t vertex_count, std::span<const CornerNumbers> faces);

}  // namespace durero::mesh
