#pragma once
/// The values that the faces of a mesh have at their corners: how textures lie on them, and normals.

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "polygon_soup.hpp"

namespace durero::io {

/// The values of one kind, and which of them each face has.
template <class Value>
struct FaceCorners {
  std::vector<Value> values;
  std::vector<Face> of_face;  ///< at each corner the number of its value, from 0; of no corner where one has none

  /// At the corners of a face; empty where it has none.
  std::vector<Value> at_corners(std::size_t face) const {
    std::vector<Value> found;
    if (face >= of_face.size()) return found;
    for (const std::int64_t number : of_face[face]) found.push_back(values[static_cast<std::size_t>(number)]);
    return found;
  }
};

/// The looks of the faces of a mesh.
struct FaceLooks {
  FaceCorners<glm::dvec2> textures;
  FaceCorners<glm::dvec3> normals;
};

}  // namespace durero::io
