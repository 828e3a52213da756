#pragma once
/// How textures lie on the faces of a mesh.

#include <cstddef>
#include <glm/vec2.hpp>
#include <vector>

#include "polygon_soup.hpp"

namespace durero::io {

struct FaceTextures {
  std::vector<glm::dvec2> uv;
  std::vector<Face> of_face;  ///< at each corner the number of its uv, from 0; of no corner where one has none

  /// At the corners of a face; empty where it has none.
  std::vector<glm::dvec2> at_corners(std::size_t face) const {
    std::vector<glm::dvec2> found;
    if (face >= of_face.size()) return found;
    for (const std::int64_t number : of_face[face]) found.push_back(uv[static_cast<std::size_t>(number)]);
    return found;
  }
};

}  // namespace durero::io
