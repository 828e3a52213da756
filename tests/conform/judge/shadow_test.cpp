// The judgement on shadow rays: whether anything is hit up to an end.
#include <cmath>

#include "conform/drafted.hpp"
#include "conform/judged.hpp"
#include "conform/perturbed.hpp"
#include "durero/conform/judge/judge.hpp"
#include "durero/conform/judge/minimise.hpp"
#include "durero/conform/judge/trait.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::conform;
using Outcome = Claim::Outcome;

namespace {

constexpr double epsilon = 0x1p-53;

Claim claim_of(bool is_hit) { return {.outcome = is_hit ? Outcome::hit : Outcome::miss}; }

/// A ball of radius 1 around (0, 0, 4), asked from the origin, at t = 3.
SuiteCase ball(double end, const glm::dvec3& v = {0, 0, 1}) {
  SuiteCase of = test::sphere_case({0, 0, 0}, v);
  of.question = QuestionKind::shadow;
  of.ranges = {{0, end}};
  return of;
}

Verdict verdict(const SuiteCase& of, bool is_hit, const Profile& profile = test::profile_of_all()) {
  return judge(of, 0, claim_of(is_hit), profile).verdict;
}

/// The cases of a family as shadow rays.
std::vector<SuiteCase> shadows(const Family& family, NumberFormat numbers, std::uint64_t count) {
  return test::asked_cases(family, QuestionKind::shadow, numbers, count);
}

struct ShadowTally {
  std::size_t exact = 0, right = 0, phantom = 0, missed = 0, other = 0;
  void add(Verdict verdict) {
    (verdict == Verdict::exact     ? exact
     : verdict == Verdict::right   ? right
     : verdict == Verdict::phantom ? phantom
     : verdict == Verdict::missed  ? missed
                                   : other) += 1;
  }
};

/// The verdicts on is_hit(hit, ray, end) for every ray of some scenes of each family.
template <class IsHit>
ShadowTally judged_shadows(IsHit is_hit) {
  ShadowTally tally;
  const Profile profile = test::profile_of_all();
  for (const Family& family : families_of_few()) {
    for (const SuiteCase& of : shadows(family, NumberFormat::binary32, 4)) {
      for (std::size_t ray = 0; ray < of.truths.size(); ++ray) {
        const bool says = is_hit(of.truths[ray].hit, of.the_case.rays[ray], of.ranges[ray].end);
        tally.add(judge(of, ray, claim_of(says), profile).verdict);
      }
    }
  }
  return tally;
}

bool is_met(const scene::Hit& hit, double end) {
  return hit.resultado == model::Resultado::no_minimum || (hit.resultado == model::Resultado::hit && hit.t <= end);
}

double length_of(const scene::Query& ray) {
  const glm::dvec3 v = ray.rayo.v().xyz();
  return std::hypot(v.x, v.y, v.z);
}

}  // namespace

TEST_CASE("a hit before the end is a hit, one behind it none, and at the end both are right") {
  CHECK(verdict(ball(3.1), true) == Verdict::exact);
  CHECK(verdict(ball(3.1), false) == Verdict::missed);
  CHECK(verdict(ball(2.9), true) == Verdict::phantom);
  CHECK(verdict(ball(2.9), false) == Verdict::exact);
  CHECK(verdict(ball(3), true) == Verdict::exact);
  CHECK(verdict(ball(3), false) == Verdict::right);
  for (const double off : {-8 * epsilon, 8 * epsilon}) {
    CHECK_FALSE(is_failure(verdict(ball(3 + 4 * off), true)));
    CHECK_FALSE(is_failure(verdict(ball(3 + 4 * off), false)));
  }
  // With δ = 16ε·4 the ball's zone ends some 5δ behind the crossing, and an end counts from 2δ behind the zone on.
  constexpr double delta = 64 * epsilon;
  CHECK(verdict(ball(3 + 6 * delta), false) == Verdict::right);
  CHECK(verdict(ball(3 + 16 * delta), false) == Verdict::missed);
  CHECK(verdict(ball(3 - 0x1p-40), true) == Verdict::phantom);
  CHECK(verdict(ball(1e30, {0, 0, -1}), true) == Verdict::phantom);
}

TEST_CASE("the end is a t, also for a system that measures lengths") {
  Profile lengths = test::profile_of_all();
  lengths.measure = Measure::length;
  CHECK(verdict(ball(1.6, {0, 0, 2}), true, lengths) == Verdict::exact);
  CHECK(verdict(ball(1.6, {0, 0, 2}), false, lengths) == Verdict::missed);
  CHECK(verdict(ball(1.4, {0, 0, 2}), true, lengths) == Verdict::phantom);
}

