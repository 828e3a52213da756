#pragma once
/// The direction in which a surface faces.

#include <glm/vec3.hpp>

#include "durero/scene/scene.hpp"

namespace durero::surface {

/// The unit normal of an element at a point of it: the gradient of its potencia, on the outer side. Where the gradient
/// is null, at the apex of a cone, it is the axis.
glm::dvec3 normal(const scene::Scene& scene, scene::ElementRef element, const glm::dvec3& point);

}  // namespace durero::surface
