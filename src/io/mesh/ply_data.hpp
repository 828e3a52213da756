#pragma once
/// The data of a PLY file, behind its header.

#include "durero/io/source.hpp"
#include "ply_header.hpp"
#include "polygon_soup.hpp"

namespace durero::io {

/// Reads every item of every element, and keeps the coordinates of the vertices and the vertices of the faces. Each
/// number is one of its type. Throws InputError: in a text the place is that of the word, in a binary file that of the
/// element in the header.
PolygonSoup read_ply_data(const Source& source, const PlyHeader& header);

}  // namespace durero::io
