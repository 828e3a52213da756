#pragma once
/// PLY, the polygon format of Stanford, as text or binary.

#include "durero/io/formats.hpp"

namespace durero::io {

/// Reads the elements `vertex` and `face` of a PLY mesh; names and losses are those of read_obj. A
/// coordinate of type float is the nearest binary32 to what is written. Throws InputError; in a binary file its place
/// is the line of the header that tells of the element.
Imported read_ply(const Source& source);

/// The triangles of a scene as a text, each vertex once: numbers are doubles, written so that they read back. Vertices
/// have normals where all triangles have them.
Exported ply_text(const scene::Scene& scene, const scene::Groups& groups);
/// The triangles as bytes, the least of a number first, with the losses of the text: no bit is rounded.
Exported ply_bytes(const scene::Scene& scene, const scene::Groups& groups);

}  // namespace durero::io
