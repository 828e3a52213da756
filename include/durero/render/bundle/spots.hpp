#pragma once
/// Spots are where pencils of light arrive on surfaces: each spreads a flux about a point.

#include <cstdint>
#include <glm/mat2x2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <unordered_map>
#include <vector>

#include "durero/scene/element_ref.hpp"

namespace durero::render {

/// A spot of light on an element: a normal distribution in the tangent plane.
struct LightSpot {
  scene::ElementRef element;  ///< what it lies on
  glm::dvec3 centre;          ///< its middle
  glm::dvec3 first, second;   ///< two unit vectors at right angles, along the surface
  glm::dmat2 inverse;         ///< of its covariance in these directions
  glm::dvec3 peak;            ///< the flux for each unit of area in the middle
  double reach;               ///< beyond it the density is below 1/400 of the peak, and counts as 0
};

/// The spot whose sides are the images of the sides of a pencil's cell, blurred by a length: the spots of neighbours
/// overlap and add up to an even light within 1 %. Precondition: n is the unit normal there, and blur > 0.
LightSpot spot_of(scene::ElementRef element, const glm::dvec3& centre, const glm::dvec3& n, const glm::dvec3& side,
                  const glm::dvec3& other, double blur, const glm::dvec3& flux);

/// A spot's density at a point.
glm::dvec3 density(const LightSpot& spot, const glm::dvec3& point);

/// Spots that are found by a point: in levels of cubes, each spot in the level whose cubes are as large as its reach.
class Spots {
 public:
  /// Adds a spot.
  void add(const LightSpot& spot);
  /// The sum of the densities at a point of an element.
  glm::dvec3 density(scene::ElementRef element, const glm::dvec3& point) const;
  /// All of them, in the order of their addition.
  std::span<const LightSpot> all() const noexcept { return spots_; }

 private:
  struct Cube {
    int level;
    std::int64_t x, y, z;
    bool operator==(const Cube&) const = default;
  };
  struct Hash {
    std::size_t operator()(const Cube& cube) const noexcept;
  };
  static Cube cube_of(int level, const glm::dvec3& point);

  std::vector<LightSpot> spots_;
  std::vector<int> levels_;  // ascending, those that have a spot
  std::unordered_map<Cube, std::vector<std::uint32_t>, Hash> cubes_;
};

}  // namespace durero::render
