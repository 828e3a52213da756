#pragma once
/// A depth map is the Z-buffer of a light: for each of its texels the distance of the nearest polygon (realism seed,
/// 1.3).

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <span>
#include <vector>

#include "durero/raster/scene_polygons.hpp"
#include "durero/raster/z_buffer.hpp"

namespace durero::raster {

/// The part that is taken off a distance before the test.
enum class DepthBias : std::uint8_t {
  none,  ///< nothing: the test as it is printed, oscura.def.1
  texel  ///< as much as the polygon's own plane comes nearer within the texel
};

/// A texel of the six pictures of a depth map.
struct DepthTexel {
  std::size_t face;  ///< in the order of environments: +x, −x, +y, −y, +z, −z
  glm::dvec2 place;  ///< in the face's picture, in texels; whole numbers are the middles of texels
  std::uint32_t x;   ///< from the left
  std::uint32_t y;   ///< from the top
};

/// The depths about a point light, on the six faces of a cube.
class DepthMap {
 public:
  /// Draws the polygons from the light, in pictures of size × size texels. Precondition: size is at least 1.
  DepthMap(std::span<const polygon::Polygon> polygons, const glm::dvec3& light, std::uint32_t size);

  /// The texel that a point lies in, as the light sees it. Precondition: the point is not the light.
  DepthTexel texel_of(const glm::dvec3& point) const;
  /// The distance that the map holds there; infinite where the light sees nothing.
  double depth(const DepthTexel& texel) const;
  /// Whether a point of a polygon is taken for shadowed: d < ‖q − y‖, with that bias.
  bool is_dark(const ScenePolygon& polygon, const glm::dvec3& point, DepthBias bias) const;
  /// The place, in the picture of a face, where a point is seen; nothing behind it.
  std::optional<glm::dvec2> place(std::size_t face, const glm::dvec3& point) const { return faces_[face].place(point); }

 private:
  double biased(const ScenePolygon& polygon, const glm::dvec3& point, const DepthTexel& texel) const;

  glm::dvec3 light_;
  std::vector<RasterView> faces_;
  std::vector<std::vector<double>> depths_;  // of each face, rows from the top
};

}  // namespace durero::raster
