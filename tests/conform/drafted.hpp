#pragma once
/// Questions of one ray, written by hand.

#include "conform/judge/draft.hpp"
#include "durero/conform/report/tally.hpp"

namespace durero::test {

/// A case of these elements, answered.
inline conform::SuiteCase drafted(std::vector<conform::Draft::Element> elements, const glm::dvec3& p,
                                  const glm::dvec3& v) {
  conform::SuiteCase like = conform::suite_case({}, *conform::find_family("generic"), 0);
  like.the_case.rays.erase(like.the_case.rays.begin() + 1, like.the_case.rays.end());
  conform::Draft draft(like);
  draft.elements = std::move(elements);
  draft.p = p;
  draft.v = v;
  return draft.built(like).value();
}

inline conform::SuiteCase sphere_case(const glm::dvec3& p, const glm::dvec3& v) {
  return drafted({{"e0", scene::Sphere{glm::dvec3(0, 0, 4), 1}}}, p, v);
}

inline conform::Finding finding_of(conform::SuiteCase of, const conform::Claim& claim,
                                   const conform::Profile& profile) {
  const conform::ClaimJudgement judgement = conform::judge(of, 0, claim, profile);
  return {std::move(of), 0, claim, judgement};
}

inline conform::Claim hit_at(double t) { return {conform::Claim::Outcome::hit, {}, t, {}}; }
inline conform::Claim miss() { return {conform::Claim::Outcome::miss}; }

}  // namespace durero::test
