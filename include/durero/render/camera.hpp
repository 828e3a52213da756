#pragma once
/// OBTENERRAYO of Algorithm II.1: the ray from the eye through the centre of a pixel.

#include <cstdint>
#include <glm/vec3.hpp>

#include "durero/model/tipos.hpp"
#include "durero/scene/stage.hpp"

namespace durero::render {

/// The rays of a pinhole camera. Precondition: eye ≠ look_at, up not parallel to the view, 0 < fov_y < 180, and a
/// resolution of at least 1 × 1; throws std::domain_error, saying which, otherwise.
class PrimaryRays {
 public:
  /// The rays of that camera through the pixels of a picture of that size.
  PrimaryRays(const scene::Camera& camera, scene::Resolution resolution);

  /// The ray of pixel (x, y); (0, 0) is the upper left one. Its direction is not a unit vector: one unit of t is
  /// the distance from the eye to the window's plane.
  model::Rayo ray(std::uint32_t x, std::uint32_t y) const;

 private:
  glm::dvec3 eye_;
  glm::dvec3 upper_left_;  // from the eye to the centre of pixel (0, 0)
  glm::dvec3 step_x_;      // from a pixel to its right neighbour
  glm::dvec3 step_y_;      // from a pixel to the one below
};

}  // namespace durero::render
