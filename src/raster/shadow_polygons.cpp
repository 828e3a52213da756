#include "durero/raster/shadow_polygons.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace durero::raster {

using polygon::Polygon;

ShadowPolygons shadow_polygons(std::span<const Polygon> polygons, const polygon::Apex& light) {
  ShadowPolygons shadows;
  for (std::size_t caster = 0; caster < polygons.size(); ++caster) {
    const auto body = polygon::hidden(light, polygons[caster]);
    for (std::size_t receiver = 0; receiver < polygons.size(); ++receiver) {
      if (receiver == caster) continue;
      ++shadows.pairs;
      if (body.empty()) continue;
      Polygon corners = polygon::clipped(polygons[receiver], body);
      if (!corners.empty()) shadows.all.push_back({caster, receiver, std::move(corners)});
    }
  }
  return shadows;
}

bool is_in_shadow(const ShadowPolygons& shadows, std::span<const Polygon> polygons, std::size_t receiver,
                  const polygon::RationalPoint& point) {
  return std::ranges::any_of(shadows.all, [&](const ShadowPolygon& shadow) {
    if (shadow.receiver != receiver || !polygon::contains(shadow.corners, point)) return false;
    const Polygon& caster = polygons[shadow.caster];
    return polygon::dot(polygon::doubled_area(caster), point - caster[0]) != 0;
  });
}

std::vector<Polygon> lit_parts(const ShadowPolygons& shadows, std::span<const Polygon> polygons, std::size_t receiver) {
  std::vector<Polygon> parts{polygons[receiver]};
  const polygon::Apex across{polygon::doubled_area(polygons[receiver]), true};
  for (const ShadowPolygon& shadow : shadows.all) {
    if (shadow.receiver != receiver) continue;
    const auto body = polygon::pyramid(across, shadow.corners);
    std::vector<Polygon> left;
    for (const Polygon& part : parts) std::ranges::move(polygon::without(part, body), std::back_inserter(left));
    parts = std::move(left);
  }
  return parts;
}

}  // namespace durero::raster
