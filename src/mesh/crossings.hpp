#pragma once
/// The faces that cross, exactly.

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "durero/mesh/audit.hpp"

namespace durero::mesh {

/// Every two faces that have more points in common than the corners that they share, or the edge between these, in
/// ascending order (cruzadas.def.1). Precondition: each corner of a face is the number of a vertex.
std::vector<CrossingFaces> crossings(std::span<const glm::dvec3> vertices, std::span<const CornerNumbers> faces);

}  // namespace durero::mesh
