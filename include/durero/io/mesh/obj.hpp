#pragma once
/// OBJ, Wavefront's format of polygons.

#include "durero/io/formats.hpp"

namespace durero::io {

/// Reads the vertices (`v`) and faces (`f`) of an OBJ mesh: a face is a triangle, or a polygon that is cut
/// into triangles; where each of its corners names a texture coordinate (`vt`), so do their vertices. They are named
/// FILE:1, FILE:2, … in the order of the file, FILE being its name without folders. The first name of `g` or `o` is a
/// group of the triangles that follow, up to the next `g` or `o`. Triangles whose vertices lie on one line and polygons
/// whose edges touch or cross are left out, and counted; so is every statement that no triangle keeps. Throws
/// InputError.
Imported read_obj(const Source& source);

/// The triangles of a scene, each point and each normal once: numbers are written so that they read back. The elements
/// that are directly in a group stand behind its `g`.
Exported obj_text(const scene::Scene& scene, const scene::Groups& groups);

}  // namespace durero::io
