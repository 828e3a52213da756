#include "durero/raster/transparency.hpp"

#include <cstdint>
#include <stdexcept>

namespace durero::raster {
namespace {

/// The points that a polygon has at pixels, and the pixels.
struct PixelPoints {
  std::vector<RasterPoint> points;
  std::vector<std::size_t> pixels;
};

/// The points before which no opaque polygon lies.
PixelPoints seen_points(const RasterScene& raster, std::size_t polygon) {
  PixelPoints seen;
  raster.view().for_each_met(raster.corners()[polygon], raster.seen(polygon),
                             [&](std::uint32_t x, std::uint32_t y, const glm::dvec3& v) {
                               const std::size_t pixel = std::size_t(y) * raster.view().resolution().width + x;
                               const std::uint32_t nearest = raster.nearest(pixel);
                               if (nearest != ZBuffer::none && raster.seen(nearest).is_before(raster.seen(polygon), v))
                                 return;
                               seen.points.push_back(raster.point(polygon, x, y));
                               seen.pixels.push_back(pixel);
                             });
  return seen;
}

PixelPoints opaque_points(const RasterScene& raster) {
  PixelPoints opaque;
  const auto [width, height] = raster.view().resolution();
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::uint32_t x = 0; x < width; ++x) {
      const std::size_t pixel = std::size_t(y) * width + x;
      if (raster.nearest(pixel) == ZBuffer::none) continue;
      opaque.points.push_back(raster.point(raster.nearest(pixel), x, y));
      opaque.pixels.push_back(pixel);
    }
  return opaque;
}

}  // namespace

std::vector<std::size_t> far_to_near(const std::vector<polygon::Polygon>& polygons, const polygon::Apex& eye) {
  std::vector<std::vector<std::size_t>> hides(polygons.size());  // what each hides a part of
  for (std::size_t i = 0; i < polygons.size(); ++i)
    if (const auto body = polygon::hidden(eye, polygons[i]); !body.empty())
      for (std::size_t j = 0; j < polygons.size(); ++j)
        if (j != i && !polygon::clipped(polygons[j], body).empty()) hides[i].push_back(j);
  std::vector<std::size_t> order;
  std::vector<bool> is_drawn(polygons.size());
  const auto can_be_drawn = [&](std::size_t i) {
    if (is_drawn[i]) return false;
    for (const std::size_t behind : hides[i])
      if (!is_drawn[behind]) return false;
    return true;
  };
  while (order.size() < polygons.size()) {
    std::size_t next = 0;
    while (next < polygons.size() && !can_be_drawn(next)) ++next;
    if (next == polygons.size())
      throw std::domain_error("transparent polygons hide each other around; expected an order from far to near");
    is_drawn[next] = true;
    order.push_back(next);
  }
  return order;
}

std::vector<std::size_t> transparent_of(const RasterScene& raster) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < raster.polygons().size(); ++i)
    if (raster.polygons()[i].material.k_t > 0) places.push_back(i);
  return places;
}

render::Picture with_transparency(const RasterScene& raster, const engine::Engine& engine,
                                  const std::vector<std::size_t>& order) {
  render::Picture picture(raster.view().resolution());
  picture.rgb.assign(picture.rgb.size(), raster.background());
  const scene::Stage& stage = raster.scene().stage();
  const auto draw = [&](const PixelPoints& seen, const auto& over) {
    const std::vector<LightColors> lights = lights_by_rays(stage, engine, seen.points);
    for (std::size_t i = 0; i < seen.points.size(); ++i) {
      glm::dvec3& pixel = picture.rgb[seen.pixels[i]];
      pixel = local_color(stage, seen.points[i], lights[i]) + over(pixel);
    }
  };
  draw(opaque_points(raster), [](const glm::dvec3&) { return glm::dvec3(0); });
  for (const std::size_t polygon : order) {
    const scene::Material& m = raster.polygons()[polygon].material;
    draw(seen_points(raster, polygon), [&](const glm::dvec3& behind) { return m.k_t * m.M_T * behind; });
  }
  return picture;
}

}  // namespace durero::raster
