#pragma once
/// The first hit of a ray by closed forms: Algorithm II.2 over all elements. The answer is that of oracle::exact.

#include <span>
#include <vector>

#include "durero/model/tipos.hpp"
#include "durero/scene/hit.hpp"
#include "durero/scene/scene.hpp"

namespace durero::trace {

/// en?: the elements that the origin of a ray lies on.
using Origin = std::span<const scene::ElementRef>;

/// One line of a rays file: rayo? and en?.
struct Query {
  model::Rayo rayo;
  scene::ElementSet en{};
};

/// Primera_Interseccion. Precondition: the elements of en are in the scene.
scene::Hit first_hit(const scene::Scene& scene, const model::Rayo& rayo, Origin en = {});

/// occluded: the ray meets some element at some t > 0.
bool occluded(const scene::Scene& scene, const model::Rayo& rayo, Origin en = {});

/// occluded_segment: the ray meets some element at some 0 < t < 1.
bool occluded_segment(const scene::Scene& scene, const model::Rayo& rayo, Origin en = {});

/// first_hit of every query, in order. threads = 0 uses every core; the result does not depend on it.
std::vector<scene::Hit> first_hits(const scene::Scene& scene, std::span<const Query> queries, unsigned threads = 0);

}  // namespace durero::trace
