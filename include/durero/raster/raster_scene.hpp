#pragma once
/// A scene as a raster draws it: its polygons, and the nearest one of each pixel.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "durero/engine/engine.hpp"
#include "durero/raster/local_model.hpp"
#include "durero/raster/scene_polygons.hpp"
#include "durero/raster/z_buffer.hpp"
#include "durero/render/output/picture.hpp"
#include "durero/scene/scene.hpp"

namespace durero::raster {

/// The polygons of a scene that outlives it, drawn into a Z-buffer.
class RasterScene {
 public:
  /// Draws the opaque polygons. Throws std::domain_error as polygons_of() does, without a camera, with a lens, where
  /// something moves, where a light has an extent, and where an environment surrounds the scene.
  RasterScene(const scene::Scene& scene, scene::Resolution size, Opacity opacity);

  /// @{ The parts.
  const scene::Scene& scene() const { return *scene_; }
  const std::vector<ScenePolygon>& polygons() const { return polygons_; }
  const std::vector<polygon::Polygon>& corners() const { return corners_; }
  const RasterView& view() const { return view_; }
  /// @}
  /// The place in polygons() of the nearest opaque one of a pixel, by its number from the upper left; ZBuffer::none.
  std::uint32_t nearest(std::size_t pixel) const { return buffer_.nearest[pixel]; }
  /// A polygon, as the eye sees it. Precondition: it is opaque, or all are asked for.
  const ViewPolygon& seen(std::size_t polygon) const { return buffer_.seen[polygon]; }
  /// The point of a polygon that a pixel shows.
  RasterPoint point(std::size_t polygon, std::uint32_t x, std::uint32_t y) const;

  /// The picture in which bright(pixel, point) is what the lights are at a point.
  template <class Bright>
  render::Picture shaded(const Bright& bright) const {
    render::Picture picture(view_.resolution());
    std::size_t pixel = 0;
    for (std::uint32_t y = 0; y < picture.resolution.height; ++y)
      for (std::uint32_t x = 0; x < picture.resolution.width; ++x, ++pixel) {
        if (nearest(pixel) == ZBuffer::none) {
          picture.rgb[pixel] = background();
          continue;
        }
        const RasterPoint at = point(nearest(pixel), x, y);
        picture.rgb[pixel] = local_color(scene_->stage(), at, bright(pixel, at));
      }
    return picture;
  }
  /// The colour where no polygon is.
  glm::dvec3 background() const;

 private:
  const scene::Scene* scene_;
  std::vector<ScenePolygon> polygons_;
  std::vector<polygon::Polygon> corners_;
  RasterView view_;
  ZBuffer buffer_;
};

/// How bright the lights are at points, by shadow rays of an engine, which start on the points' polygons.
std::vector<LightColors> lights_by_rays(const scene::Stage& stage, const engine::Engine& engine,
                                        const std::vector<RasterPoint>& points);

}  // namespace durero::raster
