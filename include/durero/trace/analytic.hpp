#pragma once
/// Algorithm II.2 over all elements of a scene, certified: the first hit of a ray by closed forms, with the bytes of
/// surface::exact. The steps triage, stable and exact decide in this order (counts.hpp).

#include <span>
#include <vector>

#include "durero/model/tipos.hpp"
#include "durero/scene/hit.hpp"
#include "durero/scene/scene.hpp"
#include "durero/trace/search.hpp"
#include "durero/trace/tables.hpp"

namespace durero::trace {

/// Primera_Interseccion. `counts`, where given, is added to. Precondition: the elements of en are in the scene.
scene::Hit first_hit(const Tables& tables, const model::Rayo& rayo, Origin en = {}, Counts* counts = nullptr);

/// occluded: whether the ray meets some element at some t > 0.
bool occluded(const Tables& tables, const model::Rayo& rayo, Origin en = {}, Counts* counts = nullptr);

/// occluded_segment: whether the ray meets some element at some 0 < t < 1.
bool occluded_segment(const Tables& tables, const model::Rayo& rayo, Origin en = {}, Counts* counts = nullptr);

/// first_hit of every query, in order, batched in lanes (candidates.hpp): for more than a few rays the fastest way to
/// the same bytes. It runs on as many threads as the calling thread may use; the result does not depend on their
/// number. Preconditions: `hits` has a place for each query; the elements of every en are in the scene.
void first_hits(const Tables& tables, std::span<const scene::Query> queries, std::span<scene::Hit> hits,
                Counts* counts = nullptr);
/// first_hits into a new vector.
std::vector<scene::Hit> first_hits(const Tables& tables, std::span<const scene::Query> queries,
                                   Counts* counts = nullptr);

/// occluded_segment of every query, in order. Threads and preconditions are those of first_hits.
void occluded_segments(const Tables& tables, std::span<const scene::Query> queries, std::span<bool> occluded);

/// @{ The same functions without tables, for a few rays.
scene::Hit first_hit(const scene::Scene& scene, const model::Rayo& rayo, Origin en = {});
bool occluded(const scene::Scene& scene, const model::Rayo& rayo, Origin en = {});
bool occluded_segment(const scene::Scene& scene, const model::Rayo& rayo, Origin en = {});
/// @}

}  // namespace durero::trace
