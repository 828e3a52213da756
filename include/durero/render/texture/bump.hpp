#pragma once
/// Bump maps (realism seed, 1.2): a relief turns the normal of a surface.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "durero/render/texture/coordinates.hpp"

namespace durero::render {

/// The normal n'' = t'_u × t'_v, of any length, with t'_u = t_u + d_u·n and t'_v = t_v + d_v·n, of a surface of unit
/// normal n whose relief rises by `slope` in units of u and v.
glm::dvec3 normal_of_relief(const Tangents& t, const glm::dvec3& n, const glm::dvec2& slope);

/// The unit normal n' = n''/‖n''‖ on the outer side. It is n itself where there is no slope, where the surface has no
/// tangents, at a pole, and where the relief is so steep that n'' is not finite.
glm::dvec3 bumped(const Tangents& t, const glm::dvec3& n, const glm::dvec2& slope);

}  // namespace durero::render
