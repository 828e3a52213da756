#pragma once
/// The choice of an element's volume: of the kinds, and of the intersections of two of them, the one with the least T =
/// n·B + m·I (A §1.2).
///
/// Only rays that meet the first volume of an intersection are tested against the second, so a cheap volume may stand
/// before one that fits. The share of rays that meets the first is known by its surface; the share of these that meets
/// the second is counted on 1024 lines. Wrong shares cost time, never answers. Unions are for objects of several parts:
/// the hull of each element is convex, and no row of balls or boxes about it was found to cost as little.

#include <string>

#include "durero/accel/volume/volume.hpp"

namespace durero::accel {

/// A volume and its expected cost for a ray, in nanoseconds on the machine of docs/acceleration-reference.md.
struct VolumeCost {
  Volume volume;  ///< of one part or more
  double tests;   ///< n·B
  double m;       ///< the share of rays that meet the volume and are tested against the element
  double T;       ///< n·B + m·I
};

/// The cheapest choice for isotropic rays that cross a convex region of that surface. Precondition: the element has an
/// outline (volume/outline.hpp).
VolumeCost choose(scene::ShapeView element, double surface_of_region);

/// The kind of a simple volume.
const VolumeKind& kind_of(const Simple& volume);
/// A description such as `ball`, `ball ∩ ellipsoid` or `ball ∪ ball`, in the order of the tests.
std::string described(const Volume& volume);

}  // namespace durero::accel
