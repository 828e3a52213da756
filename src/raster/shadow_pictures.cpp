#include "durero/raster/shadow_pictures.hpp"

#include <map>
#include <stdexcept>

#include "durero/raster/shadow_polygons.hpp"
#include "durero/raster/visible_polygons.hpp"
#include "durero/scene/query.hpp"

namespace durero::raster {
namespace {

/// Whether something holds, for each pixel.
using PixelMask = std::vector<std::uint8_t>;

/// Marks the pixels that show a detail of a polygon.
void mark(PixelMask& mask, const RasterScene& raster, std::size_t polygon, const polygon::Polygon& detail) {
  const ViewPolygon seen(detail, raster.view().eye());
  raster.view().for_each_met(detail, seen, [&](std::uint32_t x, std::uint32_t y, const glm::dvec3&) {
    const std::size_t pixel = std::size_t(y) * raster.view().resolution().width + x;
    if (raster.nearest(pixel) == polygon) mask[pixel] = 1;
  });
}

std::size_t pixels_of(const RasterScene& raster) {
  return std::size_t(raster.view().resolution().width) * raster.view().resolution().height;
}

/// The picture in which light i is seen at the pixels that lit(i, pixel) says.
template <class Lit>
render::Picture lit_where(const RasterScene& raster, const Lit& lit) {
  const LightColors colors = colors_of(raster.scene().stage());
  return raster.shaded([&](std::size_t pixel, const RasterPoint& at) {
    LightColors bright = colors;
    for (std::size_t i = 0; i < bright.size(); ++i)
      if (!lit(i, pixel, at)) bright[i] = glm::dvec3(0);
    return bright;
  });
}

std::vector<DepthMap> maps_of(const RasterScene& raster, std::uint32_t size) {
  const scene::Stage& stage = raster.scene().stage();
  if (!stage.directional_lights.empty())
    throw std::domain_error("a light shines from a direction, about which there is no cube; expected point lights");
  std::vector<DepthMap> maps;
  for (const scene::Light& light : stage.lights) maps.emplace_back(raster.corners(), light.position, size);
  return maps;
}

void require_point_light(const RasterScene& raster) {
  if (raster.scene().stage().lights.empty())
    throw std::domain_error("no point light can throw a picture; expected one");
}

}  // namespace

DrawnShadows by_shadow_polygons(const RasterScene& raster) {
  std::vector<PixelMask> dark;
  DrawnShadows drawn{render::Picture(raster.view().resolution())};
  for (const polygon::Apex& light : apexes_of(raster.scene().stage())) {
    const ShadowPolygons shadows = shadow_polygons(raster.corners(), light);
    dark.emplace_back(pixels_of(raster));
    for (const ShadowPolygon& shadow : shadows.all) mark(dark.back(), raster, shadow.receiver, shadow.corners);
    drawn.operations += shadows.pairs;
    drawn.polygons += shadows.all.size();
  }
  drawn.picture = lit_where(
      raster, [&](std::size_t light, std::size_t pixel, const RasterPoint&) { return dark[light][pixel] == 0; });
  return drawn;
}

DrawnShadows by_lit_polygons(const RasterScene& raster) {
  std::vector<PixelMask> lit;
  DrawnShadows drawn{render::Picture(raster.view().resolution())};
  for (const polygon::Apex& light : apexes_of(raster.scene().stage())) {
    const VisiblePolygons visible = visible_polygons(raster.corners(), light);
    lit.emplace_back(pixels_of(raster));
    for (std::size_t i = 0; i < visible.parts.size(); ++i) {
      for (const polygon::Polygon& part : visible.parts[i]) mark(lit.back(), raster, i, part);
      drawn.polygons += visible.parts[i].size();
    }
    drawn.operations += visible.clips;
  }
  drawn.picture = lit_where(
      raster, [&](std::size_t light, std::size_t pixel, const RasterPoint&) { return lit[light][pixel] != 0; });
  return drawn;
}

render::Picture by_depth_maps(const RasterScene& raster, std::uint32_t size, DepthBias bias) {
  const std::vector<DepthMap> maps = maps_of(raster, size);
  return lit_where(raster, [&](std::size_t light, std::size_t, const RasterPoint& at) {
    return !maps[light].is_dark(*at.polygon, at.point, bias);
  });
}

render::Picture by_projector(const RasterScene& raster, const Projector& projector, std::uint32_t size) {
  require_point_light(raster);
  const std::vector<DepthMap> maps = maps_of(raster, size);
  const LightColors colors = colors_of(raster.scene().stage());
  return raster.shaded([&](std::size_t, const RasterPoint& at) {
    LightColors bright = colors;
    bright[0] *= projector.color_on(at.point);
    for (std::size_t i = 0; i < maps.size(); ++i)
      if (maps[i].is_dark(*at.polygon, at.point, DepthBias::texel)) bright[i] = glm::dvec3(0);
    return bright;
  });
}

render::Picture projected_by_rays(const RasterScene& raster, const engine::Engine& engine, const Projector& projector) {
  require_point_light(raster);
  const auto [width, height] = raster.view().resolution();
  std::map<scene::ElementRef, const ScenePolygon*> polygons;
  for (const ScenePolygon& one : raster.polygons()) polygons[one.element] = &one;
  std::vector<scene::Query> queries;
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::uint32_t x = 0; x < width; ++x)
      queries.push_back({{model::Punto(raster.view().eye()), model::Vector(raster.view().direction(x, y))}});
  const std::vector<scene::Hit> hits = engine::first_hits(engine, queries);
  std::vector<RasterPoint> points;
  std::vector<std::size_t> pixels;
  render::Picture picture(raster.view().resolution());
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (hits[i].resultado == model::Resultado::hit) {
      points.push_back({polygons.at(hits[i].elementos.front()), hits[i].punto, queries[i].rayo.v().xyz()});
      pixels.push_back(i);
    } else {
      picture.rgb[i] = raster.background();
    }
  }
  std::vector<LightColors> lights = lights_by_rays(raster.scene().stage(), engine, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    lights[i][0] *= projector.color_on(points[i].point);
    picture.rgb[pixels[i]] = local_color(raster.scene().stage(), points[i], lights[i]);
  }
  return picture;
}

}  // namespace durero::raster
