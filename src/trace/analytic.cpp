#include "durero/trace/analytic.hpp"

#include <algorithm>
#include <array>

namespace durero::trace {
namespace {

using Range = Search::Range;

/// visit(element, range) for every element of the scene until it answers true. Whether it did.
template <class Visit>
bool any_element(const scene::Scene& scene, Visit visit) {
  return scene.any_of([&](scene::ElementRef e, const auto&) { return visit(e, Range::unknown); });
}

/// visit(element, range) for every element that the ray may meet at t ≤ limit(), until it answers true. The filter
/// knows only the points of the element itself, so the elements that the ray starts on pass by it.
template <class Limit, class Visit>
bool any_candidate(const Tables& tables, const Beam& beam, Origin en, Limit limit, Visit visit) {
  if (!beam.ordinary) return any_element(tables.scene(), visit);
  if (std::any_of(en.begin(), en.end(), [&](scene::ElementRef e) { return visit(e, Range::unknown); })) return true;
  const auto visit_other = [&](scene::ElementRef e, Range range) { return !en.contains(e) && visit(e, range); };
  const auto elements = tables.elements();
  std::array<std::uint32_t, 32 * Balls::block> passed;
  for (std::size_t begin = 0; begin < elements.size(); begin += passed.size()) {
    const std::size_t end = std::min(begin + passed.size(), elements.size());
    const std::size_t count = filter(tables.balls(), beam, limit(), begin, end, passed.data());
    for (std::size_t i = 0; i < count; ++i) {
      if (visit_other(elements[passed[i]], Range::ordinary)) return true;
    }
  }
  const auto rest = tables.extraordinary();
  return std::any_of(rest.begin(), rest.end(), [&](scene::ElementRef e) { return visit_other(e, Range::unknown); });
}

template <class ForEach>
scene::Hit nearest(Search& search, ForEach for_each) {
  for_each([&](scene::ElementRef e, Range range) {
    search.test(e, range);
    return false;
  });
  return search.finish();
}

/// The ray meets the element at some 0 < t < 1. Near 1 the exact parameter decides.
bool blocks_segment(const Search& search, const scene::Scene& scene, const model::Rayo& rayo, Origin en,
                    scene::ElementRef e, Range range) {
  const Meeting met = search.meeting(e, 1, range);
  if (met.kind != Meeting::Kind::point) return met.kind == Meeting::Kind::no_minimum;
  if (met.high < 1) return true;
  if (met.low > 1) return false;
  const auto reach = surface::exact::reach(scene, e, rayo, en);
  return surface::exact::order(reach.first(), surface::exact::Parameter{.x = 1}) < 0;
}

bool blocks(const Search& search, scene::ElementRef e, Range range) {
  return search.meeting(e, no_limit, range).kind != Meeting::Kind::none;
}

}  // namespace

scene::Hit first_hit(const Tables& tables, const model::Rayo& rayo, Origin en, Counts* counts) {
  Counts unseen;
  Search search(tables.scene(), rayo, en, counts ? *counts : unseen);
  return nearest(search, [&](auto visit) {
    any_candidate(
        tables, search.beam(), en, [&] { return search.limit(); }, visit);
  });
}

bool occluded(const Tables& tables, const model::Rayo& rayo, Origin en, Counts* counts) {
  Counts unseen;
  const Search search(tables.scene(), rayo, en, counts ? *counts : unseen);
  return any_candidate(
      tables, search.beam(), en, [] { return no_limit; },
      [&](scene::ElementRef e, Range range) { return blocks(search, e, range); });
}

bool occluded_segment(const Tables& tables, const model::Rayo& rayo, Origin en, Counts* counts) {
  Counts unseen;
  const Search search(tables.scene(), rayo, en, counts ? *counts : unseen);
  return any_candidate(
      tables, search.beam(), en, [] { return 1.0; },
      [&](scene::ElementRef e, Range range) { return blocks_segment(search, tables.scene(), rayo, en, e, range); });
}

scene::Hit first_hit(const scene::Scene& scene, const model::Rayo& rayo, Origin en) {
  Counts unseen;
  Search search(scene, rayo, en, unseen);
  return nearest(search, [&](auto visit) { any_element(scene, visit); });
}

bool occluded(const scene::Scene& scene, const model::Rayo& rayo, Origin en) {
  Counts unseen;
  const Search search(scene, rayo, en, unseen);
  return any_element(scene, [&](scene::ElementRef e, Range range) { return blocks(search, e, range); });
}

bool occluded_segment(const scene::Scene& scene, const model::Rayo& rayo, Origin en) {
  Counts unseen;
  const Search search(scene, rayo, en, unseen);
  return any_element(
      scene, [&](scene::ElementRef e, Range range) { return blocks_segment(search, scene, rayo, en, e, range); });
}

}  // namespace durero::trace
