#pragma once
/// The mirrored and the refracted direction, reflexion.def.1 and refraccion.def.1 of spec/iluminacion.tex, in binary64.

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <optional>

namespace durero::render {

/// The unit vector v/|v|, for every v but the null vector: no square of a component is lost, however long or short v
/// is.
glm::dvec3 unit(const glm::dvec3& v);
/// The unit vector v/|v| by way of a power of two, which brings the greatest component near 1.
glm::dvec3 unit_of_any_length(const glm::dvec3& v);

/// Between these lengths the power of two would change no bit. Every sum and product is then the scaled one times a
/// power of two, but for squares below 2⁻¹⁰²²; and those are below 2⁻⁸⁰⁰ of the sum, which they leave as it is.
inline glm::dvec3 unit(const glm::dvec3& v) {
  const double squared = glm::dot(v, v);
  if (squared >= 0x1p-200 && squared <= 0x1p200) return v / std::sqrt(squared);
  return unit_of_any_length(v);
}

/// The mirrored direction of a ray with direction d. Precondition: n is a unit vector.
inline glm::dvec3 mirrored(const glm::dvec3& d, const glm::dvec3& n) { return d - 2 * glm::dot(d, n) * n; }

/// The refracted direction of a ray with the unit direction d, at a surface of unit normal n on the side that the ray
/// comes from; `ratio` is the index of that side over the other. Nothing in total reflection. Media of one index leave
/// d as it is.
inline std::optional<glm::dvec3> refracted(const glm::dvec3& d, const glm::dvec3& n, double ratio) {
  if (ratio == 1) return d;
  const double cosine = -glm::dot(d, n);
  const double squared = 1 - ratio * ratio * (1 - cosine * cosine);
  if (squared < 0) return std::nullopt;
  return (ratio * cosine - std::sqrt(squared)) * n + ratio * d;
}

}  // namespace durero::render
