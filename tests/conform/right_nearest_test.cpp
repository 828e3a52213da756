// A population of right programs that find nearest points, against the judge: whatever they claim of themselves and
// however their data are moved within what is allowed, none of their answers is a failure.
#include "right_nearest.hpp"

#include <fmt/core.h>

#include <cstdlib>

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

NearestFinder drawn_finder(Random& random, const SuiteCase& of, const ExactAnswer& truth) {
  NearestFinder finder{.profile = drawn_profile(random, of)};
  Profile& profile = finder.profile;
  profile.questions = {QuestionKind::first, QuestionKind::closest};
  constexpr Data kinds[] = {Data::given, Data::rounded, Data::moved, Data::moved};
  finder.data = kinds[random.below(4)];
  finder.draw = static_cast<Draw>(random.below(3));
  finder.by_text = random.chance(1, 4);
  finder.gives_point = random.chance(4, 5);
  finder.gives_distance = random.chance(4, 5);
  const auto limit = [&] { return std::abs(near_number(random, truth.hit.t)); };
  if (random.chance(1, 8)) profile.least_t = limit();
  if (random.chance(1, 4)) profile.greatest_t = limit();
  if (profile.least_t > profile.greatest_t) std::swap(profile.least_t, profile.greatest_t);
  return finder;
}

/// The claim of a program that sees nothing beyond its limits.
Claim within_limits(const NearestFinder& finder, const Claim& claim, double distance) {
  const bool is_beyond = distance < narrowed(finder.profile.least_t, finder.profile.format) ||
                         distance > narrowed(finder.profile.greatest_t, finder.profile.format);
  return is_beyond ? Claim{.outcome = Claim::Outcome::miss} : claim;
}

struct JudgedNearest {
  std::size_t answers = 0, skipped = 0, exact = 0, misses = 0, moved = 0, failures = 0;
};

void judge_answer(JudgedNearest& judged, const SuiteCase& of, std::size_t ray, std::uint64_t seed) {
  Random random(seed);
  const NearestFinder finder = drawn_finder(random, of, of.truths[ray]);
  const CaseJudge judge(of, finder.profile);
  if (!judge.outside(ray).empty()) return void(++judged.skipped);
  RightNearest nearest(finder, of, ray, random);
  const std::optional<Claim> found = nearest.claim();
  if (!found) return;
  const Claim claim = within_limits(finder, *found, nearest.distance());
  const Verdict verdict = judge.judge(ray, claim).verdict;
  ++judged.answers;
  judged.exact += verdict == Verdict::exact;
  judged.misses += claim.outcome == Claim::Outcome::miss;
  judged.moved += finder.data == Data::moved;
  if (!is_failure(verdict)) return;
  ++judged.failures;
  if (judged.failures > 20) return;
  const glm::dvec3 p = of.the_case.rays[ray].rayo.p().xyz();
  FAIL_CHECK(of.name() << " ray " << ray << ", finder " << seed << ": " << name(verdict) << "\n"
                       << fmt::format("p ({:a}, {:a}, {:a})", p.x, p.y, p.z) << "\nexpected "
                       << truth_words(of, ray, claim) << "\ngot " << claim_words(claim, of.the_case.scene) << "\n"
                       << word(finder.profile.format) << " " << data_words[static_cast<std::size_t>(finder.data)]
                       << (finder.by_text ? " by text" : "") << " error " << finder.profile.error << " thickness "
                       << finder.profile.thickness << " inside " << word(finder.profile.inside) << " caps "
                       << word(finder.profile.caps) << " greatest " << finder.profile.greatest_t);
}

/// Of each family so many cases of either format, open and with solids, with so many points each; of each point some
/// programs.
JudgedNearest judge_finders(std::uint64_t suite_seed, std::uint64_t cases_of_each, std::size_t points,
                            std::size_t finders) {
  JudgedNearest judged;
  std::uint64_t seed = suite_seed << 32U;
  for (const NumberFormat numbers : {NumberFormat::binary32, NumberFormat::binary64}) {
    for (const Caps caps : {Caps::open, Caps::solid}) {
      const SuiteOptions options{.seed = suite_seed,
                                 .rays = cases_of_each * rays_of_a_case,
                                 .caps = caps,
                                 .numbers = numbers,
                                 .question = QuestionKind::closest};
      for (const Family& family : families_of_few()) {
        for (std::uint64_t number = 0; number < cases(options, family); ++number) {
          SuiteCase of = suite_case(options, family, number);
          of.the_case.rays.resize(points, of.the_case.rays[0]);
          ask_question(of, options);
          for (std::size_t ray = 0; ray < points; ++ray)
            for (std::size_t i = 0; i < finders; ++i) judge_answer(judged, of, ray, ++seed);
        }
      }
    }
  }
  return judged;
}

void check_finders(const JudgedNearest& judged, std::size_t least) {
  INFO(judged.answers << " answers, " << judged.exact << " exact, " << judged.skipped << " skipped");
  CHECK(judged.answers > least);
  CHECK(judged.moved > judged.answers / 4);
  CHECK(judged.misses > judged.answers / 100);
  CHECK(judged.exact < judged.answers * 3 / 4);
  CHECK(judged.failures == 0);
}

}  // namespace

TEST_CASE("no nearest point of a right program is off, whatever it claims and wherever its limits lie") {
  check_finders(judge_finders(1, 1, 2, fewer_when_sanitized(16)), fewer_when_sanitized(2'500));
}

TEST_CASE("nor of a hundred thousand nearest points", "[long]") {
  // RIGHT_NEAREST_SUITES: how many of the suites.
  const char* asked = std::getenv("RIGHT_NEAREST_SUITES");
  const std::uint64_t suites = asked == nullptr ? 16 : std::strtoull(asked, nullptr, 10);
  std::size_t answers = 0;
  for (std::uint64_t suite = 2; suite < 2 + suites; ++suite) {
    const JudgedNearest judged = judge_finders(suite, 2, 4, 12);
    answers += judged.answers;
    CHECK(judged.failures == 0);
  }
  fmt::print("{} nearest points of right programs were judged\n", answers);
  CHECK(answers > suites * 6'250);
}
