#include "durero/raster/vector_drawing.hpp"

#include <fmt/format.h>

#include <iterator>
#include <utility>

#include "durero/raster/shadow_polygons.hpp"
#include "durero/raster/visible_polygons.hpp"
#include "durero/scene/srgb.hpp"

namespace durero::raster {
namespace {

using polygon::Polygon;

/// A part of a polygon, and the lights that are seen in it.
struct SeenPart {
  Polygon corners;
  std::vector<bool> lit;
};

/// The pyramid from the eye through the edges of the picture.
std::vector<polygon::PlaneSide> pyramid_of(const RasterView& view) {
  const double right = view.resolution().width - 0.5, bottom = view.resolution().height - 0.5;
  Polygon window;
  for (const glm::dvec2 place :
       {glm::dvec2(-0.5, -0.5), glm::dvec2(right, -0.5), glm::dvec2(right, bottom), glm::dvec2(-0.5, bottom)})
    window.push_back(polygon::exact(view.eye()) + polygon::exact(view.direction_at(place)));
  return polygon::pyramid({polygon::exact(view.eye())}, window);
}

/// Parts each of them by what a light sees of their polygon.
std::vector<SeenPart> parted(const std::vector<SeenPart>& parts, const std::vector<Polygon>& lit,
                             const polygon::Apex& across) {
  std::vector<SeenPart> all;
  const auto add = [&](Polygon corners, const SeenPart& of, bool is_lit) {
    all.push_back({std::move(corners), of.lit});
    all.back().lit.push_back(is_lit);
  };
  for (const SeenPart& part : parts) {
    std::vector<Polygon> dark{part.corners};
    for (const Polygon& one : lit) {
      const auto body = polygon::pyramid(across, one);
      Polygon common = polygon::clipped(part.corners, body);
      if (common.empty()) continue;
      add(std::move(common), part, true);
      std::vector<Polygon> left;
      for (const Polygon& rest : dark) std::ranges::move(polygon::without(rest, body), std::back_inserter(left));
      dark = std::move(left);
    }
    for (Polygon& rest : dark) add(std::move(rest), part, false);
  }
  return all;
}

glm::dvec3 middle_of(const Polygon& corners) {
  glm::dvec3 sum(0);
  for (const polygon::RationalPoint& corner : corners) sum += rounded(corner);
  return sum / double(corners.size());
}

std::string area(const RasterScene& raster, std::size_t polygon, const SeenPart& part) {
  const scene::Stage& stage = raster.scene().stage();
  LightColors lights = colors_of(stage);
  for (std::size_t i = 0; i < lights.size(); ++i)
    if (!part.lit[i]) lights[i] = glm::dvec3(0);
  const glm::dvec3 middle = middle_of(raster.corners()[polygon]);
  const RasterPoint at{&raster.polygons()[polygon], middle, middle - raster.view().eye()};
  std::string points;
  for (const polygon::RationalPoint& corner : part.corners)
    if (const auto place = raster.view().place(rounded(corner)))
      points += fmt::format("{}{:.3f},{:.3f}", points.empty() ? "" : " ", place->x + 0.5, place->y + 0.5);
  return fmt::format("<polygon fill=\"{}\" points=\"{}\"/>\n", scene::srgb_text(local_color(stage, at, lights)),
                     points);
}

}  // namespace

std::vector<LitParts> lit_by_shadows(const RasterScene& raster) {
  std::vector<LitParts> lit;
  for (const polygon::Apex& light : apexes_of(raster.scene().stage())) {
    const ShadowPolygons shadows = shadow_polygons(raster.corners(), light);
    lit.emplace_back();
    for (std::size_t i = 0; i < raster.corners().size(); ++i)
      lit.back().push_back(lit_parts(shadows, raster.corners(), i));
  }
  return lit;
}

std::vector<LitParts> lit_by_visibility(const RasterScene& raster) {
  std::vector<LitParts> lit;
  for (const polygon::Apex& light : apexes_of(raster.scene().stage()))
    lit.push_back(visible_polygons(raster.corners(), light).parts);
  return lit;
}

std::string svg(const RasterScene& raster, const std::vector<LitParts>& lit) {
  const auto [width, height] = raster.view().resolution();
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
      "shape-rendering=\"crispEdges\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"{2}\"/>\n",
      width, height, scene::srgb_text(raster.background()));
  const VisiblePolygons visible = visible_polygons(raster.corners(), {polygon::exact(raster.view().eye())});
  const auto window = pyramid_of(raster.view());
  for (std::size_t i = 0; i < visible.parts.size(); ++i) {
    std::vector<SeenPart> parts;
    for (const Polygon& seen : visible.parts[i])
      if (Polygon within = polygon::clipped(seen, window); !within.empty()) parts.push_back({std::move(within), {}});
    for (const LitParts& of_light : lit)
      parts = parted(parts, of_light[i], {polygon::doubled_area(raster.corners()[i]), true});
    for (const SeenPart& part : parts) text += area(raster, i, part);
  }
  return text + "</svg>\n";
}

}  // namespace durero::raster
