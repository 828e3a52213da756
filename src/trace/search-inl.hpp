#pragma once
/// The search of one ray, over steps that are given: function by function the model of proofs/Search.v, and of a shadow
/// ray that of proofs/Occlusion.v. search.cpp gives it the steps of the program, tests give it tables of answers.
///
/// What Steps has, where `element` is what visit hands to its function, and `on` whether the ray starts on it:
///   on(e), visit(e, use)                           of an ElementRef
///   in_range(element, range)                       floating point may be asked
///   triage(element, on, limit), stable(element, on, limit), improved(element, on, finding)    as in steps.hpp
///   reach(element, on), order(t, u)                exact
///   ends(step, finding), ends(t)                   around the parameter
///   ahead(f, g), certainly_less(f, g)              of two findings by stable: the first is to be tried, is nearer
///   rounded(element, finding), rounded(t)          t and the point, rounded once

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "durero/trace/search.hpp"

namespace durero::trace {

using surface::exact::Parameter;

template <class Steps>
Meeting point_of(const Steps& steps, Step step, const Finding& found) {
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
  const Finding first = steps.triage(element, on, limit);
  if (first.verdict == Verdict::miss) return Meeting{};
  if (first.verdict == Verdict::hit) return point_of(steps, Step::triage, first);
  const Finding second = steps.stable(element, on, limit);
  if (second.verdict == Verdict::miss) return Meeting{.step = Step::stable};
  if (second.verdict == Verdict::hit) return point_of(steps, Step::stable, second);
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

/// Near 1 the exact parameter decides.
template <class Steps>
bool blocks_segment(const Steps& steps, scene::ElementRef e, Search::Range range, Counts& counts) {
  const Meeting met = meeting_of(steps, e, 1, range, counts);
  if (met.kind != Meeting::Kind::point) return met.kind == Meeting::Kind::no_minimum;
  if (met.high < 1) return true;
  if (met.low > 1) return false;
  return steps.order(reach_of(steps, e).first(), Parameter{.x = 1}) < 0;
}

inline void drop_beyond_limit(Found& found) {
  const auto beyond = [&](const Candidate& c) { return c.at.low > found.limit; };
  const auto kept = std::remove_if(found.candidates.begin(), found.candidates.end(), beyond);
  found.candidates.erase(kept, found.candidates.end());
}

template <class Steps>
void take(const Steps& steps, Found& found, scene::ElementRef e, Search::Range range, Counts& counts) {
  Meeting met = meeting_of(steps, e, found.limit, range, counts);
  if (met.kind == Meeting::Kind::none || met.low > found.limit) return;
  if (met.kind == Meeting::Kind::no_minimum) {
    found.without_minimum.push_back(e);
    return;
  }
  const bool nearer = met.high < found.limit;
  if (nearer) found.limit = met.high;
  found.candidates.push_back({e, std::move(met)});
  if (nearer) drop_beyond_limit(found);  // the others lay within the limit as it was
}

template <class Steps>
void refine(const Steps& steps, Candidate& candidate) {
  if (candidate.at.step != Step::triage) return;
  const bool on = steps.on(candidate.e);
  const Finding found =
      steps.visit(candidate.e, [&](const auto& element) { return steps.stable(element, on, no_limit); });
  if (found.verdict == Verdict::hit) candidate.at = point_of(steps, Step::stable, found);
}

template <class Steps>
void make_exact(const Steps& steps, Candidate& candidate) {
  if (!candidate.at.t) candidate.at = exact_meeting(steps, reach_of(steps, candidate.e));
}

/// Leaves those that are not farther than the first of least.
template <class First, class Farther>
void keep_not_farther(Found& found, First first, Farther farther) {
  const Meeting least = std::min_element(found.candidates.begin(), found.candidates.end(), first)->at;
  const auto dropped = [&](const Candidate& c) { return farther(least, c.at); };
  const auto kept = std::remove_if(found.candidates.begin(), found.candidates.end(), dropped);
  found.candidates.erase(kept, found.candidates.end());
}

template <class Steps>
void keep_nearest_by_stable(const Steps& steps, Found& found) {
  for (Candidate& candidate : found.candidates) refine(steps, candidate);
  const auto is_stable = [](const Candidate& c) { return c.at.step == Step::stable; };
  if (!std::all_of(found.candidates.begin(), found.candidates.end(), is_stable)) return;
  keep_not_farther(
      found, [&](const Candidate& a, const Candidate& b) { return steps.ahead(a.at.finding, b.at.finding); },
      [&](const Meeting& a, const Meeting& b) { return steps.certainly_less(a.finding, b.finding); });
}

template <class Steps>
void keep_nearest_by_exact(const Steps& steps, Found& found) {
  for (Candidate& candidate : found.candidates) make_exact(steps, candidate);
  keep_not_farther(
      found, [&](const Candidate& a, const Candidate& b) { return steps.order(*a.at.t, *b.at.t) < 0; },
      [&](const Meeting& a, const Meeting& b) { return steps.order(*a.t, *b.t) < 0; });
}

template <class Steps>
void keep_nearest(const Steps& steps, Found& found, Counts& counts) {
  Step step = Step::triage;
  if (found.candidates.size() > 1) {
    step = Step::stable;
    keep_nearest_by_stable(steps, found);
  }
  if (found.candidates.size() > 1) {
    step = Step::exact;
    keep_nearest_by_exact(steps, found);
  }
  ++counts.order[static_cast<std::size_t>(step)];
}

template <class Steps>
Rounded rounded_candidate(const Steps& steps, const Candidate& nearest, Counts& counts) {
  const bool on = steps.on(nearest.e);
  const auto count = [&](Step step) { ++counts.rounding[static_cast<std::size_t>(step)]; };
  const auto attempt = [&](const Finding& finding) {
    if (finding.verdict != Verdict::hit) return Rounded{};
    return steps.visit(nearest.e, [&](const auto& element) { return steps.rounded(element, finding); });
  };
  Rounded r{};
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
scene::Hit published(const Steps& steps, Found& found, Counts& counts) {
  scene::Hit hit;
  if (!found.without_minimum.empty()) {
    hit.resultado = model::Resultado::no_minimum;
    hit.elementos = std::move(found.without_minimum);
  } else if (!found.candidates.empty()) {
    keep_nearest(steps, found, counts);
    const Rounded r = rounded_candidate(steps, found.candidates.front(), counts);
    hit.resultado = model::Resultado::hit;
    hit.t = r.t;
    hit.punto = r.punto;
    for (const Candidate& candidate : found.candidates) hit.elementos.push_back(candidate.e);
  }
  std::sort(hit.elementos.begin(), hit.elementos.end());
  return hit;
}

}  // namespace durero::trace
