#include "durero/conform/judge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "conform/allowance.hpp"
#include "conform/error_of.hpp"
#include "conform/question.hpp"
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
bool is_near_truth(const Question& question, const Claim& claim, const Place& place) {
  const scene::ElementSet& first = question.truth.hit.elementos;
  if (!question.has_hit() || std::none_of(first.begin(), first.end(), [&](auto e) { return question.names(claim, e); }))
    return false;
  const glm::dvec3 &p = question.ray.rayo.p().xyz(), &v = question.ray.rayo.v().xyz();
  const double t = question.truth.hit.t, M = std::max(largest(p), t * largest(v));
  const double apart =
      place.given ? std::abs(*place.given - t) * largest(v) : largest(*claim.punto - question.truth.hit.punto);
  return std::isfinite(M) && apart <= 7 * unit(question.profile.format) * M;
}

/// Solids that the origin may lie inside.
Elements solids_around_origin(const Question& question) {
  const glm::dvec3& p = question.ray.rayo.p().xyz();
  const Place origin{{}, {p.x, p.y, p.z}, {}, 0};
  Elements around;
  question.scene.for_each([&](ElementRef element, const auto&) {
    if (question.is_solid(element) &&
        may_lie_inside(question.scene, element, origin, question.ray.rayo, question.profile.format))
      around.push_back(element);
  });
  return around;
}

/// What a system must not pass by: every zone, but those of solids that a ray from inside does not meet by its profile.
std::vector<Zone> walls(const Question& question) {
  std::vector<Zone> all = zones(question.scene, question.ray, question.profile.format);
  if (question.profile.inside != Inside::nothing) return all;
  const Elements around = solids_around_origin(question);
  std::erase_if(all, [&](const Zone& zone) {
    return std::find(around.begin(), around.end(), question.body(zone.element)) != around.end();
  });
  return all;
}

Verdict of_miss(const Question& question) {
  if (question.truth.hit.resultado == model::Resultado::miss) return Verdict::exact;
  return walls(question).empty() ? Verdict::right : Verdict::missed;
}

/// The hit is at the origin, which may lie inside a solid that the claim may be of.
bool is_at_origin_inside(const Question& question, const Claim& claim, const Place& place) {
  if (question.profile.inside != Inside::origin) return false;
  const Elements around = solids_around_origin(question);
  return std::any_of(around.begin(), around.end(), [&](ElementRef element) {
    return question.names(claim, element) && may_be_origin(question, element, place);
  });
}

/// Elements that the place may lie on, at a place of the ray.
Elements elements_at(const Question& question, const Place& place) {
  Elements all;
  question.scene.for_each([&](ElementRef element, const auto&) {
    if (may_lie_on(question.scene, element, place, question.ray.rayo, question.profile.format) &&
        may_lie_on_ray(question, element, place))
      all.push_back(element);
  });
  return all;
}

/// Off: why.
Verdict why_off(const Question& question, const Claim& claim, const Place& place, const Elements& at,
                const std::vector<Zone>& passed) {
  const auto is_named = [&](ElementRef element) { return question.names(claim, element); };
  const scene::ElementSet& first = question.truth.hit.elementos;
  const bool lies_on_named = std::any_of(at.begin(), at.end(), is_named);
  if (question.truth.hit.resultado == model::Resultado::miss) return Verdict::phantom;
  if (lies_on_named) {
    const auto is_of_those = [&](const Zone& zone) {
      return is_named(zone.element) && std::any_of(at.begin(), at.end(), [&](ElementRef element) {
               return question.body(element) == question.body(zone.element);
             });
    };
    if (std::none_of(passed.begin(), passed.end(), is_of_those)) return Verdict::wrong_element;
    return is_far(question, place) ? Verdict::far_root : Verdict::off;
  }
  if (claim.element && !at.empty()) return Verdict::wrong_element;
  if (is_far(question, place)) return Verdict::misplaced;
  return std::any_of(first.begin(), first.end(), is_named) ? Verdict::off : Verdict::wrong_element;
}

Verdict of_place(const Question& question, const Claim& claim, const Place& place) {
  std::vector<Zone> passed = walls(question);
  std::erase_if(passed, [&](const Zone& zone) { return !is_behind(place, zone, question.ray.rayo); });
  const Elements at = elements_at(question, place);
  const bool lies_on_named =
      std::any_of(at.begin(), at.end(), [&](ElementRef element) { return question.names(claim, element); });
  if ((lies_on_named && passed.empty()) || is_at_origin_inside(question, claim, place)) return Verdict::right;
  return why_off(question, claim, place, at, passed);
}

Judgement of_hit(const Question& question, const Claim& claim) {
  if (is_the_truth(question, claim)) return {.verdict = Verdict::exact};
  const std::optional<Place> where = place(question, claim);
  if (!where) return {.verdict = Verdict::non_finite};
  const Verdict verdict = is_near_truth(question, claim, *where) ? Verdict::right : of_place(question, claim, *where);
  return {
      .verdict = verdict, .ulps = ulps(question, claim, *where), .backward = backward_error(question, claim, *where)};
}

Judgement inside_profile(const Question& question, const Claim& claim) {
  switch (claim.outcome) {
    case Claim::Outcome::hit:
      return of_hit(question, claim);
    case Claim::Outcome::miss:
      return {.verdict = of_miss(question)};
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
  const Question question(of, ray, profile);
  std::string clause = outside(of, ray, profile);
  if (clause.empty()) return inside_profile(question, claim);
  Judgement skipped{.clause = std::move(clause)};
  if (claim.outcome != Claim::Outcome::unanswered) skipped.otherwise = inside_profile(question, claim).verdict;
  return skipped;
}

}  // namespace durero::conform
