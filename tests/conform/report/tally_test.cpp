#include "durero/conform/report/tally.hpp"

#include "conform/judged.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::conform;

TEST_CASE("a system that gives the exact answers has no failures in any family") {
  const Profile profile = test::profile_of_all();
  Tally tally;
  std::size_t rays = 0;
  for (const Family& family : families_of_few()) {
    const SuiteCase of = test::answered_case(family.name.data(), 0);
    tally.add(of, test::right_claims(of), profile);
    rays += of.the_case.rays.size();
  }
  CHECK(tally.families().size() == families_of_few().size());
  CHECK(tally.rays() == rays);
  CHECK(tally.failures() == 0);
  CHECK(tally.is_conformant());
  CHECK(tally.of(Verdict::exact) > rays * 9 / 10);
  CHECK(tally.of(Verdict::exact) + tally.of(Verdict::right) == rays);
  for (const FamilyTally& family : tally.families()) {
    CHECK_FALSE(family.most_failures);
    for (const auto& worst : family.worst) CHECK_FALSE(worst);
  }
}

TEST_CASE("failures are counted by family and verdict, and the worst kept with its ray") {
  const Profile profile = test::profile_of_all();
  Tally tally;
  for (std::uint64_t number = 0; number < 4; ++number) {
    const SuiteCase of = test::answered_case("tiny", number);
    tally.add(of, test::claims_blind_to_small(of), profile);
  }
  REQUIRE(tally.families().size() == 1);
  const FamilyTally& tiny = tally.families()[0];
  CHECK(tiny.of(Verdict::missed) > 0);
  CHECK(tiny.gross() == tiny.failures());
  CHECK(tiny.rays() == 4 * rays_of_a_case);
  CHECK(tiny.spreads.size() == 4);
  const auto& worst = tiny.worst[static_cast<std::size_t>(Verdict::missed)];
  REQUIRE(worst);
  REQUIRE(worst->of.the_case.rays.size() == 1);
  const SuiteCase whole = test::answered_case("tiny", worst->of.number);
  CHECK(worst->of.the_case.rays[0].rayo == whole.the_case.rays[worst->ray].rayo);
  CHECK(worst->of.truths[0].hit == whole.truths[worst->ray].hit);
  CHECK(worst->judgement.verdict == Verdict::missed);
  REQUIRE(tiny.most_failures);
  std::size_t failures = 0;
  for (const ClaimJudgement& is : tiny.most_failures->judgements) failures += is_failure(is.verdict);
  CHECK(failures > 0);
  CHECK(failures <= tiny.failures());
}

TEST_CASE("of two failures the one farther from the surface is the worse, whichever comes first") {
  const SuiteCase of = test::answered_case("generic", 0);
  for (const bool greater_first : {true, false}) {
    Claims claims = test::right_claims(of);
    std::vector<std::size_t> hits;
    for (std::size_t ray = 0; ray < claims.size() && hits.size() < 2; ++ray) {
      if (claims[ray].t && of.truths[ray].ambiguity == Ambiguity::none) hits.push_back(ray);
    }
    REQUIRE(hits.size() == 2);
    *claims[hits[greater_first ? 0 : 1]].t *= -0.5;  // before the origin, and far from any element
    *claims[hits[greater_first ? 1 : 0]].t *= 1 - 0x1p-7;
    Tally tally;
    tally.add(of, claims, test::profile_of_all());
    const auto& worst = tally.families()[0].worst[static_cast<std::size_t>(Verdict::misplaced)];
    REQUIRE(tally.of(Verdict::misplaced) == 2);
    CHECK(worst.value().ray == hits[greater_first ? 0 : 1]);
  }
}

TEST_CASE("what is outside the profile is counted under its clause") {
  Profile profile = test::profile_of_all();
  profile.tipos = {model::Tipo::soy_disco};
  const SuiteCase of = test::answered_case("generic", 0);
  Tally tally;
  tally.add(of, test::right_claims(of), profile);
  CHECK(tally.of(Verdict::skipped) == of.the_case.rays.size());
  CHECK(tally.failures() == 0);
  CHECK_FALSE(tally.is_conformant());  // nothing was judged
  REQUIRE(tally.families()[0].clauses.size() >= 1);
  CHECK_FALSE(tally.families()[0].clauses.begin()->first.empty());
}

TEST_CASE("ulps fall into bins of powers of two") {
  CHECK(ulp_bin(0) == 0);
  CHECK(ulp_bin(0.5) == 1);
  CHECK(ulp_bin(1) == 1);
  CHECK(ulp_bin(1.5) == 2);
  CHECK(ulp_bin(2) == 2);
  CHECK(ulp_bin(3) == 3);
  CHECK(ulp_bin(0x1p63) == 64);
  CHECK(ulp_bin(0x1p64) == 65);
  CHECK(ulp_bin(std::numeric_limits<double>::infinity()) == 65);
  CHECK(ulp_bin(std::numeric_limits<double>::quiet_NaN()) == 0);
}

TEST_CASE("a sample has the first failing rays, and counts the rays that were judged until it was full") {
  Profile profile = test::profile_of_all();
  profile.greatest_t = 4;
  Tally tally;
  std::uint64_t judged = 0, failures = 0;
  for (std::uint64_t number = 0; number < 4; ++number) {
    const SuiteCase of = test::answered_case("rim", number);
    const CaseJudge judge(of, profile);
    const Claims claims(of.truths.size(), {Claim::Outcome::miss});
    tally.add(of, claims, profile);
    for (std::size_t ray = 0; ray < claims.size(); ++ray) {
      const Verdict verdict = judge.judge(ray, claims[ray]).verdict;
      if (failures < sample_size(*of.family)) judged += verdict != Verdict::skipped;
      failures += is_failure(verdict);
    }
  }
  const FamilyTally& family = tally.families()[0];
  REQUIRE(failures > sample_size(*family.family));
  REQUIRE(family.of(Verdict::skipped) > 0);
  CHECK(family.sample.size() == sample_size(*family.family));
  CHECK(family.sampled_rays == judged);
}

TEST_CASE("a ray alone keeps its own range") {
  SuiteCase of = test::answered_case("generic", 0);
  of.question = QuestionKind::shadow;
  for (std::size_t ray = 0; ray < of.truths.size(); ++ray) of.ranges.push_back({0, 1 + static_cast<double>(ray)});
  CHECK(with_ray_alone(of, 3).ranges == std::vector<AskedRange>{{0, 4}});
  CHECK(with_ray_alone(test::answered_case("generic", 0), 3).ranges.empty());
}
