#pragma once
/// The distance of points from a scene, with the nearest point and the elements that attain it (mas_cercano.def.1).
/// Each number is the exact one, rounded once: bounds in binary64 leave few elements, of which exact arithmetic
/// decides.

#include <cstdint>
#include <optional>
#include <span>

#include "durero/accel/bvh.hpp"
#include "durero/scene/proximity.hpp"
#include "durero/scene/scene.hpp"

namespace durero::distance {

/// The work of an answer.
struct DistanceWork {
  std::uint64_t boxes = 0;   ///< boxes whose distance was computed
  std::uint64_t bounds = 0;  ///< elements whose distance was bounded in binary64
  std::uint64_t exact = 0;   ///< elements whose distance was computed exactly
};

/// Distances from a scene, which must outlive it unedited. Many threads may ask it.
class Distances {
 public:
  /// Builds a tree of boxes about the elements.
  explicit Distances(const scene::Scene& scene) : tree_(scene) {}

  /// The nearest of the scene to a point. Precondition: its coordinates are finite. Adds to `work`.
  scene::Proximity nearest(const glm::dvec3& p, DistanceWork& work) const;
  /// The nearest to each of many points, whatever the number of threads. Precondition: as many answers as points.
  void nearest(std::span<const glm::dvec3> points, std::span<scene::Proximity> answers) const;

 private:
  accel::Bvh tree_;
};

/// The nearest of one element alone to a point, with the same preconditions.
scene::Proximity nearest_of(const scene::Scene& scene, scene::ElementRef element, const glm::dvec3& p);

/// The distance from one element with its sign, rounded once; nothing where the element is open (con_signo.def.1).
/// Preconditions: the element is of the scene, and the point finite.
std::optional<double> signed_distance(const scene::Scene& scene, scene::ElementRef element, const glm::dvec3& p);

}  // namespace durero::distance
