#pragma once
/// A projector is a light that throws a picture: a texture that is projected from it (realism seed, 1.3).

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>

#include "durero/raster/z_buffer.hpp"
#include "durero/scene/camera.hpp"
#include "durero/scene/picture.hpp"

namespace durero::raster {

/// A light with a picture before it.
class Projector {
 public:
  /// The projector at the eye of a camera, whose picture it throws upright: fov_y is its height. Throws
  /// std::domain_error as scene::PrimaryRays does. Precondition: the picture has texels.
  Projector(const scene::Camera& camera, scene::TexelImage picture);

  /// The texel that is thrown on a point; nothing outside the picture.
  std::optional<scene::Pixel> texel_on(const glm::dvec3& point) const;
  /// Its colour; black outside the picture.
  glm::dvec3 color_on(const glm::dvec3& point) const;
  /// The predicted side of a texel on a wall that faces the projector and the eye: in pixels of a view, by the two
  /// distances.
  double predicted_pixels(const glm::dvec3& point, const scene::Camera& camera, scene::Resolution resolution) const;

 private:
  scene::Camera camera_;
  scene::TexelImage picture_;
  RasterView view_;
};

}  // namespace durero::raster
