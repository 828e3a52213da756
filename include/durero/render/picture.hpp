#pragma once
/// A picture in linear light, before a file of some kind of pixels is made of it.

#include <glm/vec3.hpp>
#include <vector>

#include "durero/scene/stage.hpp"

namespace durero::render {

/// Linear RGB with the primaries of sRGB, as the rays brought it: no component is cut.
struct Picture {
  /// Of that size, black.
  explicit Picture(scene::Resolution size) : resolution(size), rgb(std::size_t(size.width) * size.height) {}

  scene::Resolution resolution;  ///< in pixels
  std::vector<glm::dvec3> rgb;   ///< rows from the top
};

}  // namespace durero::render
