#pragma once
/// STL, the format of three-dimensional printers, as text or binary.

#include "durero/io/formats.hpp"

namespace durero::io {

/// Reads the facets of an STL mesh; names and losses are those of read_obj. The file is binary where its length is that
/// of as many facets as it says, and a text otherwise. A coordinate of a binary file is the binary32 that stands there,
/// one of a text the nearest binary64. Each `solid` with a name is a group. Throws InputError; in a binary file its
/// place is the beginning.
Imported read_stl(const Source& source);

/// The triangles of a scene as a text: a `solid` for each group, with the elements that are directly in it. Coordinates
/// are written so that they read back; normals are those of the planes, rounded.
Exported stl_text(const scene::Scene& scene, const scene::Groups& groups);
/// The triangles as bytes, without groups: each coordinate is rounded to the nearest binary32, and those that are
/// another number then are counted. A triangle with a coordinate whose rounding is infinite is left out, and counted.
Exported stl_bytes(const scene::Scene& scene, const scene::Groups& groups);

}  // namespace durero::io
