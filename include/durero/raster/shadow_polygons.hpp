#pragma once
/// Shadows with the precision of objects (realism seed, 1.3): polygons of detail, on the polygons of a scene, in which
/// a light is not seen.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "durero/polygon/convex.hpp"
#include "durero/polygon/pyramid.hpp"

namespace durero::raster {

/// The shadow of one polygon on another.
struct ShadowPolygon {
  std::size_t caster;        ///< the place of the polygon that throws it
  std::size_t receiver;      ///< the place of the polygon that it falls on
  polygon::Polygon corners;  ///< the part of the receiver in it
};

/// All shadows of some polygons on each other.
struct ShadowPolygons {
  std::vector<ShadowPolygon> all;  ///< by caster, then by receiver
  std::uint64_t pairs = 0;         ///< pairs of polygons that were projected and clipped
};

/// Projects each polygon on each other one from the light, and clips it by that one: sombra.def.1, but for what has no
/// area. A polygon whose plane the light lies in throws none.
ShadowPolygons shadow_polygons(std::span<const polygon::Polygon> polygons, const polygon::Apex& light);

/// Whether a point of a polygon's plane lies in one of the shadows on it. A shadow has its edges, but no point that
/// lies in the caster's plane: nothing is between such a point and the light.
bool is_in_shadow(const ShadowPolygons& shadows, std::span<const polygon::Polygon> polygons, std::size_t receiver,
                  const polygon::RationalPoint& point);

/// The parts of a polygon outside the shadows on it: iluminada.def.1. No two of them share an area.
std::vector<polygon::Polygon> lit_parts(const ShadowPolygons& shadows, std::span<const polygon::Polygon> polygons,
                                        std::size_t receiver);

}  // namespace durero::raster
