#pragma once
/// A picture holds linear light, before a file turns it into pixels of some kind.

#include <glm/vec3.hpp>
#include <vector>

#include "durero/scene/stage.hpp"

namespace durero::render {

/// A picture in linear RGB with the primaries of sRGB, as the rays brought it: no component is cut.
struct Picture {
  /// A black picture of that size.
  explicit Picture(scene::Resolution size) : resolution(size), rgb(std::size_t(size.width) * size.height) {}

  scene::Resolution resolution;  ///< in pixels
  std::vector<glm::dvec3> rgb;   ///< rows from the top
};

}  // namespace durero::render
