#pragma once
/// Hidden surfaces removed with the precision of objects, after Weiler, Atherton and Greenberg (1978): what a light
/// sees is lit, and what an eye sees is drawn.

#include <cstdint>
#include <span>
#include <vector>

#include "durero/polygon/convex.hpp"
#include "durero/polygon/pyramid.hpp"

namespace durero::raster {

/// The parts of some polygons that an apex sees.
struct VisiblePolygons {
  std::vector<std::vector<polygon::Polygon>> parts;  ///< of each polygon, parts that share no area
  std::uint64_t clips = 0;                           ///< parts that were clipped by a polygon before them
};

/// Removes from each polygon what the others hide from the apex. Polygons come by their depth, the nearest first, and
/// each is taken from the parts of others that are left and lie behind it; one that is hidden itself takes nothing
/// that those which hide it leave, and is passed over. Each cut is exact, so that no order makes a wrong picture: a
/// good one makes few cuts.
VisiblePolygons visible_polygons(std::span<const polygon::Polygon> polygons, const polygon::Apex& apex);

}  // namespace durero::raster
