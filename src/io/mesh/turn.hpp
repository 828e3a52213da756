#pragma once
/// How points of a plane lie to each other: exact decisions on binary64 coordinates of any size.

#include <glm/vec2.hpp>

namespace durero::io {

/// The turn a → b → c goes left (1), right (−1), or not at all: the three lie on one line (0).
int turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c);

/// The point d lies inside the circle through a, b and c (1), outside (−1) or on it (0). Precondition: a → b → c goes
/// left.
int circle_side(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d);

}  // namespace durero::io
