#include "durero/conform/judge/judge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "conform/judge/allowance.hpp"
#include "conform/judge/cast.hpp"
#include "conform/judge/closest.hpp"
#include "conform/judge/crossings.hpp"
#include "conform/judge/error_of.hpp"
#include "conform/judge/limits.hpp"
#include "conform/judge/normals.hpp"
#include "conform/judge/outside.hpp"
#include "conform/judge/robust.hpp"
#include "conform/judge/trial.hpp"
#include "conform/judge/walls.hpp"
#include "durero/contract/contract.hpp"
#include "durero/trace/candidates.hpp"
#include "durero/trace/search.hpp"

namespace durero::conform {
namespace {

using scene::ElementRef;
using Elements = std::vector<ElementRef>;

/// Whether the claim may name an element of the truth.
bool names_truth(const ClaimContext& trial, const Claim& claim) {
  const scene::ElementSet& first = trial.truth.hit.elementos;
  return std::any_of(first.begin(), first.end(), [&](ElementRef element) { return trial.names(claim, element); });
}

/// Whether the claimed point lies so near the truth's that the hit is right; binary64 decides it. The points differ in
/// each coordinate by at most 7ε·M, where M is the larger of |p| and |t!·v| only, and so no larger than the M of any
/// element at its first crossing or behind. With the roundings of t!, of a length and here the claimed point is within
/// √3·(7 + 1 + 1)/16·δ < δ of a point of the element, and may lie on it. The truth lies before the end of every zone of
/// every element, and so no zone ends 2δ/|v| before the claim. A product that underflows is off by less than the share
/// of δ for subnormals.
bool is_near_truth(const ClaimContext& trial, const Claim& claim, const ClaimedPoint& place) {
  if (!trial.has_hit() || !names_truth(trial, claim)) return false;
  const glm::dvec3 &p = trial.ray.rayo.p().xyz(), &v = trial.ray.rayo.v().xyz();
  const double t = trial.truth.hit.t, M = std::max(largest(p), t * largest(v));
  const double apart =
      place.given ? std::abs(*place.given - t) * largest(v) : largest(*claim.punto - trial.truth.hit.punto);
  return std::isfinite(M) && apart <= 7 * unit(trial.profile.format) * M;
}

Verdict of_miss(const ClaimContext& trial) {
  if (trial.truth.hit.resultado == model::Resultado::miss) return Verdict::exact;
  return walls(trial, trace::no_limit).empty() ? Verdict::right : Verdict::missed;
}

bool may_be_of_any(const ClaimContext& trial, const ClaimedPoint& place) {
  return !elements_at(trial, {}, place).empty();
}

/// The zones that certainly end before the place, where the place lies on `element`.
std::vector<Zone> passed_by(const ClaimContext& trial, const ClaimedPoint& place, ElementRef element,
                            std::vector<Zone> zones) {
  const model::Rayo& rayo = trial.ray.rayo;
  const Dyadic own = Dyadic(place.deviation) * delta(trial.elements(), element, place, rayo, trial.precision());
  std::erase_if(zones, [&](const Zone& zone) { return !is_behind(place, own, zone, rayo); });
  return zones;
}

/// Whether the ray of some data may meet the element within its range with no zone of another body certainly before.
bool may_be_first(const ClaimContext& trial, ElementRef element, const std::vector<Zone>& zones) {
  const model::Rayo& rayo = trial.ray.rayo;
  const auto t = earliest_asked(trial, element);
  return t && std::none_of(zones.begin(), zones.end(), [&](const Zone& zone) {
           return trial.body(zone.element) != trial.body(element) &&
                  is_behind({.t = *t, .punto = {}, .way = {}}, {}, zone, rayo);
         });
}

/// Whether a place is a little off what the claim may name: near the origin inside a solid, where the system answers
/// that; near the truth's point, an element of the truth, or one that is first for some data and passes there.
bool is_a_little_off(const ClaimContext& trial, const Claim& claim, const ClaimedPoint& place) {
  if (std::ranges::any_of(answered_origins(trial, claim),
                          [&](ElementRef element) { return is_near_origin(trial, place, element); }))
    return true;
  if (!trial.has_hit() || is_far(trial, place)) return false;
  if (names_truth(trial, claim)) return true;
  const std::vector<Zone> all = walls(trial, trace::no_limit);
  return trial.any_named(claim, [&](ElementRef element) {
    return is_near_surface(trial, place, element) && may_be_first(trial, element, all);
  });
}

/// The verdict on a hit whose place is not right. `at` has the elements that the claim may name and the place may lie
/// on; each is outside the range, or at least one of the zones is before it. Several elements may be first: a hit that
/// names one of them, near the truth's point, is off and not of a wrong element, whatever other element passes there.
Verdict of_wrong_place(const ClaimContext& trial, const Claim& claim, const ClaimedPoint& place, const Elements& at,
                       const std::vector<Zone>& zones) {
  if (is_a_little_off(trial, claim, place)) return Verdict::off;
  const auto is_asked = [&](ElementRef element) { return may_be_within_range(trial, element, place); };
  if (!at.empty() && std::none_of(at.begin(), at.end(), is_asked)) return Verdict::out_of_range;
  if (trial.truth.hit.resultado == model::Resultado::miss) return Verdict::phantom;
  const auto is_first = [&](ElementRef element) { return may_be_first(trial, element, zones); };
  if (std::any_of(at.begin(), at.end(), is_first)) return Verdict::far_root;
  return is_far(trial, place) && at.empty() && !may_be_of_any(trial, place) ? Verdict::misplaced
                                                                            : Verdict::wrong_element;
}

/// The verdict on a hit with a place. It is right at the origin inside a solid, where the system answers that, and
/// where the place may lie on an element that the claim may name, within the range, and no zone certainly ends before
/// it.
Verdict of_place(const ClaimContext& trial, const Claim& claim, const ClaimedPoint& place) {
  if (std::ranges::any_of(answered_origins(trial, claim),
                          [&](ElementRef element) { return may_be_origin(trial, element, place); }))
    return Verdict::right;
  const Elements at = elements_at(trial, claim, place);
  const std::vector<Zone> all = walls(trial, rounded_up(place.t));
  const auto is_right = [&](ElementRef element) {
    return may_be_within_range(trial, element, place) && passed_by(trial, place, element, all).empty();
  };
  if (std::any_of(at.begin(), at.end(), is_right)) return Verdict::right;
  return of_wrong_place(trial, claim, place, at, all);
}

/// The verdict on a hit without a place, which is right where an element that it may name is first for some data.
Verdict of_element(const ClaimContext& trial, const Claim& claim) {
  if (names_truth(trial, claim)) return Verdict::right;
  if (!answered_origins(trial, claim).empty()) return Verdict::right;
  const std::vector<Zone> all = walls(trial, trace::no_limit);
  const bool may_be = trial.any_named(claim, [&](ElementRef element) { return may_be_first(trial, element, all); });
  if (may_be) return Verdict::right;
  return trial.truth.hit.elementos.empty() ? Verdict::phantom : Verdict::wrong_element;
}

/// The judgement on a hit by its place alone, where it has one.
ClaimJudgement judgement_of_place(const ClaimContext& trial, const Claim& claim,
                                  const std::optional<ClaimedPoint>& where) {
  if (is_the_truth(trial, claim)) return {.verdict = Verdict::exact};
  if (!where) return {.verdict = Verdict::non_finite};
  const bool is_near = is_near_truth(trial, claim, *where);
  return {.verdict = is_near ? Verdict::right : of_place(trial, claim, *where),
          .ulps = ulps(trial, claim, *where),
          .backward = is_near ? backward_error_near_truth(trial, claim, *where) : backward_error(trial, claim, *where)};
}

ClaimJudgement of_hit(const ClaimContext& trial, const Claim& claim) {
  if (!claim.t && !claim.punto) return {.verdict = of_element(trial, claim)};
  const std::optional<ClaimedPoint> where = place(trial, claim);
  ClaimJudgement is = judgement_of_place(trial, claim, where);
  const bool is_right = is.verdict == Verdict::exact || is.verdict == Verdict::right;
  if (!is_right || !where || !has_besides(claim)) return is;
  const Verdict besides = verdict_besides(trial, claim, *where, elements_at(trial, claim, *where));
  if (besides != Verdict::right) is.verdict = besides;
  return is;
}

/// Whether the exact first hit of a shadow ray, rounded, is not behind its end.
bool is_in_shadow(const ClaimContext& trial) {
  if (trial.truth.hit.resultado == model::Resultado::no_minimum) return true;
  return trial.has_hit() && trial.truth.hit.t <= trial.range->end;
}

/// Whether the ray of some data may meet an element before the end, or the system answers the origin inside a solid.
bool may_be_in_shadow(const ClaimContext& trial) {
  if (trial.profile.inside == Inside::origin && !trial.solids_around_origin().empty()) return true;
  return trial.scene.any_of(
      [&](ElementRef element, const auto&) { return earliest_asked(trial, element).has_value(); });
}

/// The verdict on a claim about a shadow ray: a hit is right where some data have one before the end, and a miss where
/// not all data have one there. Whatever the claim says of a hit besides is not judged.
Verdict of_shadow(const ClaimContext& trial, const Claim& claim) {
  const bool is_hit = claim.outcome == Claim::Outcome::hit;
  if (is_hit == is_in_shadow(trial)) return Verdict::exact;
  if (is_hit) return may_be_in_shadow(trial) ? Verdict::right : Verdict::phantom;
  return walls(trial, trace::no_limit).empty() ? Verdict::right : Verdict::missed;
}

ClaimJudgement inside_profile(const ClaimContext& trial, const Claim& claim) {
  const bool is_answer = claim.outcome == Claim::Outcome::hit || claim.outcome == Claim::Outcome::miss;
  if (trial.question == QuestionKind::shadow && is_answer) return {.verdict = of_shadow(trial, claim)};
  if (trial.question == QuestionKind::closest && is_answer) return judgement_of_closest(trial, claim);
  if (trial.question == QuestionKind::cast && is_answer) return judgement_of_cast(trial, claim);
  if (trial.question == QuestionKind::all && is_answer) return judgement_of_all(trial, claim);
  if (trial.question == QuestionKind::count && is_answer) {
    if (!claim.count && claim.outcome == Claim::Outcome::hit) return {.clause = "no answer: no count"};
    return {.verdict = verdict_of_count(trial, claim)};
  }
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
      return {.clause = claim.why.empty() ? "no answer" : "no answer: " + claim.why};
  }
  contract::unreachable();
}

/// The verdict that the claim would get on a ray outside the profile. Limits are lifted where the exact first hit is
/// beyond them, for within them the ray has no hit to be judged by.
Verdict otherwise(const SuiteCase& of, std::size_t ray, const Claim& claim, const ClaimContext& trial) {
  if (!is_truth_beyond_limits(trial)) return inside_profile(trial, claim).verdict;
  const Profile unlimited = without_limits(trial.profile);
  return inside_profile(ClaimContext(of, ray, unlimited, trial.facts), claim).verdict;
}

}  // namespace

