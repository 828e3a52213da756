#pragma once
/// A scene of triangles from a mesh.

#include <string>
#include <vector>

#include "durero/io/formats.hpp"
#include "polygon_soup.hpp"

namespace durero::io {

/// The triangles of all faces, named by the file; what is left out is appended to what is lost. Precondition: each face
/// has at least three vertices, which are there.
Imported mesh_scene(const Source& source, const PolygonSoup& soup, std::vector<std::string> lost);

}  // namespace durero::io
