#include "durero/conform/judge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "conform/allowance.hpp"
#include "conform/error_of.hpp"
#include "conform/trial.hpp"
#include "durero/contract/contract.hpp"

namespace durero::conform {
namespace {

using scene::ElementRef;
using Elements = std::vector<ElementRef>;

/// Whether the point is so near the truth's, by binary64, that the hit is right: in each coordinate by 7ε·M, where M is
/// the larger of |p| and |t!·v| only, so no larger than that of any element at its first crossing or behind. With the
/// roundings of t!, of a length and here it is within √3·(7 + 1 + 1)/16·δ < δ of a point of the element, so it may lie
/// on it; and since the truth lies before the end of every zone of every element, none ends 2δ/|v| before the claim. A
/// product that underflows is off by less than what δ has for subnormals.
bool is_near_truth(const Trial& trial, const Claim& claim, const Place& place) {
  const scene::ElementSet& first = trial.truth.hit.elementos;
  if (!trial.has_hit() || std::none_of(first.begin(), first.end(), [&](auto e) { return trial.names(claim, e); }))
    return false;
  const glm::dvec3 &p = trial.ray.rayo.p().xyz(), &v = trial.ray.rayo.v().xyz();
  const double t = trial.truth.hit.t, M = std::max(largest(p), t * largest(v));
  const double apart =
      place.given ? std::abs(*place.given - t) * largest(v) : largest(*claim.punto - trial.truth.hit.punto);
  return std::isfinite(M) && apart <= 7 * unit(trial.profile.format) * M;
}

/// Solids that the origin may lie inside.
Elements solids_around_origin(const Trial& trial) {
  const glm::dvec3& p = trial.ray.rayo.p().xyz();
  const Place origin{{}, {p.x, p.y, p.z}, {}, 0};
  Elements around;
  trial.scene.for_each([&](ElementRef element, const auto&) {
    if (trial.is_solid(element) && may_lie_inside(trial.scene, element, origin, trial.ray.rayo, trial.profile.format))
      around.push_back(element);
  });
  return around;
}

/// What a system must not pass by: every zone, but those of solids that a ray from inside does not meet by its profile.
std::vector<Zone> walls(const Trial& trial) {
  std::vector<Zone> all = zones(trial.scene, trial.ray, trial.profile.format);
  if (trial.profile.inside != Inside::nothing) return all;
  const Elements around = solids_around_origin(trial);
  std::erase_if(all, [&](const Zone& zone) {
    return std::find(around.begin(), around.end(), trial.body(zone.element)) != around.end();
  });
  return all;
}

Verdict of_miss(const Trial& trial) {
  if (trial.truth.hit.resultado == model::Resultado::miss) return Verdict::exact;
  return walls(trial).empty() ? Verdict::right : Verdict::missed;
}

/// The hit is at the origin, which may lie inside a solid that the claim may be of.
bool is_at_origin_inside(const Trial& trial, const Claim& claim, const Place& place) {
  if (trial.profile.inside != Inside::origin) return false;
  const Elements around = solids_around_origin(trial);
  return std::any_of(around.begin(), around.end(), [&](ElementRef element) {
    return trial.names(claim, element) && may_be_origin(trial, element, place);
  });
}

/// Elements that the place may lie on, at a place of the ray.
Elements elements_at(const Trial& trial, const Place& place) {
  Elements all;
  trial.scene.for_each([&](ElementRef element, const auto&) {
    if (may_lie_on(trial.scene, element, place, trial.ray.rayo, trial.profile.format) &&
        may_lie_on_ray(trial, element, place))
      all.push_back(element);
  });
  return all;
}

/// Off: why.
Verdict why_off(const Trial& trial, const Claim& claim, const Place& place, const Elements& at,
                const std::vector<Zone>& passed) {
  const auto is_named = [&](ElementRef element) { return trial.names(claim, element); };
  const scene::ElementSet& first = trial.truth.hit.elementos;
  const bool lies_on_named = std::any_of(at.begin(), at.end(), is_named);
  if (trial.truth.hit.resultado == model::Resultado::miss) return Verdict::phantom;
  if (lies_on_named) {
    const auto is_of_those = [&](const Zone& zone) {
      return is_named(zone.element) && std::any_of(at.begin(), at.end(), [&](ElementRef element) {
               return trial.body(element) == trial.body(zone.element);
             });
    };
    if (std::none_of(passed.begin(), passed.end(), is_of_those)) return Verdict::wrong_element;
    return is_far(trial, place) ? Verdict::far_root : Verdict::off;
  }
  if (claim.element && !at.empty()) return Verdict::wrong_element;
  if (is_far(trial, place)) return Verdict::misplaced;
  return std::any_of(first.begin(), first.end(), is_named) ? Verdict::off : Verdict::wrong_element;
}

Verdict of_place(const Trial& trial, const Claim& claim, const Place& place) {
  std::vector<Zone> passed = walls(trial);
  std::erase_if(passed, [&](const Zone& zone) { return !is_behind(place, zone, trial.ray.rayo); });
  const Elements at = elements_at(trial, place);
  const bool lies_on_named =
      std::any_of(at.begin(), at.end(), [&](ElementRef element) { return trial.names(claim, element); });
  if ((lies_on_named && passed.empty()) || is_at_origin_inside(trial, claim, place)) return Verdict::right;
  return why_off(trial, claim, place, at, passed);
}

Judgement of_hit(const Trial& trial, const Claim& claim) {
  if (is_the_truth(trial, claim)) return {.verdict = Verdict::exact};
  const std::optional<Place> where = place(trial, claim);
  if (!where) return {.verdict = Verdict::non_finite};
  const Verdict verdict = is_near_truth(trial, claim, *where) ? Verdict::right : of_place(trial, claim, *where);
  return {.verdict = verdict, .ulps = ulps(trial, claim, *where), .backward = backward_error(trial, claim, *where)};
}

Judgement inside_profile(const Trial& trial, const Claim& claim) {
  switch (claim.outcome) {
    case Claim::Outcome::hit:
      return of_hit(trial, claim);
    case Claim::Outcome::miss:
      return {.verdict = of_miss(trial)};
    case Claim::Outcome::crashed:
      return {.verdict = Verdict::crashed};
    case Claim::Outcome::hung:
      return {.verdict = Verdict::hung};
    case Claim::Outcome::unanswered:
      return {.clause = "no answer"};
  }
  contract::unreachable();
}

}  // namespace

Judgement judge(const SuiteCase& of, std::size_t ray, const Claim& claim, const Profile& profile) {
  const Trial trial(of, ray, profile);
  std::string clause = outside(of, ray, profile);
  if (clause.empty()) return inside_profile(trial, claim);
  Judgement skipped{.clause = std::move(clause)};
  if (claim.outcome != Claim::Outcome::unanswered) skipped.otherwise = inside_profile(trial, claim).verdict;
  return skipped;
}

}  // namespace durero::conform