class CaseJudge::Parts {
 public:
  Parts(const SuiteCase& of, const Profile& profile)
      : of_(&of), profile_(&profile), facts_(of.the_case.scene, of.the_case.rays.size(), of.others()) {}

  ClaimJudgement judge(std::size_t ray, const Claim& claim) const {
    const ClaimContext trial(*of_, ray, *profile_, facts_);
    std::string clause = outside(trial);
    if (clause.empty()) return inside_profile(trial, claim);
    ClaimJudgement skipped{.clause = std::move(clause)};
    if (claim.outcome != Claim::Outcome::unanswered) skipped.otherwise = otherwise(*of_, ray, claim, trial);
    return skipped;
  }

  std::string outside(std::size_t ray) const { return outside(ClaimContext(*of_, ray, *profile_, facts_)); }
  std::size_t rays() const { return of_->the_case.rays.size(); }

 private:
  std::string outside(const ClaimContext& trial) const {
    std::call_once(scene_once_, [&] { of_scene_ = outside_by_scene(trial); });
    return of_scene_.empty() ? outside_by_ray(trial) : of_scene_;
  }

  const SuiteCase* of_;
  const Profile* profile_;
  SceneFacts facts_;
  mutable std::once_flag scene_once_;
  mutable std::string of_scene_{};
};

