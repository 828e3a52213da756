#pragma once
/// NFF, the Neutral File Format of the Standard Procedural Databases. What one side holds and the other cannot is
/// counted and named, never dropped silently.

#include "durero/io/formats.hpp"

namespace durero::io {

/// Reads NFF: `v` becomes camera and resolution, `b` background, `l` lights, `f` materials (colour · Kd; fills of one
/// colour are one material), `s` spheres, `c` cylinders where its radii are the same, cones where one of them is 0, or
/// truncated cones. Polygons (`p`, and `pp` without its normals), concave or not, are cut into triangles; those whose
/// edges touch or cross are left out, and counted. Elements are named s1, c1, k1, t1, p1, … by type, triangles after
/// their polygons, and materials f1, ….
/// A light without colour is white of 1/√n, n the number of lights: the format gives it no value.
/// Throws InputError.
Imported read_nff(const Source& source);

/// Writes NFF; planes, discs and groups are left out, and counted; a triangle is a polygon. Elements follow the fill of
/// their material, those without one come before all fills.
Exported nff_text(const scene::Scene& scene, const scene::Groups& groups = {});

}  // namespace durero::io
