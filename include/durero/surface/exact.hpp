#pragma once
/// The first intersection by exact arithmetic. It is the answer that every engine must give, byte for byte.

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

}  // namespace durero::surface::exact
