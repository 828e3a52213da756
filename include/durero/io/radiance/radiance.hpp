#pragma once
/// Scenes of Radiance (.rad), the program of G. Ward for light in buildings. What a scene has not is counted and named,
/// never dropped silently.

#include "durero/io/formats.hpp"

namespace durero::io {

/// Reads a description of a scene for Radiance. `sphere` and `bubble`, `cylinder` and `tube`, `cone` and `cup` become
/// elements of their types, `ring` without a hole a disc, `polygon` triangles; all are open, as they are there.
/// Elements are named s1, c1, k1, t1, d1, p1, … by type. Those of one identifier are a group of that name. The commands
/// `xform`, `genbox` and `cat` are carried out, also behind one another, and no other is: files are searched below the
/// folder of the text. Throws InputError, in the file and at the place where it is wrong.
Imported read_radiance(const Source& source);

/// Writes a scene and groups of its elements. The identifier of an element is the name of the group that it is directly
/// in, else of its mesh, else its own. Planes, copies and other solids than boxes are left out and counted, and so is
/// what else Radiance has no place for.
Exported radiance_text(const scene::Scene& scene, const scene::Groups& groups);

}  // namespace durero::io
