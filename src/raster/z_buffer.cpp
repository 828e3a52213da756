#include "durero/raster/z_buffer.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "durero/raster/scene_polygons.hpp"

namespace durero::raster {

RasterView::RasterView(const scene::Camera& camera, scene::Resolution resolution)
    : rays_(camera, resolution),
      eye_(camera.eye),
      first_(direction_at({0, 0})),
      step_x_(direction_at({1, 0}) - first_),
      step_y_(direction_at({0, 1}) - first_) {}

std::optional<glm::dvec2> RasterView::place(const glm::dvec3& point) const {
  const glm::dvec3 across = glm::cross(step_x_, step_y_), to = point - eye_;
  const double far = glm::dot(to, across) / glm::dot(first_, across);
  if (!(far > 0)) return std::nullopt;
  const glm::dvec3 within = to / far - first_;
  return glm::dvec2(glm::dot(within, step_x_) / glm::dot(step_x_, step_x_),
                    glm::dot(within, step_y_) / glm::dot(step_y_, step_y_));
}

// A point of a ray lies as far before the eye as its parameter says. Behind it by more than a millionth of its distance
// from the eye, a corner is there for certain; where all are, so is the polygon.
bool RasterView::is_behind(const std::vector<glm::dvec3>& corners) const {
  const glm::dvec3 forward = glm::normalize(glm::cross(step_x_, step_y_));
  const double side = glm::dot(forward, first_) < 0 ? -1 : 1;
  return std::ranges::all_of(corners, [&](const glm::dvec3& corner) {
    const glm::dvec3 to = corner - eye_;
    return side * glm::dot(forward, to) < -1e-6 * glm::length(to);
  });
}

// One pixel more on every side than the corners ask for, as places are rounded; all where some corner has none.
RasterView::PixelBox RasterView::box_of(const polygon::Polygon& polygon) const {
  std::vector<glm::dvec3> corners;
  for (const polygon::RationalPoint& corner : polygon) corners.push_back(rounded(corner));
  if (is_behind(corners)) return {0, 0, 0, 0};
  const auto [width, height] = resolution();
  glm::dvec2 least(width, height), greatest(-1, -1);
  for (const glm::dvec3& corner : corners) {
    const auto at = place(corner);
    if (!at || !std::isfinite(at->x + at->y)) return {0, width, 0, height};
    least = glm::min(least, *at);
    greatest = glm::max(greatest, *at);
  }
  const auto pixel = [](double place, std::uint32_t most) {
    return static_cast<std::uint32_t>(std::clamp(place, 0.0, double(most)));
  };
  return {pixel(std::floor(least.x) - 1, width), pixel(std::ceil(greatest.x) + 2, width),
          pixel(std::floor(least.y) - 1, height), pixel(std::ceil(greatest.y) + 2, height)};
}

ZBuffer z_buffer(std::span<const polygon::Polygon> polygons, const RasterView& view) {
  const auto [width, height] = view.resolution();
  ZBuffer drawn{{}, std::vector<std::uint32_t>(std::size_t(width) * height, ZBuffer::none)};
  for (const polygon::Polygon& corners : polygons) drawn.seen.emplace_back(corners, view.eye());
  for (std::uint32_t i = 0; i < polygons.size(); ++i)
    view.for_each_met(polygons[i], drawn.seen[i], [&](std::uint32_t x, std::uint32_t y, const glm::dvec3& v) {
      std::uint32_t& held = drawn.nearest[std::size_t(y) * width + x];
      if (held == ZBuffer::none || drawn.seen[i].is_before(drawn.seen[held], v)) held = i;
    });
  return drawn;
}

}  // namespace durero::raster
