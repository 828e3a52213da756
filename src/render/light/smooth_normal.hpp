#pragma once
/// The normal that a point is shaded by, where a mesh of triangles stands for a smooth surface.

#include <glm/vec3.hpp>

#include "durero/scene/scene.hpp"

namespace durero::render {

/// The unit normal between those of the vertices at a point of the element (normal_suave of spec/luz.tex), on the side
/// of n; n itself, to the last bit, if the vertices have none or theirs cancel out. Precondition: n is the element's
/// unit normal there.
glm::dvec3 smooth_normal(const scene::Scene& scene, scene::ElementRef element, const glm::dvec3& point,
                         const glm::dvec3& n);

}  // namespace durero::render
