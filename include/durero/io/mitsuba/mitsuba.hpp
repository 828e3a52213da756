#pragma once
/// Scenes of Mitsuba 3, in XML. What a scene cannot hold is counted and named, never dropped silently.

#include "durero/io/formats.hpp"

namespace durero::io {

/// Reads a scene with what it includes: sphere, cylinder, disk, rectangle, cube, the meshes of OBJ and PLY files, and
/// instances of shape groups, wherever to_world puts them; bsdf and area emitters as materials; perspective sensors and
/// simple emitters. A shape that is moved is of its type where all lengths are stretched alike, and else a copy by an
/// exact map. Elements are named s1, c1, d1, v1, … by type, cubes and copies b1, …, materials f1, …, groups m1, … of
/// meshes and u1, … of instances. Files are those in the folder of the scene or beneath it. Throws InputError, in the
/// file and at the element or the attribute.
Imported read_mitsuba(const Source& source);

/// Writes a scene. Its triangles are PLY files beside the text, `STEM.mesh1.ply`, …; a copy is an instance of a group
/// of one shape. Planes, cones and other solids than boxes are left out and counted, and so is what else Mitsuba has no
/// place for.
Exported mitsuba_text(const scene::Scene& scene, const scene::Groups& groups, const std::string& stem);

}  // namespace durero::io
