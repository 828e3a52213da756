#pragma once
/// Bounds of what lies about an axis.

#include "durero/surface/bounds.hpp"

namespace durero::surface {

/// The ball about the point of the axis at a height, for points no farther from it than `radius` were the axis of unit
/// length.
Ball ball_on_axis(const glm::dvec3& centro, const glm::dvec3& vector, double height, double radius);

/// The box of the discs across the axis at its two ends, of these radii, and so of all between them.
Box box_of_discs(const glm::dvec3& centro, const glm::dvec3& vector, double altura, double base, double top);

}  // namespace durero::surface
