#pragma once
/// OBTENERRAYO of Algorithm II.1: the ray from the eye through the centre of a pixel.

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "durero/model/tipos.hpp"
#include "durero/scene/stage.hpp"

namespace durero::scene {

/// The size of a picture whose stage names none.
inline constexpr Resolution default_resolution{640, 360};

/// A pixel of a picture; (0, 0) is the upper left one.
struct Pixel {
  std::uint32_t x;  ///< from the left
  std::uint32_t y;  ///< from the top
  bool operator==(const Pixel&) const = default;
};

/// The rays of a camera. Precondition: eye ≠ look_at, up not parallel to the view, 0 < fov_y < 180, and a
/// resolution of at least 1 × 1; throws std::domain_error, saying which, otherwise.
class PrimaryRays {
 public:
  /// The rays of that camera through the pixels of a picture of that size.
  PrimaryRays(const Camera& camera, Resolution resolution);

  /// The ray of pixel (x, y); (0, 0) is the upper left one. Its direction is not a unit vector: one unit of t is
  /// the distance from the eye to the window's plane.
  model::Rayo ray(std::uint32_t x, std::uint32_t y) const;

  /// The ray through a point of the window: x pixels to the right of the centre of pixel (0, 0) and y below it. At
  /// whole numbers it is that of the pixel.
  model::Rayo ray_at(double x, double y) const;

  /// The ray through that point of the window from a point of the lens, in the unit disc: rayo_de_lente.def.1 of
  /// spec/distribuida.tex, in binary64. It passes the plane in focus where ray_at(x, y) does. From the middle of the
  /// lens, and from every point of a pinhole, it is ray_at(x, y).
  model::Rayo lens_ray_at(double x, double y, const glm::dvec2& lens) const;

  /// Whether the lens has a size.
  bool has_lens() const noexcept { return lens_radius_ > 0; }

  /// The pixel whose ray has this origin and this direction, both of them exactly; nothing where none has.
  std::optional<Pixel> pixel_of(const glm::dvec3& p, const glm::dvec3& v) const;

  /// @{ The rays are eye + t·(upper_left + x·step_x + y·step_y), but for the rounding of the direction.
  const glm::dvec3& eye() const noexcept { return eye_; }
  const glm::dvec3& upper_left() const noexcept { return upper_left_; }
  const glm::dvec3& step_x() const noexcept { return step_x_; }
  const glm::dvec3& step_y() const noexcept { return step_y_; }
  /// @}

  /// Of the picture.
  Resolution resolution() const noexcept { return resolution_; }

 private:
  glm::dvec3 direction(double x, double y) const { return upper_left_ + step_x_ * x + step_y_ * y; }

  Resolution resolution_;
  glm::dvec3 eye_;
  glm::dvec3 upper_left_;  // from the eye to the centre of pixel (0, 0)
  glm::dvec3 step_x_;      // from a pixel to its right neighbour
  glm::dvec3 step_y_;      // from a pixel to the one below
  glm::dvec3 right_, up_;  // unit vectors
  double lens_radius_;
  double focus_;  // the distance of the plane in focus
};

}  // namespace durero::scene
