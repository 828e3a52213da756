#pragma once
/// Vertices and the polygons between them, as a file of a mesh has them.

#include <boost/container/small_vector.hpp>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace durero::io {

/// The numbers of its vertices, from 0.
using Face = boost::container::small_vector<std::int64_t, 4>;

/// The vertices, which are finite, and the faces of a mesh in the order of the file. A reader refuses a face that has
/// fewer than three corners, or names a vertex that is not there.
struct PolygonSoup {
  std::vector<glm::dvec3> vertices;
  std::vector<Face> faces;
  std::vector<glm::dvec3> normals{};  ///< of the vertices, which may have no direction; empty where they have none
};

}  // namespace durero::io
