#pragma once
/// The search of one ray over given steps: function by function the model of proofs/Search.v, and for a shadow ray that
/// of proofs/Occlusion.v. search.cpp gives it the steps of the program, tests give it tables of answers.
///
/// Steps has these functions, where `element` is the argument that visit gives to its function, and `on` is whether the
/// ray starts on the element:
///   on(e), visit(e, use)          for an ElementRef;
///   order_of_numbers(e, f)        an order of two elements; equal where both have the same numbers, and the ray starts
///                                 on both or on neither;
///   in_range(element, range)      whether floating point may be asked;
///   triage(element, on, limit), stable(element, on, limit), improved(element, on, finding)
///                                 the steps of triage.hpp and steps.hpp;
///   reach(element, on), order(t, u)
///                                 the exact step;
///   ends(step, finding), ends(t)  bounds of the parameter;
///   ahead(f, g), certainly_less(f, g)
///                                 for two findings by stable: whether f is tried first, and whether it is nearer;
///   rounded(element, finding), rounded(t)
///                                 t and the point, rounded once.

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <compare>
#include <cstdint>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "durero/trace/search.hpp"

namespace durero::trace {

using surface::exact::Parameter;

template <class Steps>
Meeting point_of(const Steps& steps, Step step, const RootEstimate& found) {
  const auto [low, high] = steps.ends(step, found);
  return {Meeting::Kind::point, step, low, high, found};
}

template <class Steps>
Meeting exact_meeting(const Steps& steps, const surface::exact::Reach& reach) {
  if (reach.empty()) return {.step = Step::exact};
  if (reach.no_minimum()) return {.kind = Meeting::Kind::no_minimum, .step = Step::exact};
  const auto [low, high] = steps.ends(reach.first());
  return {.kind = Meeting::Kind::point,
          .step = Step::exact,
          .low = low,
          .high = high,
          .t = std::make_shared<const Parameter>(reach.first())};
}

template <class Steps>
surface::exact::Reach reach_of(const Steps& steps, scene::ElementRef e) {
  return steps.visit(e, [&](const auto& element) { return steps.reach(element, steps.on(e)); });
}

/// Precondition: the element is in range.
template <class Steps, class Element>
std::optional<Meeting> certified_meeting_of(const Steps& steps, const Element& element, bool on, double limit) {
  const RootEstimate first = steps.triage(element, on, limit);
  if (first.verdict == Decision::miss) return Meeting{};
  if (first.verdict == Decision::hit) return point_of(steps, Step::triage, first);
  const RootEstimate second = steps.stable(element, on, limit);
  if (second.verdict == Decision::miss) return Meeting{.step = Step::stable};
  if (second.verdict == Decision::hit) return point_of(steps, Step::stable, second);
  return std::nullopt;
}

template <class Steps>
Meeting meeting_of(const Steps& steps, scene::ElementRef e, double limit, Search::Range range, Counts& counts) {
  const bool on = steps.on(e);
  Meeting met = steps.visit(e, [&](const auto& element) {
    if (steps.in_range(element, range)) {
      if (auto certified = certified_meeting_of(steps, element, on, limit)) return *std::move(certified);
    }
    return exact_meeting(steps, steps.reach(element, on));
  });
  ++counts.element[static_cast<std::size_t>(met.step)];
  return met;
}

template <class Steps>
bool blocks(const Steps& steps, scene::ElementRef e, Search::Range range, Counts& counts) {
  return meeting_of(steps, e, no_limit, range, counts).kind != Meeting::Kind::none;
}

/// Whether the ray meets the element at some 0 < t < 1. The exact parameter decides near 1.
template <class Steps>
bool blocks_segment(const Steps& steps, scene::ElementRef e, Search::Range range, Counts& counts) {
  const Meeting met = meeting_of(steps, e, 1, range, counts);
  if (met.kind != Meeting::Kind::point) return met.kind == Meeting::Kind::no_minimum;
  if (met.high < 1) return true;
  if (met.low > 1) return false;
  return steps.order(reach_of(steps, e).first(), Parameter{.x = 1}) < 0;
}

inline void drop_beyond_limit(SearchState& found) {
  const auto beyond = [&](const Candidate& c) { return c.at.low > found.limit; };
  const auto kept = std::remove_if(found.candidates.begin(), found.candidates.end(), beyond);
  found.candidates.erase(kept, found.candidates.end());
}

template <class Steps>
void take(const Steps& steps, SearchState& found, scene::ElementRef e, Search::Range range, Counts& counts) {
  Meeting met = meeting_of(steps, e, found.limit, range, counts);
  if (met.kind == Meeting::Kind::none || met.low > found.limit) return;
  if (met.kind == Meeting::Kind::no_minimum) {
    found.without_minimum.push_back(e);
    return;
  }
  const bool nearer = met.high < found.limit;
  if (nearer) found.limit = met.high;
  found.candidates.push_back({e, std::move(met)});
  if (nearer) drop_beyond_limit(found);  // the other candidates lay within the old limit
}

template <class Steps>
void refine(const Steps& steps, Candidate& candidate) {
  if (candidate.at.step != Step::triage) return;
  const bool on = steps.on(candidate.e);
  const RootEstimate found =
      steps.visit(candidate.e, [&](const auto& element) { return steps.stable(element, on, no_limit); });
  if (found.verdict == Decision::hit) candidate.at = point_of(steps, Step::stable, found);
}

template <class Steps>
void make_exact(const Steps& steps, Candidate& candidate) {
  if (!candidate.at.t) candidate.at = exact_meeting(steps, reach_of(steps, candidate.e));
}

/// Keeps the candidates that are not farther than the least one by `first`.
template <class First, class Farther>
void keep_not_farther(SearchState& found, First first, Farther farther) {
  const Meeting least = std::min_element(found.candidates.begin(), found.candidates.end(), first)->at;
  const auto dropped = [&](const Candidate& c) { return farther(least, c.at); };
  const auto kept = std::remove_if(found.candidates.begin(), found.candidates.end(), dropped);
  found.candidates.erase(kept, found.candidates.end());
}

template <class Steps>
void keep_nearest_by_stable(const Steps& steps, SearchState& found) {
  for (Candidate& candidate : found.candidates) refine(steps, candidate);
  const auto is_stable = [](const Candidate& c) { return c.at.step == Step::stable; };
  if (!std::all_of(found.candidates.begin(), found.candidates.end(), is_stable)) return;
  keep_not_farther(
      found, [&](const Candidate& a, const Candidate& b) { return steps.ahead(a.at.finding, b.at.finding); },
      [&](const Meeting& a, const Meeting& b) { return steps.certainly_less(a.finding, b.finding); });
}

template <class Steps>
void keep_nearest_by_exact(const Steps& steps, SearchState& found) {
  for (Candidate& candidate : found.candidates) make_exact(steps, candidate);
  keep_not_farther(
      found, [&](const Candidate& a, const Candidate& b) { return steps.order(*a.at.t, *b.at.t) < 0; },
      [&](const Meeting& a, const Meeting& b) { return steps.order(*a.t, *b.t) < 0; });
}

/// Two elements of equal numbers that were found alike. Every step says the same of both, so the first stands for the
/// second.
struct CongruentElement {
  scene::ElementRef as, e;
};

/// An order of candidates in which those of equal numbers that were found alike are equal.
template <class Steps>
std::strong_ordering order_of_kinds(const Steps& steps, const Candidate& a, const Candidate& b) {
  const RootEstimate &f = a.at.finding, &g = b.at.finding;
  auto side = steps.order_of_numbers(a.e, b.e);
  if (side == 0) side = a.at.step <=> b.at.step;
  if (side == 0) side = std::strong_order(f.hi, g.hi);
  if (side == 0) side = std::strong_order(f.lo, g.lo);
  return side == 0 ? std::strong_order(f.error, g.error) : side;
}

/// Removes all but the first of candidates that are alike, and lists the others, so that no step computes them again.
/// O(n log n) comparisons of stored numbers for n candidates.
template <class Steps>
std::vector<CongruentElement> set_alike_apart(const Steps& steps, SearchState& found) {
  auto& all = found.candidates;
  boost::container::small_vector<std::uint32_t, 16> order(all.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    const auto side = order_of_kinds(steps, all[i], all[j]);
    return side == 0 ? i < j : side < 0;
  });
  std::vector<CongruentElement> alike;
  std::size_t first = 0, kept = 1;  // the first of the alike; the number kept
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (order_of_kinds(steps, all[order[first]], all[order[i]]) == 0) {
      alike.push_back({all[order[first]].e, all[order[i]].e});
    } else {
      first = i;
      order[kept++] = order[i];
    }
  }
  if (alike.empty()) return alike;
  std::sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(kept));
  for (std::size_t i = 0; i < kept; ++i)
    if (order[i] != i) all[i] = std::move(all[order[i]]);
  all.erase(all.begin() + static_cast<std::ptrdiff_t>(kept), all.end());
  return alike;
}

