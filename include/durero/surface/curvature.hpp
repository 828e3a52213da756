#pragma once
/// The curvature of a surface: how its normal turns beside a point.

#include <glm/mat3x3.hpp>

#include "durero/scene/scene.hpp"

namespace durero::surface {

/// The derivative of normal(): for a small step v along the surface, the normal changes by curvature·v. It is
/// symmetric, and takes what is across the surface to 0. It is 0 where there is no normal, and on whatever is flat.
/// Preconditions: those of normal().
glm::dmat3 curvature(const scene::Scene& scene, scene::ElementRef element, const glm::dvec3& point);

}  // namespace durero::surface
