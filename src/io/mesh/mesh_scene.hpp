#pragma once
/// A scene of triangles from a mesh.

#include <string>
#include <vector>

#include "durero/io/formats.hpp"
#include "face_corners.hpp"
#include "face_groups.hpp"
#include "polygon_soup.hpp"

namespace durero::io {

/// The triangles of all faces, named by the file, and those groups of faces that have some; what is left out is
/// appended to what is lost. Textures and normals are those of the
/// faces; a soup with normals has them in place of its faces. Precondition: each face has at least three vertices,
/// which are there; the names are those of groups.
Imported mesh_scene(const Source& source, const PolygonSoup& soup, std::vector<std::string> lost,
                    const FaceGroups& groups = {}, const FaceLooks& looks = {});

}  // namespace durero::io
