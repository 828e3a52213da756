#pragma once
/// glTF 2.0, the format in which scenes of triangles are sent, as a text or as one binary file (GLB).

#include "durero/io/formats.hpp"

namespace durero::io {

/// Reads the triangles of a glTF scene, of the one that the file names or of its first: modes triangles, strip and fan,
/// with their normals and first texture coordinates, as the nodes place them. A coordinate is the exact image of the
/// numbers that stand there (binary32, or the quotient that a normalized integer is), rounded once to binary64; numbers
/// of the JSON are the nearest binary64. Names and losses are those of read_obj, and so is the direction in which v
/// grows. A triangle is in the group of its node's name, else of its mesh's, else of the nearest node above that has
/// one; groups lie in each other as the nodes do. Buffers are in `data:` URIs, behind the JSON of a GLB file, or in
/// files in the folder of the source's name or beneath it. Throws InputError: what is wrong in a buffer has the place
/// of its accessor, and what is wrong in the chunks of a GLB file the beginning.
Imported read_gltf(const Source& source);

/// @{ Writes the triangles of a scene, with materials, camera and lights: as a text with its buffer in base64, or as
/// the bytes of a GLB file. Groups are nodes. Numbers of triangles are rounded to binary32, and other elements left
/// out; both are counted.
Exported gltf_text(const scene::Scene& scene, const scene::Groups& groups);
Exported gltf_bytes(const scene::Scene& scene, const scene::Groups& groups);
/// @}

}  // namespace durero::io