/// Drops the listed elements whose representative was dropped.
inline void drop_alike(std::vector<CongruentElement>& alike, const SearchState& found) {
  if (alike.empty()) return;
  std::vector<scene::ElementRef> left;
  for (const Candidate& candidate : found.candidates) left.push_back(candidate.e);
  std::sort(left.begin(), left.end());
  const auto dropped = [&](const CongruentElement& a) { return !std::binary_search(left.begin(), left.end(), a.as); };
  alike.erase(std::remove_if(alike.begin(), alike.end(), dropped), alike.end());
}

template <class Steps>
void keep_nearest(const Steps& steps, SearchState& found, Counts& counts) {
  Step step = Step::triage;
  std::vector<CongruentElement> alike;
  const auto several = [&] { return found.candidates.size() + alike.size() > 1; };
  if (several()) {
    step = Step::stable;
    alike = set_alike_apart(steps, found);
    keep_nearest_by_stable(steps, found);
    drop_alike(alike, found);
  }
  if (several()) {
    step = Step::exact;
    keep_nearest_by_exact(steps, found);
    drop_alike(alike, found);
  }
  ++counts.order[static_cast<std::size_t>(step)];
  for (const CongruentElement& a : alike) found.candidates.push_back({a.e, {}});
}

template <class Steps>
RoundedPoint rounded_candidate(const Steps& steps, const Candidate& nearest, Counts& counts) {
  const bool on = steps.on(nearest.e);
  const auto count = [&](Step step) { ++counts.rounding[static_cast<std::size_t>(step)]; };
  const auto attempt = [&](const RootEstimate& finding) {
    if (finding.verdict != Decision::hit) return RoundedPoint{};
    return steps.visit(nearest.e, [&](const auto& element) { return steps.rounded(element, finding); });
  };
  RoundedPoint r{};
  if (nearest.at.step == Step::triage) {
    r = attempt(
        steps.visit(nearest.e, [&](const auto& element) { return steps.improved(element, on, nearest.at.finding); }));
    if (r.certain) return count(Step::triage), r;
    r = attempt(steps.visit(nearest.e, [&](const auto& element) { return steps.stable(element, on, no_limit); }));
  } else if (nearest.at.step == Step::stable) {
    r = attempt(nearest.at.finding);
  }
  if (r.certain) return count(Step::stable), r;
  count(Step::exact);
  return nearest.at.t ? steps.rounded(*nearest.at.t) : steps.rounded(reach_of(steps, nearest.e).first());
}

template <class Steps>
scene::Hit published(const Steps& steps, SearchState& found, Counts& counts) {
  scene::Hit hit;
  if (!found.without_minimum.empty()) {
    hit.resultado = model::Resultado::no_minimum;
    hit.elementos = std::move(found.without_minimum);
  } else if (!found.candidates.empty()) {
    keep_nearest(steps, found, counts);
    const RoundedPoint r = rounded_candidate(steps, found.candidates.front(), counts);
    hit.resultado = model::Resultado::hit;
    hit.t = r.t;
    hit.punto = r.punto;
    for (const Candidate& candidate : found.candidates) hit.elementos.push_back(candidate.e);
  }
  std::sort(hit.elementos.begin(), hit.elementos.end());
  return hit;
}

}  // namespace durero::trace
