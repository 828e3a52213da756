#pragma once
/// Pictures with shadows by each of the techniques of the realism seed, 1.3.

#include <cstdint>

#include "durero/engine/engine.hpp"
#include "durero/raster/depth_map.hpp"
#include "durero/raster/projector.hpp"
#include "durero/raster/raster_scene.hpp"
#include "durero/render/output/picture.hpp"

namespace durero::raster {

/// A picture, and the work that it took.
struct DrawnShadows {
  render::Picture picture;       ///< linear colours
  std::uint64_t operations = 0;  ///< pairs that were projected, or parts that were clipped
  std::uint64_t polygons = 0;    ///< polygons of detail, over all lights
};

/// The picture in which a light is dark where a shadow polygon lies: for each light all pairs of polygons.
DrawnShadows by_shadow_polygons(const RasterScene& raster);

/// The picture in which a light is bright where a part lies that it sees.
DrawnShadows by_lit_polygons(const RasterScene& raster);

/// The picture by depth maps of that size. Throws std::domain_error where a light is a directional one.
render::Picture by_depth_maps(const RasterScene& raster, std::uint32_t size, DepthBias bias);

/// The picture in which the first light throws a picture, its shadows by a depth map of that size. Throws as
/// by_depth_maps(), and without a light.
render::Picture by_projector(const RasterScene& raster, const Projector& projector, std::uint32_t size);

/// The picture of by_projector() by rays: first hits and shadow rays of an engine. Throws std::domain_error without a
/// point light.
render::Picture projected_by_rays(const RasterScene& raster, const engine::Engine& engine, const Projector& projector);

}  // namespace durero::raster
