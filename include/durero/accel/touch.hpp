#pragma once
/// The test of which cells an element is in: those that its surface touches. A cell wholly inside a sphere, or inside
/// the wall of a cylinder or cone, holds no point of the surface.

#include "durero/scene/shape_view.hpp"
#include "durero/surface/bounds.hpp"

namespace durero::accel {

/// Whether the surface of an element touches a closed box. It is never false where the surface does. It may also be
/// true
///   for a sphere and a triangle, where less than 2⁻⁴⁰ of their distance and size lies between it and the box;
///   for a disc, a cylinder, a cone and a truncated cone, where none of the planes that touch.cpp tries separates the
///   box from the solid between the ends; and where that solid contains the box, but not strictly.
/// Preconditions: the element is ordinary; the corners of the box are 0 or of magnitude 2⁻¹⁵⁰ … 2¹⁵⁰.
bool touches(scene::ShapeView element, const surface::Box& box);

}  // namespace durero::accel
