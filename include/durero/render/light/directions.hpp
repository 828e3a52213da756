#pragma once
/// The mirrored and the refracted direction, reflexion.def.1 and refraccion.def.1 of spec/iluminacion.tex, in binary64.

#include <glm/vec3.hpp>
#include <optional>

namespace durero::render {

/// The unit vector v/|v|, for every v but the null vector: no square of a component is lost, however long or short v
/// is.
glm::dvec3 unit(const glm::dvec3& v);

/// The mirrored direction of a ray with direction d. Precondition: n is a unit vector.
glm::dvec3 mirrored(const glm::dvec3& d, const glm::dvec3& n);

/// The refracted direction of a ray with the unit direction d, at a surface of unit normal n on the side that the ray
/// comes from; `ratio` is the index of that side over the other. Nothing in total reflection. Media of one index leave
/// d as it is.
std::optional<glm::dvec3> refracted(const glm::dvec3& d, const glm::dvec3& n, double ratio);

}  // namespace durero::render
