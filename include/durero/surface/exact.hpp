#pragma once
/// The first intersection by exact arithmetic. It is the answer that every engine must give, byte for byte.

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "durero/scene/hit.hpp"
#include "durero/scene/query.hpp"
#include "durero/scene/scene.hpp"
#include "durero/surface/exact_element.hpp"

namespace durero::surface::exact {

using scene::Origin;

/// alcance of one element. Precondition: the element, and the elements of en, are in the scene.
Reach reach(const scene::Scene& scene, scene::ElementRef element, const model::Rayo& rayo, Origin en = {});

/// The hit at a parameter t > 0, with t and each coordinate rounded once.
scene::Hit rounded_hit(const model::Rayo& rayo, const Parameter& t, scene::ElementSet elementos);

/// Primera_Interseccion. Precondition: the elements of en are in the scene.
scene::Hit first_hit(const scene::Scene& scene, const model::Rayo& rayo, Origin en = {});

/// occluded: whether alcances ≠ ∅. Precondition: that of first_hit.
bool occluded(const scene::Scene& scene, const model::Rayo& rayo, Origin en = {});

/// occluded_segment: whether alcances has a point at some 0 < t < 1. Precondition: that of first_hit.
bool occluded_segment(const scene::Scene& scene, const model::Rayo& rayo, Origin en = {});

/// A crossing of the ray and an element: a point, at segment.begin = segment.end, or a stretch inside the surface.
struct Crossing {
  scene::ElementRef elemento;  ///< the element
  Segment segment;             ///< the parameters
};

/// alcances, whole: every crossing, ascending by begin (t → 0⁺ first), then by element. Precondition: that of
/// first_hit.
std::vector<Crossing> all_hits(const scene::Scene& scene, const model::Rayo& rayo, Origin en = {});

/// A point of an element.
struct ElementPoint {
  scene::ElementRef element;  ///< the element
  glm::dvec3 point;           ///< the point, rounded once
  bool operator==(const ElementPoint&) const = default;
};

/// A question whether an element may let light through.
using Passes = std::function<bool(scene::ElementRef)>;

/// The points of elements that the ray meets on a stretch: by the name of the element, then ascending along the ray.
/// Nothing where the ray runs along one of them there. Precondition: that of first_hit.
std::optional<std::vector<ElementPoint>> points_of(const scene::Scene& scene, scene::ElementSet elements,
                                                   const model::Rayo& rayo, Origin en, RayStretch stretch);

/// enumerado of ante or ante_lejos: points_of all elements that the ray meets on the stretch. Nothing where one of them
/// does not pass light, or the ray runs along it there. Precondition: that of first_hit.
std::optional<std::vector<ElementPoint>> points_between(const scene::Scene& scene, const model::Rayo& rayo, Origin en,
                                                        RayStretch stretch, const Passes& passes);

}  // namespace durero::surface::exact
