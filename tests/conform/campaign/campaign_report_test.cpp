#include "durero/conform/campaign/campaign_report.hpp"

#include <cmath>

#include "conform/sharded.hpp"
#include "durero/conform/report/causes.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::conform;

namespace {

const Campaign two = {
    .system = "blind", .rays_of_a_shard = 200, .shards = 10, .families = {find_family("generic"), find_family("tiny")}};

System blind() {
  System system{
      .name = "blind", .title = "Blind", .ask = {}, .profile = test::profile_of_all(), .folder = {}, .setup = {}};
  system.profile.system = "blind";
  return system;
}

/// A shard of a system that sees no small element, or of one that is right.
Shards shard(std::uint64_t number, bool is_right = false) {
  return test::shard_of(two, number, is_right ? test::right_claims : test::claims_blind_to_small, "blind 1");
}

Shards shards(std::initializer_list<std::uint64_t> numbers) {
  Shards all;
  for (const std::uint64_t number : numbers) unite(all, shard(number));
  return all;
}

std::string text(const Shards& of, const Campaign& campaign = two) {
  return campaign_text(of, campaign, "0123456789abcdef", blind());
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

}  // namespace

TEST_CASE("totals are those of one tally of all shards, their worst rays made again") {
  const Profile profile = test::profile_of_all();
  const SuiteOptions options = suite_options(two, profile);
  Tally expected;
  for (const std::uint64_t number : {1, 4, 5}) {
    for (const CasePlace& place : cases_of_shard(two, options, number)) {
      SuiteCase of = suite_case(options, place);
      answer(of);
      expected.add(of, test::claims_blind_to_small(of), profile);
    }
  }
  const Tally all = totals(shards({5, 1, 4}), two, profile);
  CHECK(all.rays() == 600);
  REQUIRE(all.families().size() == 2);
  constexpr auto missed = static_cast<std::size_t>(Verdict::missed);
  std::size_t compared = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(all.families()[i].counts == expected.families()[i].counts);
    const auto &worst = all.families()[i].worst[missed], &its = expected.families()[i].worst[missed];
    REQUIRE(worst.has_value() == its.has_value());
    if (!worst) continue;
    ++compared;
    CHECK(worst->of.name() == its->of.name());
    CHECK(worst->ray == its->ray);
    CHECK(worst->claim == its->claim);
    CHECK(worst->judgement.backward == its->judgement.backward);
    CHECK(worst->of.the_case.rays.size() == 1);
  }
  CHECK(compared > 0);
}

TEST_CASE("clauses of skipped rays are counted") {
  Profile profile = test::profile_of_all();
  profile.tipos = {model::Tipo::soy_disco};
  ShardTally tally(two, 0, profile);
  const SuiteCase of = test::answered_case("generic", 0);
  tally.add(of, test::right_claims(of));
  const Tally all = totals(tally.shards(""), two, profile);
  CHECK(all.of(Verdict::skipped) == rays_of_a_case);
  std::uint64_t skipped = 0;
  for (const auto& [clause, count] : all.families()[0].clauses) skipped += count;
  CHECK(skipped == rays_of_a_case);
}

TEST_CASE("shards that are missing are listed as ranges") {
  CHECK(has(text(shards({1, 4, 5})),
            "campaign 0123456789abcdef: 3 of 10 shards\nmissing: 0, 2-3, 6-9\nBlind (blind 1)\n"));
  CHECK(has(text({}), ": 0 of 10 shards\nmissing: 0-9\n"));
  Shards whole;
  for (std::uint64_t number = 0; number < 10; ++number) whole.counts.insert({.shard = number});
  CHECK(has(text(whole), ": 10 of 10 shards\nBlind\n"));
  CHECK_FALSE(has(text(whole), "missing:"));
  Campaign long_one = two;
  long_one.shards = 1000;
  Shards even;
  for (std::uint64_t number = 0; number < 1000; number += 2) even.counts.insert({.shard = number});
  CHECK(has(text(even, long_one), "missing: 1, 3, 5"));
  CHECK(has(text(even, long_one), ", 199 and 400 more\n"));
}

