#pragma once
/// Exact answers about a few points: enclosures decide where they can, exact numbers otherwise.

#include <glm/vec3.hpp>

#include "durero/number/dyadic.hpp"

namespace durero::mesh {

/// Whether the three points lie on one line.
bool are_collinear(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

/// Whether w lies between a and b, and is neither.
bool lies_between(const glm::dvec3& w, const glm::dvec3& a, const glm::dvec3& b);

/// Six times the volume between the origin and three points.
number::Dyadic determinant(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

}  // namespace durero::mesh
