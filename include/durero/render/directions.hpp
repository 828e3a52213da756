#pragma once
/// reflexion.def.1 and refraccion.def.1 of spec/iluminacion.tex, in binary64.

#include <glm/vec3.hpp>
#include <optional>

namespace durero::render {

/// v over its length, for every v but the null vector: no square of a component is lost, however long or short it is.
glm::dvec3 unit(const glm::dvec3& v);

/// The direction in which a ray of direction d goes on from a mirror. Precondition: n is a unit vector.
glm::dvec3 mirrored(const glm::dvec3& d, const glm::dvec3& n);

/// The direction in which a ray of the unit direction d goes on behind a surface of unit normal n, which points to the
/// side that it comes from; `ratio` is the index of that side over the other. Nothing in total reflection. Media of one
/// index leave d as it is.
std::optional<glm::dvec3> refracted(const glm::dvec3& d, const glm::dvec3& n, double ratio);

}  // namespace durero::render
