#pragma once
/// The surfaces of the elements of a scene, as the sampled oracle takes them: of an element of the tables one, of an
/// instance its copy, of a solid those of its leaves, so far as they may be on the solid's.

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "durero/oracle/cover.hpp"
#include "durero/scene/scene.hpp"
#include "placed_surface.hpp"
#include "sampled_solid.hpp"

namespace durero::oracle::sampled {

/// Refuses what is out of the range of the oracle. Throws std::domain_error.
[[noreturn]] void out_of_range(const std::string& what, double value, const std::string& expected);

/// One of them.
struct ElementSurface {
  scene::ElementRef ref;                      ///< whose it is
  PlacedSurface surface;                      ///< its points, and more where the element is a solid
  std::shared_ptr<const SampledSolid> solid;  ///< null where every point of it is one of the element
  std::size_t leaf;                           ///< of the solid
  CoverPlan outline;                          ///< what its samples take at most

  /// @{ Of the points of it within `reach` of one of its points: whether some may be on the element, and whether all
  /// are.
  bool may_have(const glm::dvec3& point, double reach) const { return !solid || solid->may_have(point, leaf, reach); }
  bool has_all(const glm::dvec3& point, double reach) const { return !solid || solid->has_all(point, leaf, reach); }
  /// @}
  /// Samples within δ of every point of it that is on the element. Of a solid it has those alone that have such a point
  /// within δ perhaps.
  Cover cover(double fineness) const;
};

/// All of a scene, element by element. Throws std::domain_error where a length or a coordinate is not one that the
/// oracle takes.
std::vector<ElementSurface> surfaces_of(const scene::Scene& scene, double fineness);

}  // namespace durero::oracle::sampled
