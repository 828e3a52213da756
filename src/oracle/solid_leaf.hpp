#pragma once
/// A leaf of a solid: its surface as points, and how far a point is inside or outside of it.

#include <glm/vec3.hpp>
#include <variant>
#include <vector>

#include "durero/scene/body.hpp"
#include "placed_surface.hpp"

namespace durero::oracle {

/// A sphere, or what a profile turned around an axis encloses, where a map has put it; or what lies behind a plane.
class SolidLeaf {
 public:
  /// A plane and what lies behind it.
  struct HalfSpace {
    glm::dvec3 point;   ///< one of the plane
    glm::dvec3 normal;  ///< of length 1
  };
  /// A ball that holds the surface.
  struct Extent {
    glm::dvec3 center;  ///< a point of space
    double radius;      ///< a length
  };

  /// Throws std::logic_error of a disc and of a triangle, which bound nothing.
  explicit SolidLeaf(const scene::Instance& instance);

  /// Negative inside, positive outside, and in magnitude no more than the distance from the surface.
  double margin(const glm::dvec3& w) const;
  /// The surface in pieces, which meet in their rims. Of a plane it is a patch, whose points are no farther than the
  /// radius of the extent from the foot of its centre.
  std::vector<PlacedSurface> surfaces(const Extent& seen) const;
  /// Null of a leaf that ends.
  const HalfSpace* plane() const noexcept { return std::get_if<HalfSpace>(&inside_); }
  /// A ball that holds the surface; of a plane the point that it was given by.
  Extent extent() const;

 private:
  struct Ball {
    glm::dvec3 center;
    double radius;
  };
  struct Turned {
    glm::dvec3 center, axis;
    double first_radius, last_radius, height;  // the profile, from (first_radius, 0) to (last_radius, height)
  };
  struct InsideOf;

  /// The surface of a shape, without lids, before it is put anywhere.
  Parametrisation side() const;
  double margin_of(const Ball& ball, const glm::dvec3& w) const;
  double margin_of(const Turned& turned, const glm::dvec3& w) const;
  double margin_of(const HalfSpace& half, const glm::dvec3& w) const;
  void add_lids(std::vector<PlacedSurface>& surfaces, const Turned& turned) const;

  scene::AnyShape shape_;
  Placement by_;
  std::variant<Ball, Turned, HalfSpace> inside_;
};

}  // namespace durero::oracle
