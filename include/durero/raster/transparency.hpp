#pragma once
/// Transparent polygons in a Z-buffer (realism seed, 1.4), where light goes straight on through all of them.

#include <cstddef>
#include <vector>

#include "durero/engine/engine.hpp"
#include "durero/polygon/pyramid.hpp"
#include "durero/raster/raster_scene.hpp"
#include "durero/render/output/picture.hpp"

namespace durero::raster {

/// The places of some polygons in an order in which none is drawn after one that hides a part of it. Throws
/// std::domain_error where there is none: some hide each other around.
std::vector<std::size_t> far_to_near(const std::vector<polygon::Polygon>& polygons, const polygon::Apex& eye);

/// The picture of opaque polygons, over which the transparent ones of the list are drawn in that order, each where no
/// opaque one lies before it: mezcla.def.1, with its own colour by the local model. Shadow rays of the engine tell
/// which lights are seen. Precondition: the places are of transparent polygons of raster.polygons().
render::Picture with_transparency(const RasterScene& raster, const engine::Engine& engine,
                                  const std::vector<std::size_t>& order);

/// The places of the transparent polygons, ascending by name.
std::vector<std::size_t> transparent_of(const RasterScene& raster);

}  // namespace durero::raster
