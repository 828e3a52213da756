#pragma once
/// The extent of a light: its points, of which a picture takes the mean (de_luz_extensa.def.1 of spec/distribuida.tex).

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "durero/scene/stage.hpp"

namespace durero::render {

/// The point of a light for a pair of numbers in (0, 1): anywhere on it, with equal density of area. It is the position
/// of a point.
glm::dvec3 point_of(const scene::Light& light, const glm::dvec2& pair);

}  // namespace durero::render
