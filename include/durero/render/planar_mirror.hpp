#pragma once
/// A planar mirror as a second camera (realism seed, 1.5): what is seen in it is what a camera behind it would see,
/// which is the first one mirrored in its plane.

#include <glm/vec3.hpp>
#include <optional>

#include "durero/scene/camera.hpp"

namespace durero::render {

/// The rays of the camera that a plane makes of another.
class SecondCamera {
 public:
  /// Of that camera and picture, in the plane through `point` across `normal`. Precondition: `normal` is a unit vector;
  /// throws std::domain_error as PrimaryRays does.
  SecondCamera(const scene::Camera& camera, scene::Resolution resolution, const glm::dvec3& point,
               const glm::dvec3& normal);

  /// What pixel (x, y) of the first picture sees in the mirror: the ray of the second camera through its pixel in the
  /// same row, as far from the other edge, from where it passes the plane on, so that what lies behind the mirror is no
  /// part of it. Nothing where the pixel does not look at the plane.
  std::optional<model::Rayo> ray(std::uint32_t x, std::uint32_t y) const;

  /// The camera behind the mirror; its picture is turned left to right, as it keeps right-handed.
  const scene::Camera& camera() const noexcept { return camera_; }

 private:
  scene::Camera camera_;
  scene::PrimaryRays rays_;
  glm::dvec3 point_, normal_;
};

}  // namespace durero::render
