#pragma once
/// Triangles by themselves, gathered into meshes.

#include <string_view>

#include "durero/io/formats.hpp"

namespace durero::io {

/// The triangles of a scene that stand by themselves become faces of meshes, in the order of their rows: of one mesh,
/// or of one for each material and each kind of looks that some have and others have not. The first is called `file`
/// without folders, with `_` for what no name has; the others behind it are numbered from 2. Points that have the same
/// bits and looks stand once. Groups keep their members. A triangle that moves, or whose looks are more than a mesh
/// holds, stays. Throws std::invalid_argument where a face would have the name of another element.
Imported gathered(Imported from, std::string_view file);

}  // namespace durero::io
