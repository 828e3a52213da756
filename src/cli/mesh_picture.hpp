#pragma once
/// A picture of the findings of a mesh's audit, for `durero check --mesh FILE --picture OUT`.

#include <string>

#include "durero/io/mesh/mesh_check.hpp"

namespace durero::cli {

/// The mesh from a corner above and from the opposite one below, side by side, as a PNG file: faces with findings are
/// red, and the places of findings balls and rods of another colour. Throws std::domain_error, with the half of a
/// message before its file's name, where no triangle has an area, or the mesh is too large or too small to be drawn.
std::string mesh_picture(const io::SceneMesh& mesh, const io::MeshCheck& check);

}  // namespace durero::cli
