#pragma once
/// Scene files of pbrt, versions 3 and 4. What a scene cannot hold is counted and named, never dropped silently.

#include "durero/io/formats.hpp"

namespace durero::io {

/// Reads a scene with what it includes: sphere, cylinder, cone and disk where they are whole, trianglemesh, plymesh,
/// flat patches of bilinearmesh, and instances of objects, wherever the transformations put them; materials by their
/// colours; perspective cameras, simple lights and the size of the film. A shape that is moved is of its type where all
/// lengths are stretched alike, and else a copy by an exact map. Elements are named s1, c1, k1, d1, v1, … by type,
/// copies b1, …, materials f1, …, groups m1, … of meshes and u1, … of instances. Files are those in the folder of the
/// scene or beneath it. Throws InputError, in the file and at the word.
Imported read_pbrt(const Source& source);

/// Writes a scene for pbrt 4. Triangles and boxes are meshes in the text, and a copy is a shape under its own map.
/// Planes, cones and other solids than boxes are left out and counted, and so is what else pbrt has no place for.
Exported pbrt_text(const scene::Scene& scene, const scene::Groups& groups);

}  // namespace durero::io
