#pragma once
/// Every crossing of a ray and the elements of a scene, exactly, bodies among them.

#include <cstdint>
#include <optional>
#include <vector>

#include "durero/scene/query.hpp"
#include "durero/scene/scene.hpp"
#include "durero/surface/exact_element.hpp"
#include "durero/trace/search.hpp"

namespace durero::web {

using surface::exact::Parameter;

/// A crossing of a ray and an element.
struct ElementCrossing {
  /// A point, a stretch inside the surface, or what is known of a stretch in a body: where it begins.
  enum class Kind : std::uint8_t { point, segment, along };
  scene::ElementRef element;       ///< the element
  Kind kind = Kind::point;         ///< whether `end` means something
  std::optional<Parameter> t{};    ///< where it begins; nothing at t → 0⁺
  std::optional<Parameter> end{};  ///< where a stretch ends; nothing where it does not
};

/// The step that decided about an element of the tables, and what it found.
struct ElementDecision {
  scene::ElementRef element;  ///< the element
  trace::Meeting met;         ///< the first point on it
};

/// The crossings, ascending (t → 0⁺ first, then by element), and the decisions about the elements of the tables.
struct Crossings {
  std::vector<ElementCrossing> all;        ///< of every element that the ray meets
  std::vector<ElementDecision> decisions;  ///< about every element without a body
};

/// Finds them.
Crossings crossings_of(const scene::Scene& scene, const scene::Query& query);

/// The order of where two crossings begin.
bool begins_before(const ElementCrossing& a, const ElementCrossing& b);

/// The unit normal of an element at a point, as shading sees it; of a body the null vector where there is none.
glm::dvec3 normal_of(const scene::Scene& scene, scene::ElementRef element, const glm::dvec3& point);

}  // namespace durero::web
