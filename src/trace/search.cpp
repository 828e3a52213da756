#include "durero/trace/search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "trace/ends.hpp"
#include "trace/steps.hpp"
#include "trace/triage.hpp"

namespace durero::trace {
namespace {

using Kind = Meeting::Kind;
using surface::exact::Parameter;

Meeting point_of(Step step, const Finding& found) {
  const auto [low, high] = step == Step::triage ? ends_of(found.hi, found.error) : ends_of_pair(found.hi, found.error);
  return {Kind::point, step, low, high, found};
}

Meeting point_of(Parameter t) {
  const double nearest = number::round_to_binary64(t);
  return {.kind = Kind::point,
          .step = Step::exact,
          .low = std::nextafter(nearest, -no_limit),
          .high = std::nextafter(nearest, no_limit),
          .t = std::make_shared<const Parameter>(std::move(t))};
}

Meeting exact_meeting(const surface::exact::Reach& reach) {
  if (reach.empty()) return {.step = Step::exact};
  if (reach.no_minimum()) return {.kind = Kind::no_minimum, .step = Step::exact};
  return point_of(reach.first());
}

/// Precondition: element and ray are ordinary.
template <class Element>
std::optional<Meeting> certified_meeting_of(const Element& element, const Ray& ray, bool on, double limit) {
  const Finding first = triage(element, ray, on, limit);
  if (first.verdict == Verdict::miss) return Meeting{};
  if (first.verdict == Verdict::hit) return point_of(Step::triage, first);
  const Finding second = stable(element, ray, on, limit);
  if (second.verdict == Verdict::miss) return Meeting{.step = Step::stable};
  if (second.verdict == Verdict::hit) return point_of(Step::stable, second);
  return std::nullopt;
}

/// in_range: element and ray are ordinary.
template <class Element>
Meeting meeting_of(const Element& element, const model::Rayo& rayo, const Ray& ray, bool in_range, bool on,
                   double limit) {
  if (in_range) {
    if (auto met = certified_meeting_of(element, ray, on, limit)) return *std::move(met);
  }
  return exact_meeting(surface::exact::reach(scene::ShapeView(element), rayo, on));
}

}  // namespace

Search::Search(const scene::Scene& scene, const model::Rayo& rayo, Origin en, Counts& counts)
    : scene_(scene), rayo_(rayo), en_(en), counts_(counts), ray_(rayo) {}

Meeting Search::meeting(scene::ElementRef e, double limit, Range range) const {
  const bool on = en_.contains(e);
  Meeting met = scene_.visit(e, [&](const auto& element) {
    const bool in_range = ray_.ordinary && (range == Range::ordinary || ordinary(element));
    return meeting_of(element, rayo_, ray_, in_range, on, limit);
  });
  ++counts_.element[static_cast<std::size_t>(met.step)];
  return met;
}

std::optional<Meeting> Search::certified_meeting(scene::ElementRef e, double limit) const {
  return scene_.visit(e, [&](const auto& element) {
    const bool in_range = ray_.ordinary && ordinary(element);
    return in_range ? certified_meeting_of(element, ray_, en_.contains(e), limit) : std::nullopt;
  });
}

bool Search::blocks(scene::ElementRef e, Range range) const { return meeting(e, no_limit, range).kind != Kind::none; }

/// Near 1 the exact parameter decides.
bool Search::blocks_segment(scene::ElementRef e, Range range) const {
  const Meeting met = meeting(e, 1, range);
  if (met.kind != Kind::point) return met.kind == Kind::no_minimum;
  if (met.high < 1) return true;
  if (met.low > 1) return false;
  const auto reach = surface::exact::reach(scene_, e, rayo_, en_);
  return surface::exact::order(reach.first(), Parameter{.x = 1}) < 0;
}

void Search::test(scene::ElementRef e, Range range) {
  Meeting met = meeting(e, limit_, range);
  if (met.kind == Kind::none || met.low > limit_) return;
  if (met.kind == Kind::no_minimum) {
    without_minimum_.push_back(e);
    return;
  }
  const bool nearer = met.high < limit_;
  if (nearer) limit_ = met.high;
  candidates_.push_back({e, std::move(met)});
  if (nearer) drop_beyond_limit();  // the others lay within the limit as it was
}

void Search::drop_beyond_limit() {
  const auto beyond = [&](const Candidate& c) { return c.at.low > limit_; };
  candidates_.erase(std::remove_if(candidates_.begin(), candidates_.end(), beyond), candidates_.end());
}

void Search::refine(Candidate& candidate) const {
  if (candidate.at.step != Step::triage) return;
  const Finding found =
      scene_.visit(candidate.e, [&](const auto& e) { return stable(e, ray_, en_.contains(candidate.e)); });
  if (found.verdict == Verdict::hit) candidate.at = point_of(Step::stable, found);
}

const Parameter& Search::exact(Candidate& candidate) const {
  if (!candidate.at.t) candidate.at = exact_meeting(surface::exact::reach(scene_, candidate.e, rayo_, en_));
  return *candidate.at.t;
}

void Search::keep_nearest_by_stable() {
  for (Candidate& candidate : candidates_) refine(candidate);
  const auto is_stable = [](const Candidate& c) { return c.at.step == Step::stable; };
  if (!std::all_of(candidates_.begin(), candidates_.end(), is_stable)) return;
  const auto by_hi = [](const Candidate& a, const Candidate& b) { return a.at.finding.hi < b.at.finding.hi; };
  const Finding least = std::min_element(candidates_.begin(), candidates_.end(), by_hi)->at.finding;
  const auto farther = [&](const Candidate& c) { return certainly_less(least, c.at.finding); };
  candidates_.erase(std::remove_if(candidates_.begin(), candidates_.end(), farther), candidates_.end());
}

void Search::keep_nearest_by_exact() {
  for (Candidate& candidate : candidates_) exact(candidate);
  const auto less = [](const Candidate& a, const Candidate& b) { return surface::exact::order(*a.at.t, *b.at.t) < 0; };
  const Candidate least = *std::min_element(candidates_.begin(), candidates_.end(), less);
  const auto farther = [&](const Candidate& c) { return less(least, c); };
  candidates_.erase(std::remove_if(candidates_.begin(), candidates_.end(), farther), candidates_.end());
}

scene::Hit Search::finish() {
  scene::Hit hit;
  if (!without_minimum_.empty()) {
    hit.resultado = model::Resultado::no_minimum;
    hit.elementos = std::move(without_minimum_);
  } else if (!candidates_.empty()) {
    keep_nearest();
    const Rounded r = round(candidates_.front());
    hit.resultado = model::Resultado::hit;
    hit.t = r.t;
    hit.punto = r.punto;
    for (const Candidate& candidate : candidates_) hit.elementos.push_back(candidate.e);
  }
  std::sort(hit.elementos.begin(), hit.elementos.end());
  return hit;
}

void Search::keep_nearest() {
  Step step = Step::triage;
  if (candidates_.size() > 1) {
    step = Step::stable;
    keep_nearest_by_stable();
  }
  if (candidates_.size() > 1) {
    step = Step::exact;
    keep_nearest_by_exact();
  }
  ++counts_.order[static_cast<std::size_t>(step)];
}

Rounded Search::rounded_hit(scene::ElementRef e, const Finding& by_triage) const {
  return round({e, point_of(Step::triage, by_triage)});
}

Rounded Search::rounded_hit(scene::ElementRef e, const Meeting& met) const { return round({e, met}); }

Rounded Search::round(const Candidate& nearest) const {
  const bool on = en_.contains(nearest.e);
  const auto count = [&](Step step) { ++counts_.rounding[static_cast<std::size_t>(step)]; };
  const auto attempt = [&](const Finding& finding) {
    if (finding.verdict != Verdict::hit) return Rounded{};
    return scene_.visit(nearest.e, [&](const auto& e) { return rounded(e, ray_, finding); });
  };
  Rounded r{};
  if (nearest.at.step == Step::triage) {
    r = attempt(scene_.visit(nearest.e, [&](const auto& e) { return improved(e, ray_, on, nearest.at.finding); }));
    if (r.certain) return count(Step::triage), r;
    r = attempt(scene_.visit(nearest.e, [&](const auto& e) { return stable(e, ray_, on, no_limit); }));
  } else if (nearest.at.step == Step::stable) {
    r = attempt(nearest.at.finding);
  }
  if (r.certain) return count(Step::stable), r;
  count(Step::exact);
  const auto exactly = [&](const Parameter& t) {
    const scene::Hit hit = surface::exact::rounded_hit(rayo_, t, {});
    return Rounded{true, hit.t, hit.punto};
  };
  return nearest.at.t ? exactly(*nearest.at.t) : exactly(surface::exact::reach(scene_, nearest.e, rayo_, en_).first());
}

}  // namespace durero::trace
