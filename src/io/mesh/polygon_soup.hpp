#pragma once
/// Vertices and the polygons between them, as a library reads them from OBJ and PLY.

#include <boost/container/small_vector.hpp>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace durero::io {

/// The numbers of its vertices, from 0; perhaps of no vertex, since a file may name any.
using Face = boost::container::small_vector<std::int64_t, 4>;

struct PolygonSoup {
  std::vector<glm::dvec3> vertices;
  std::vector<Face> faces;
  std::vector<std::size_t> face_ends;  ///< of PLY: behind the last byte of each face
  std::size_t end = 0;                 ///< behind the last byte that the library read
  bool whole = false;                  ///< whether it read all that it expected
};

/// What the library makes of a text. It passes over much that is wrong, so that the readers of OBJ and PLY look at the
/// text too. Its lines end at "\n" alone, and the blanks of OBJ are spaces: append_plain writes them so.
PolygonSoup obj_soup(std::string_view text);
PolygonSoup ply_soup(std::string_view text);

/// Appends the text, byte for byte, with "\n" where a line ends and spaces for all other blanks.
void append_plain(std::string& out, std::string_view text);

}  // namespace durero::io
