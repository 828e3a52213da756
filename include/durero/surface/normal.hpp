#pragma once
/// The normal of a surface.

#include <glm/vec3.hpp>

#include "durero/scene/scene.hpp"

namespace durero::surface {

/// The unit normal of an element at one of its points: the gradient of its potencia, on the outer side. At the apex of
/// a cone, where the gradient is null, it is the axis. Precondition: the element is in the scene.
glm::dvec3 normal(const scene::Scene& scene, scene::ElementRef element, const glm::dvec3& point);

}  // namespace durero::surface
