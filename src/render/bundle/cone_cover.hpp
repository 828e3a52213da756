#pragma once
/// The parts of a cone, by the elements that are seen through it.

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "durero/render/bundle/cone.hpp"
#include "durero/scene/scene.hpp"

namespace durero::render {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// A sphere, a plane or a triangle, in the numbers that cones ask of it.
class ConeTarget {
 public:
  ConeTarget(scene::ElementRef element, const scene::Sphere& sphere) : element_(element), shape_(sphere) {}
  ConeTarget(scene::ElementRef element, const scene::Plane& plane) : element_(element), shape_(plane) {}
  ConeTarget(scene::ElementRef element, const scene::Triangle& triangle) : element_(element), shape_(triangle) {}

  scene::ElementRef element() const noexcept { return element_; }

  /// The share of a cone that it covers, in closed form.
  double share(const RayCone& cone) const;
  /// A direction of the part that it covers, as x and y of the cone's frame. Precondition: the share is not 0.
  glm::dvec2 middle(const RayCone& cone) const;
  /// The stretch of x in which the directions (x, y) meet it; nothing where none does.
  std::optional<std::array<double, 2>> stretch(const RayCone& cone, double y) const;
  /// The first parameter above `start` at which a ray meets its unbounded surface; infinite where none is.
  double parameter(const glm::dvec3& from, const glm::dvec3& direction, double start) const;

 private:
  scene::ElementRef element_;
  std::variant<scene::Sphere, scene::Plane, scene::Triangle> shape_;
};

/// A part of a cone.
struct ConePart {
  const ConeTarget* target;  ///< what is seen there; null where nothing is
  double share;              ///< of the cone
  glm::dvec2 at;             ///< a direction for the part, in the cone's frame: its middle
  double t;                  ///< the parameter of the element in that direction
};

/// The parts of a cone; their shares add up to 1. Where at most one element covers a part of it, before something that
/// covers all or nothing, the shares are closed forms. Elsewhere the cone is cut into flat fans: in each, the
/// directions that meet an element are a stretch, exactly, and the nearest on each piece is taken. `origins` are the
/// elements that the cone starts on, which it does not see; what begins beyond `end` is not seen either.
std::vector<ConePart> parts_of(const RayCone& cone, std::span<const ConeTarget> targets,
                               const scene::ElementSet& origins, double end = infinity);

}  // namespace durero::render
