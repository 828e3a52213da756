#pragma once
/// What contains every point of an element: a ball, and a box along the axes of space. Each is wider than the exact one
/// by what its own roundings may be.

#include <glm/vec3.hpp>

namespace durero::surface {

struct Ball {
  glm::dvec3 centre;
  double radius;
};

struct Box {
  glm::dvec3 low, high;
};

}  // namespace durero::surface
