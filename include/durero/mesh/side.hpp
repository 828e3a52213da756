#pragma once
/// The side of a mesh on which a point stands, exactly: which is spec/auditoria.tex's encerrados.

#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "durero/mesh/audit.hpp"

namespace durero::mesh {

/// The place of a point beside the faces that bound a solid.
enum class Side { inside, outside, on_surface };

/// The side of a point: it is inside where a ray from it meets an odd number of faces. Nothing where the faces bound
/// nothing, since some edge has an odd number of them, or one has its corners on one line, and the point is on none of
/// them. In O(n log n) by the number of faces. Precondition: vertices and point are finite, and each corner of a face
/// is the number of a vertex; throws std::out_of_range otherwise.
std::optional<Side> side_of(std::span<const glm::dvec3> vertices, std::span<const CornerNumbers> faces,
                            const glm::dvec3& point);

}  // namespace durero::mesh
