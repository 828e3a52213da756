#pragma once
/// A planar mirror acts as a second camera (realism seed, 1.5): it shows the view of the first camera mirrored in its
/// plane.

#include <glm/vec3.hpp>
#include <optional>

#include "durero/scene/camera.hpp"
#include "durero/scene/stage.hpp"

namespace durero::render {

/// The camera that a planar mirror makes of another, and its rays.
class SecondCamera {
 public:
  /// The second camera of a camera and picture, in the plane through `point` across `normal`. Precondition: `normal` is
  /// a unit vector. Throws std::domain_error as PrimaryRays does.
  SecondCamera(const scene::Camera& camera, scene::Resolution resolution, const glm::dvec3& point,
               const glm::dvec3& normal);

  /// The ray that pixel (x, y) of the first picture follows in the mirror: that of the second camera through the same
  /// pixel. It starts where it passes the plane, so that nothing behind the mirror is seen. Nothing where the pixel
  /// does not look at the plane.
  std::optional<model::Rayo> ray(std::uint32_t x, std::uint32_t y) const;

  /// The camera behind the mirror; its picture is turned left to right once more.
  const scene::Camera& camera() const noexcept { return camera_; }

 private:
  scene::Camera camera_;
  scene::PrimaryRays rays_;
  glm::dvec3 point_, normal_;
};

}  // namespace durero::render
