#pragma once
/// Which volume an element is to have: of the kinds and of the intersections of two of them, the one that has the least
/// T = n·B + m·I.
///
/// The second volume of an intersection is tried by those rays alone that meet the first, and so a cheap one may stand
/// before one that fits. What share of the rays meets the first is known by its surface; how many of these meet the
/// second is counted on 1024 lines. Wrong shares cost time, never answers. Unions are for objects of several parts: the
/// hull of each element is convex, and no row of balls or boxes about it has been seen to cost as little.

#include <string>

#include "durero/accel/volume/volume.hpp"

namespace durero::accel {

/// A volume, and what it is expected to cost for a ray, in nanoseconds on the machine of docs/acceleration.md.
struct Choice {
  Volume volume;  ///< of one part or more
  double tests;   ///< n·B
  double m;       ///< the share of rays that it lets through to the element
  double T;       ///< both together
};

/// The cheapest of all for isotropic rays that cross a convex region of that surface. Precondition: the element has an
/// outline (volume/outline.hpp).
Choice choose(scene::ShapeView element, double surface_of_region);

/// Of a volume that is one of the kinds.
const Kind& kind_of(const Simple& volume);
/// Such as `ball`, `ball ∩ ellipsoid` or `ball ∪ ball`, in the order of their tests.
std::string described(const Volume& volume);

}  // namespace durero::accel