TEST_CASE("what the profile permits of the first hit it permits of a shadow") {
  Profile origin = test::profile_of_all();
  origin.inside = Inside::origin;
  SuiteCase inside = test::sphere_case({0, 0, 4}, {0, 0, 1});
  inside.question = QuestionKind::shadow;
  inside.ranges = {{0, 0.5}};
  CHECK(verdict(inside, true) == Verdict::phantom);
  CHECK(verdict(inside, true, origin) == Verdict::right);
  Profile nothing = test::profile_of_all();
  nothing.inside = Inside::nothing;
  inside.ranges = {{0, 1.5}};
  CHECK(verdict(inside, false) == Verdict::missed);
  CHECK(verdict(inside, false, nothing) == Verdict::right);
  Profile near = test::profile_of_all();
  near.greatest_t = 2;
  CHECK(verdict(ball(5), false, near) == Verdict::skipped);
  CHECK(judge(ball(5), 0, {.outcome = Outcome::crashed}, test::profile_of_all()).verdict == Verdict::crashed);
}

TEST_CASE("exact answers, and those of data within the declared error, are never wrong") {
  const ShadowTally exact =
      judged_shadows([](const scene::Hit& hit, const scene::Query&, double end) { return is_met(hit, end); });
  CHECK(exact.right + exact.phantom + exact.missed + exact.other == 0);
  std::size_t moved = 0, doubtful = 0;
  for (const Family& family : families_of_few()) {
    for (const NumberFormat format : {NumberFormat::binary32, NumberFormat::binary64}) {
      const Profile profile = test::wide_profile(format);
      test::Perturbation perturbation(7, format);
      for (const SuiteCase& of : shadows(family, format, 6)) {
        for (std::size_t ray = 0; ray < of.truths.size(); ++ray) {
          const scene::Hit& hit = of.truths[ray].hit;
          const double t =
              hit.resultado == model::Resultado::hit ? std::min(hit.t, of.ranges[ray].end) : of.ranges[ray].end;
          const auto claim = perturbation.answer(of.the_case.scene, of.the_case.rays[ray], t, Measure::parameter);
          if (!claim || !outside(of, ray, profile).empty()) continue;
          const bool is_hit = claim->outcome == Outcome::hit && *claim->t <= of.ranges[ray].end;
          const Verdict is = judge(of, ray, claim_of(is_hit), profile).verdict;
          INFO(of.name() << " ray " << ray << ", " << (is_hit ? "hit" : "miss") << " up to " << of.ranges[ray].end);
          CHECK_FALSE(is_failure(is));
          ++moved;
          doubtful += is == Verdict::right;
        }
      }
    }
  }
  CHECK(moved > 4000);
  CHECK(doubtful > 100);
}

TEST_CASE("faults of shadow rays are seen") {
  const auto any = judged_shadows([](const scene::Hit& hit, const auto&, double) { return is_met(hit, 1e300); });
  CHECK(any.phantom > 200);
  const auto none = judged_shadows([](const auto&, const auto&, double) { return false; });
  CHECK(none.missed > 500);
  const auto as_length = judged_shadows(
      [](const scene::Hit& hit, const scene::Query& ray, double end) { return is_met(hit, end / length_of(ray)); });
  CHECK(as_length.phantom > 50);
  CHECK(as_length.missed > 50);
  const auto cut =
      judged_shadows([](const scene::Hit& hit, const auto&, double end) { return is_met(hit, 0.999 * end); });
  CHECK(cut.missed > 20);
  CHECK(cut.phantom == 0);
  const auto longer =
      judged_shadows([](const scene::Hit& hit, const auto&, double end) { return is_met(hit, 1.0001 * end); });
  CHECK(longer.phantom > 20);
  CHECK(longer.missed == 0);
}

TEST_CASE("a shadow ray's end stays where it is while its failure is made small and its cause is looked for") {
  const Profile all = test::profile_of_all();
  const Ask as_length = [](const SuiteCase& of) {
    return claim_of(is_met(of.truths[0].hit, of.ranges[0].end / length_of(of.the_case.rays[0])));
  };
  const SuiteCase of = ball(1.75, {0.0625, 0.125, 2});
  const Finding finding = test::finding_of(of, as_length(of), all);
  REQUIRE(finding.judgement.verdict == Verdict::missed);
  CHECK(cause_of(finding, all, as_length) == Trait::not_unit);
  const Finding least = minimised(finding, all, as_length);
  CHECK(least.judgement.verdict == Verdict::missed);
  REQUIRE(least.of.ranges.size() == 1);
  const Ask blind_to_small = [](const SuiteCase& asked) {
    const bool is_small = asked.the_case.scene.shapes<scene::Sphere>()[0].radio < 0.01;
    return claim_of(!is_small && is_met(asked.truths[0].hit, asked.ranges[0].end));
  };
  SuiteCase small =
      test::drafted({{"e0", scene::Sphere{glm::dvec3(0, 0, 0x1p-8), 0x1p-10}}}, {0x1p-13, 0, 0}, {0, 0, 1});
  small.question = QuestionKind::shadow;
  small.ranges = {{0, 0x1.8p-8}};
  CHECK(cause_of(test::finding_of(small, claim_of(false), all), all, blind_to_small) == Trait::small);
  Draft draft(ball(3.5));
  scale_direction(draft, 2);
  CHECK(draft.range->end == 1.75);
  move_along(draft, 0.5);
  CHECK(draft.range->end == 1.25);
  scale_with_t(draft, 2);
  CHECK(draft.range->end == 5);
  scale(draft, 3);
  CHECK(draft.range->end == 5);
  move_along(draft, 6);
  CHECK_FALSE(draft.built(ball(1)));
}
