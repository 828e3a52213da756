#pragma once
/// Cuts polygons into triangles.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

namespace durero::io {

/// Three vertices of a polygon, by their numbers from 0, in the direction in which the polygon goes round.
using CornerNumbers = std::array<std::uint32_t, 3>;

/// The n − 2 triangles of a polygon of n ≥ 3 vertices, concave or not, ascending. A polygon of more than three vertices
/// is looked at along a coordinate axis, which leaves the other two coordinates as they are, and cut by exact decisions
/// there: so no three vertices of a triangle lie on one line, in space neither, and a polygon that is not exactly flat
/// is cut all the same. The triangles are those of the constrained Delaunay triangulation; where four vertices lie on
/// one circle, the last of them, by the first coordinate and then by the second, is cut off. So they depend neither on
/// where the polygon begins nor on which way it goes. A polygon may come to the border of a hole by a seam, an edge
/// that it goes there and back: of vertices at one place the triangles have the first. Nothing where its edges touch or
/// cross otherwise, along every axis: it encloses no area then, or more than one. A triangle is itself. How many
/// decisions that took is added to `decisions`.
std::optional<std::vector<CornerNumbers>> triangulated(std::span<const glm::dvec3> polygon,
                                                       std::uint64_t* decisions = nullptr);

}  // namespace durero::io
