#pragma once
/// A Z-buffer keeps for each pixel which of the polygons drawn so far is the nearest.

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "durero/polygon/convex.hpp"
#include "durero/raster/view_polygon.hpp"
#include "durero/scene/camera.hpp"
#include "durero/scene/stage.hpp"

namespace durero::raster {

/// A camera's view: the directions of its pixels, and the pixels of directions.
class RasterView {
 public:
  /// The view of a camera in a picture of that size. Throws std::domain_error as scene::PrimaryRays does.
  RasterView(const scene::Camera& camera, scene::Resolution resolution);

  /// The start of the rays.
  const glm::dvec3& eye() const { return eye_; }
  /// The size of the picture.
  scene::Resolution resolution() const { return rays_.resolution(); }
  /// The direction of the ray of a pixel.
  glm::dvec3 direction(std::uint32_t x, std::uint32_t y) const { return rays_.ray(x, y).v().xyz(); }
  /// The direction through a place of the picture; whole numbers are the middles of pixels.
  glm::dvec3 direction_at(const glm::dvec2& place) const { return rays_.ray_at(place.x, place.y).v().xyz(); }
  /// The place of the picture in which a point is seen, of the point's binary64 coordinates; nothing behind the eye.
  std::optional<glm::dvec2> place(const glm::dvec3& point) const;

  /// visit(x, y, direction) for each pixel whose ray meets the polygon, row by row.
  template <class Visit>
  void for_each_met(const polygon::Polygon& corners, const ViewPolygon& seen, const Visit& visit) const {
    if (seen.is_edge_on()) return;
    const PixelBox box = box_of(corners);
    for (std::uint32_t y = box.top; y < box.bottom; ++y)
      for (std::uint32_t x = box.left; x < box.right; ++x)
        if (const glm::dvec3 v = direction(x, y); seen.is_met(v)) visit(x, y, v);
  }

 private:
  struct PixelBox {
    std::uint32_t left, right, top, bottom;
  };
  bool is_behind(const std::vector<glm::dvec3>& corners) const;
  PixelBox box_of(const polygon::Polygon& polygon) const;

  scene::PrimaryRays rays_;
  glm::dvec3 eye_, first_, step_x_, step_y_;
};

/// The nearest polygon of each pixel.
struct ZBuffer {
  /// The number that stands for no polygon.
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  std::vector<ViewPolygon> seen;       ///< the polygons, as the eye sees them
  std::vector<std::uint32_t> nearest;  ///< the place of the polygon in the list, rows from the top, or none
};

/// Draws the polygons one after the other. Of two that a ray meets at one point the first of the list is kept.
ZBuffer z_buffer(std::span<const polygon::Polygon> polygons, const RasterView& view);

}  // namespace durero::raster