TEST_CASE("a shard with different contents is named, and the first of them counts") {
  Shards all = shards({2, 3});
  CHECK(disputed(all).empty());
  Shards again = shard(3, true);
  unite(all, again);
  CHECK(disputed(all) == std::vector<std::uint64_t>{3});
  again = shard(3);
  ShardCounts third = *again.counts.begin();
  third.answers = 0;
  third.families.clear();
  all.counts.insert(third);
  CHECK(disputed(all) == std::vector<std::uint64_t>{3});
  CHECK(has(text(all), "shard 3 was given with different contents: answers 0000000000000000 answers "));
  CHECK(totals(all, two, test::profile_of_all()).rays() == 200);
}

TEST_CASE("a ray that this program judges otherwise than its shard is no total") {
  Shards all = shard(0);
  const auto& [kind, failed] = *all.failures.begin();
  Shards altered{.failures = {{{kind.first, Verdict::phantom}, failed}}};
  CHECK_THROWS_WITH(text(altered), Catch::Contains("was judged phantom and is missed now; expected"));
  FailedRay nonsense = failed.worst();
  nonsense.claim = "hit e999 1";
  FailedRays of_nonsense;
  of_nonsense.add(nonsense);
  altered.failures = {{kind, of_nonsense}};
  CHECK_THROWS_WITH(text(altered), Catch::Contains("the question has no such element"));
}

TEST_CASE("the worst rays are said with the calls that replay them") {
  const std::string said = text(shards({6}));
  CHECK(has(said, "durero conform show --case tiny/00"));
  CHECK(has(said, "durero conform minimise blind --case tiny/00"));
  Campaign unusual = two;
  unusual.caps = Caps::solid;  // what minimise does not know
  CHECK_FALSE(has(text(Shards{}, unusual), "minimise"));
  Shards of_it = shard(6);
  of_it.counts.clear();
  unusual = two;
  unusual.tipos = test::profile_of_all().tipos;
  CHECK_FALSE(has(text(of_it, unusual), "minimise"));
  CHECK(has(said, "\nhits off by 0 ulps: "));
}

TEST_CASE("the report of a campaign is that of a run, without what only a run keeps") {
  const System system = blind();
  Report report = campaign_report(shards({6}), two, system);
  CHECK(report.tally.rays() == totals(shards({6}), two, system.profile).rays());
  CHECK(report.tally.failures() > 0);
  guess_causes(report);
  CHECK_FALSE(report.causes.all.empty());
  CHECK_FALSE(report.causes.all[0].ordinary);
  const std::string page = report_html(report);
  CHECK(has(page, "<h3 id=\"tiny\">"));
  CHECK_FALSE(has(page, "A dot a case"));
}

TEST_CASE("hits are counted by their ulps") {
  Shards all;
  ShardCounts counts{.ulps = std::vector<std::uint64_t>(ulp_bins)};
  counts.ulps[0] = 850;
  counts.ulps[1] = 9;
  counts.ulps[12] = 3;
  counts.ulps[64] = 2;
  counts.ulps[65] = 1;
  all.counts.insert(counts);
  CHECK(has(text(all), "hits off by 0 ulps: 850, up to 1: 9, up to 2048: 3, up to 9223372036854775808: 2, more: 1\n"));
}

TEST_CASE("where no judged ray failed the share of those that do is bounded") {
  Shards all = shard(0, true);
  CHECK(has(text(all), "95 %: where none of n judged rays failed"));
  CHECK(has(text(all), "\ngeneric                         100           0.03"));
  CHECK(has(text(all), "\nall                             200          0.015           0.24\n"));
  const std::string of_blind = text(shard(0));
  CHECK(has(of_blind, "\ntiny                 "));  // among the counts
  CHECK_FALSE(has(of_blind.substr(of_blind.find("hits off")), "\ntiny"));
  CHECK_FALSE(has(of_blind.substr(of_blind.find("hits off")), "\nall"));
  CHECK_FALSE(has(text({}), "95 %"));
  for (const std::uint64_t n : {1, 2, 3, 10, 1000, 1'000'000'000}) {
    const double share = failing_share(n), exact = -std::expm1(std::log(0.05) / static_cast<double>(n));
    CHECK(exact <= share);
    if (n >= 1000) CHECK(share <= exact * 1.01);
    CHECK(failing_share_by_scenes(n) == std::min(1.0, 48 / static_cast<double>(n)));
  }
  CHECK(failing_share(1) == 1);
}
