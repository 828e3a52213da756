// A population of right programs that cast balls, against the judge: whatever they claim of themselves and however
// their data are moved within what is allowed, none of their answers is a failure.
#include "right_caster.hpp"

#include <fmt/core.h>

#include <cstdlib>
#include <glm/geometric.hpp>

#include "drawn_profile.hpp"
#include "durero/conform/judge/judge.hpp"
#include "durero/conform/report/report.hpp"
#include "hits.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"

using namespace durero;
using namespace durero::conform;
using namespace durero::test;

namespace {

BallCaster drawn_caster(Random& random, const SuiteCase& of, std::size_t ray) {
  BallCaster caster{.profile = drawn_profile(random, of)};
  Profile& profile = caster.profile;
  profile.questions = {QuestionKind::first, QuestionKind::cast};
  profile.caps = Caps::open;
  constexpr Data kinds[] = {Data::given, Data::rounded, Data::moved, Data::moved};
  caster.data = kinds[random.below(4)];
  caster.draw = static_cast<Draw>(random.below(3));
  caster.by_text = random.chance(1, 8);
  caster.gives_point = random.chance(1, 2);
  caster.gives_t = random.chance(7, 8);
  caster.culls_backs = random.chance(1, 2);
  const scene::Hit& hit = of.truths[ray].hit;
  const glm::dvec3 v = of.the_case.rays[ray].rayo.v().xyz();
  const double number = profile.measure == Measure::length ? hit.t * glm::length(v) : hit.t;
  if (random.chance(1, 10)) profile.least_t = std::abs(near_number(random, number));
  if (random.chance(1, 5)) profile.greatest_t = std::abs(near_number(random, number));
  if (profile.least_t > profile.greatest_t) std::swap(profile.least_t, profile.greatest_t);
  return caster;
}

struct JudgedCasts {
  std::size_t answers = 0, skipped = 0, exact = 0, misses = 0, moved = 0, lost = 0, failures = 0;
};

void judge_answer(JudgedCasts& judged, const SuiteCase& of, std::size_t ray, std::uint64_t seed) {
  Random random(seed);
  const BallCaster caster = drawn_caster(random, of, ray);
  const CaseJudge judge(of, caster.profile);
  if (!judge.outside(ray).empty()) return void(++judged.skipped);
  const std::optional<Claim> claim = RightCast(caster, of, ray, random).claim();
  if (!claim) return void(++judged.lost);
  const Verdict verdict = judge.judge(ray, *claim).verdict;
  ++judged.answers;
  judged.exact += verdict == Verdict::exact;
  judged.misses += claim->outcome == Claim::Outcome::miss;
  judged.moved += caster.data == Data::moved;
  if (!is_failure(verdict)) return;
  ++judged.failures;
  if (judged.failures > 20) return;
  std::string words;
  of.the_case.scene.for_each(
      [&](scene::ElementRef e, const auto&) { words += of.the_case.scene.name(e).name() + " "; });
  FAIL_CHECK(of.name() << " ray " << ray << ", caster " << seed << ": " << name(verdict) << "\n"
                       << text(of.the_case.rays[ray]) << "\nexpected " << truth_words(of, ray, *claim) << "\ngot "
                       << claim_words(*claim, of.the_case.scene) << "\n"
                       << words << word(caster.profile.format) << " "
                       << data_words[static_cast<std::size_t>(caster.data)] << (caster.by_text ? " by text" : "")
                       << " error " << caster.profile.error << " thickness " << caster.profile.thickness << " inside "
                       << word(caster.profile.inside) << " measure " << word(caster.profile.measure) << " least "
                       << caster.profile.least_t << " greatest " << caster.profile.greatest_t);
}

/// Of each family so many cases of either format with so many balls each; of each ball some programs.
JudgedCasts judge_casters(std::uint64_t suite_seed, std::uint64_t cases_of_each, std::size_t rays,
                          std::size_t casters) {
  JudgedCasts judged;
  std::uint64_t seed = suite_seed << 32U;
  for (const NumberFormat numbers : {NumberFormat::binary32, NumberFormat::binary64}) {
    const SuiteOptions options{
        .seed = suite_seed, .rays = cases_of_each * rays_of_a_case, .numbers = numbers, .question = QuestionKind::cast};
    for (const Family& family : families_of_few()) {
      for (std::uint64_t number = 0; number < cases(options, family); ++number) {
        SuiteCase of = suite_case(options, family, number);
        of.the_case.rays.resize(rays, of.the_case.rays[0]);
        answer(of);
        ask_question(of, options);
        for (std::size_t ray = 0; ray < rays; ++ray)
          for (std::size_t i = 0; i < casters; ++i) judge_answer(judged, of, ray, ++seed);
      }
    }
  }
  return judged;
}

}  // namespace

TEST_CASE("no first touch of a right program is off, whatever it claims and wherever its limits lie") {
  const JudgedCasts judged = judge_casters(1, 1, 2, fewer_when_sanitized(6));
  INFO(judged.answers << " answers, " << judged.exact << " exact, " << judged.misses << " misses, " << judged.skipped
                      << " skipped, " << judged.lost << " lost");
  CHECK(judged.answers > fewer_when_sanitized(450));
  CHECK(judged.moved > judged.answers / 4);
  CHECK(judged.misses > judged.answers / 20);
  CHECK(judged.exact < judged.answers * 3 / 4);
  CHECK(judged.failures == 0);
}

TEST_CASE("nor of many first touches", "[long]") {
  // RIGHT_CASTER_SUITES: how many of the suites.
  const char* asked = std::getenv("RIGHT_CASTER_SUITES");
  const std::uint64_t suites = asked == nullptr ? 8 : std::strtoull(asked, nullptr, 10);
  std::size_t answers = 0, lost = 0;
  for (std::uint64_t suite = 2; suite < 2 + suites; ++suite) {
    const JudgedCasts judged = judge_casters(suite, 2, 8, 6);
    answers += judged.answers;
    lost += judged.lost;
    CHECK(judged.failures == 0);
  }
  fmt::print("{} first touches of right programs were judged, {} not found\n", answers, lost);
  CHECK(answers > suites * 2'500);
}
