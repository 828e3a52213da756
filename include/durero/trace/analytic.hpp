#pragma once
/// The first hit of a ray by closed forms, certified: Algorithm II.2 over all elements, with the answer of
/// surface::exact in the same bytes. Decisions go triage → stable → exact (counts.hpp).

#include <span>
#include <vector>

#include "durero/model/tipos.hpp"
#include "durero/scene/hit.hpp"
#include "durero/scene/scene.hpp"
#include "durero/trace/search.hpp"
#include "durero/trace/tables.hpp"

namespace durero::trace {

/// Primera_Interseccion. Precondition: the elements of en are in the scene. `counts`, where given, is added to.
scene::Hit first_hit(const Tables& tables, const model::Rayo& rayo, Origin en = {}, Counts* counts = nullptr);

/// occluded: the ray meets some element at some t > 0.
bool occluded(const Tables& tables, const model::Rayo& rayo, Origin en = {}, Counts* counts = nullptr);

/// occluded_segment: the ray meets some element at some 0 < t < 1.
bool occluded_segment(const Tables& tables, const model::Rayo& rayo, Origin en = {}, Counts* counts = nullptr);

/// first_hit of every query, in order, by eight in lanes (candidates.hpp): for more than a few rays the fastest way to
/// the same bytes. On as many threads as the calling one may use; the result does not depend on them. Precondition: a
/// place in `hits` for each query.
void first_hits(const Tables& tables, std::span<const scene::Query> queries, std::span<scene::Hit> hits,
                Counts* counts = nullptr);
/// The same, in a vector.
std::vector<scene::Hit> first_hits(const Tables& tables, std::span<const scene::Query> queries,
                                   Counts* counts = nullptr);

/// occluded_segment of every query, in order. Threads and precondition as above.
void occluded_segments(const Tables& tables, std::span<const scene::Query> queries, std::span<bool> occluded);

/// @{ The same without tables at hand, for a few rays.
scene::Hit first_hit(const scene::Scene& scene, const model::Rayo& rayo, Origin en = {});
bool occluded(const scene::Scene& scene, const model::Rayo& rayo, Origin en = {});
bool occluded_segment(const scene::Scene& scene, const model::Rayo& rayo, Origin en = {});
/// @}

}  // namespace durero::trace
