#pragma once
/// The scene description language of POV-Ray 3.7, written and read. What one side holds and the other cannot is counted
/// and named, never dropped silently.

#include "durero/io/formats.hpp"

namespace durero::io {

/// Runs a text and reads what it leaves: sphere, cylinder, cone, disc, plane, triangle, smooth_triangle and object;
/// what is not open has caps, discs that are a group with it. mesh, mesh2, polygon and union are groups, of what stands
/// in them; box, merge, intersection and difference are solids. An object that is moved is of its type where it can be,
/// and else a copy by an exact map. A pigment of one colour with a finish, an average of such and an ior are a
/// material; another texture is its mean colour, or left out. camera, light_source, background, global_settings and a
/// first line with the size are the stage. Elements are named s1, c1, k1, t1, p1, d1, v1, … by type, bodies b1, …,
/// materials f1, …, groups u1, … and m1, …, and of an object with caps as its first element. Throws InputError, in the
/// file and at the word, where the text is wrong, does not end within bounds, or asks what it has no answer to.
Imported read_pov(const Source& source);

/// Writes a scene that POV-Ray draws by the same model of light, in linear light: camera, background, lights, materials
/// and elements. What a texture of POV-Ray has one of (a colour, a finish) and a material several is an average of
/// textures; a group is a union. Glass casts the full shadow of a stone: it has no shadow itself, and an opaque twin
/// that nothing but a shadow shows.
Exported pov_text(const scene::Scene& scene, const scene::Groups& groups = {});

}  // namespace durero::io
