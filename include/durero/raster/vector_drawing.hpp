#pragma once
/// A drawing of lines and areas with the precision of objects: what the eye sees of each polygon, parted by what each
/// light sees of it.

#include <string>
#include <vector>

#include "durero/polygon/convex.hpp"
#include "durero/raster/raster_scene.hpp"

namespace durero::raster {

/// The parts of each polygon that a light sees.
using LitParts = std::vector<std::vector<polygon::Polygon>>;

/// The parts by all pairs of polygons, for each light.
std::vector<LitParts> lit_by_shadows(const RasterScene& raster);
/// The parts by removing what is hidden from each light.
std::vector<LitParts> lit_by_visibility(const RasterScene& raster);

/// A drawing as SVG, in units of pixels: an area for each part, in the colour that the middle
/// of its polygon has in the lights that see the part. The places of its corners
/// have three decimals. Same content, same bytes. Precondition: `lit` is of each light of the scene.
std::string svg(const RasterScene& raster, const std::vector<LitParts>& lit);

}  // namespace durero::raster