CaseJudge::CaseJudge(const SuiteCase& of, const Profile& profile)
    : parts_(std::make_unique<const Parts>(of, profile)) {}
CaseJudge::~CaseJudge() = default;

ClaimJudgement CaseJudge::judge(std::size_t ray, const Claim& claim) const { return parts_->judge(ray, claim); }

std::vector<ClaimJudgement> CaseJudge::judge(std::span<const Claim> claims) const {
  std::vector<ClaimJudgement> all(claims.size());
  trace::for_each_block(claims.size(), [&](std::size_t begin, std::size_t count) {
    for (std::size_t ray = begin; ray < begin + count; ++ray) all[ray] = judge(ray, claims[ray]);
  });
  return all;
}

std::string CaseJudge::outside(std::size_t ray) const { return parts_->outside(ray); }

std::vector<std::string> CaseJudge::outside() const {
  std::vector<std::string> all(parts_->rays());
  for (std::size_t ray = 0; ray < all.size(); ++ray) all[ray] = outside(ray);
  return all;
}

ClaimJudgement judge(const SuiteCase& of, std::size_t ray, const Claim& claim, const Profile& profile) {
  return CaseJudge(of, profile).judge(ray, claim);
}

std::string outside(const SuiteCase& of, std::size_t ray, const Profile& profile) {
  return CaseJudge(of, profile).outside(ray);
}

}  // namespace durero::conform
