#include "durero/conform/campaign/shard.hpp"

#include <unistd.h>

#include <chrono>
#include <filesystem>

#include "conform/sharded.hpp"
#include "durero/conform/ask/question.hpp"
#include "durero/io/output_file.hpp"
#include "support/catch.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::conform;
namespace fs = std::filesystem;

namespace {

const std::string name_of_campaign = "0123456789abcdef";

Campaign campaign_of(std::vector<const Family*> families, std::uint64_t shards = 1000) {
  return {.system = "tested", .rays_of_a_shard = 200, .shards = shards, .families = std::move(families)};
}

const Campaign two = campaign_of({find_family("generic"), find_family("tiny")});

std::string text_of(const Shards& shards) { return shards_text(shards, two, name_of_campaign); }
Shards read(const std::string& text) { return read_shards({"s.json", text}, two, name_of_campaign); }

std::string refusal(const std::string& text) {
  try {
    read(text);
  } catch (const io::InputError& error) {
    return error.what();
  }
  return "nothing is wrong";
}

/// What a system that is blind to small elements gets in a shard.
Shards blind_shard(std::uint64_t shard, const Campaign& campaign = two) {
  return test::shard_of(campaign, shard, test::claims_blind_to_small, "tested 1");
}

Shards united(Shards a, Shards b) {
  unite(a, std::move(b));
  return a;
}

/// Shards and failures by the handful, so that many of them are the same in two sets.
rc::Gen<Shards> any_shards() {
  return rc::gen::exec([] {
    Shards shards{.says = *rc::gen::element<std::string>("", "tested 1")};
    const int counts = *rc::gen::inRange(0, 5), failures = *rc::gen::inRange(0, 30);
    for (int i = 0; i < counts; ++i) {
      ShardCounts of{.shard = *rc::gen::inRange<std::uint64_t>(0, 4),
                     .answers = *rc::gen::inRange<std::uint64_t>(0, 2)};
      if (*rc::gen::arbitrary<bool>()) of.families = {{{1, *rc::gen::inRange<std::uint64_t>(1, 3)}, {}}};
      shards.counts.insert(of);
    }
    for (int i = 0; i < failures; ++i) {
      const auto kind = std::pair(*rc::gen::elementOf(two.families), *rc::gen::element(Verdict::off, Verdict::missed));
      shards.failures[kind].add({.number = *rc::gen::inRange<std::uint64_t>(0, 6),
                                 .ray = *rc::gen::inRange<std::size_t>(0, 4),
                                 .elements = *rc::gen::inRange<std::size_t>(1, 3),
                                 .backward = *rc::gen::element(17.0, 20.5, std::numeric_limits<double>::infinity()),
                                 .claim = *rc::gen::element<std::string>("miss", "hit - 1")});
    }
    return shards;
  });
}

struct Folder {
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
  std::string path = fs::temp_directory_path() / ("shard_test." + std::to_string(::getpid()));
};

/// So many shards that asked nothing, each in a file, and the time to put them together.
void merge_empty_shards(std::uint64_t count, double seconds) {
  const Folder folder;
  Campaign campaign = campaign_of({find_family("generic"), find_family("tiny")}, count);
  for (const Family& family : families_of_few()) {
    if (&family != campaign.families[0] && &family != campaign.families[1]) campaign.families.push_back(&family);
  }
  campaign.rays_of_a_shard = 0;
  for (std::uint64_t shard = 0; shard < count; ++shard) {
    const std::string text = shards_text(blind_shard(shard, campaign), campaign, name_of_campaign);
    std::FILE* const file = std::fopen((folder.path + "/" + std::to_string(shard)).c_str(), "w");
    REQUIRE(file != nullptr);
    CHECK(std::fwrite(text.data(), 1, text.size(), file) == text.size());
    CHECK(std::fclose(file) == 0);
  }
  const auto begin = std::chrono::steady_clock::now();
  Shards all;
  for (const auto& file : fs::directory_iterator(folder.path))
    unite(all, read_shards(io::read_source(file.path()), campaign, name_of_campaign));
  const std::string text = shards_text(all, campaign, name_of_campaign);
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
  CHECK(all.counts.size() == count);
  CHECK(passed.count() < seconds);
  CHECK(read_shards({"all", text}, campaign, name_of_campaign).counts == all.counts);
}

}  // namespace

TEST_CASE("a shard counts what its rays came to, as a tally does") {
  const Profile profile = test::profile_of_all();
  const Shards shards = blind_shard(3);
  CHECK(shards.says == "tested 1");
  REQUIRE(shards.counts.size() == 1);
  const ShardCounts& counts = *shards.counts.begin();
  CHECK(counts.shard == 3);
  CHECK(counts.clauses.empty());
  REQUIRE(counts.families.size() == 2);
  Tally tally;
  std::uint64_t hits = 0, failing = 0;
  for (const CasePlace& place : cases_of_shard(two, suite_options(two, profile), 3)) {
    SuiteCase of = suite_case(suite_options(two, profile), place);
    answer(of);
    tally.add(of, test::claims_blind_to_small(of), profile);
  }
  for (std::size_t i = 0; i < 2; ++i) {
    const FamilyTally& family = tally.families()[i];
    for (std::size_t verdict = 0; verdict < counts.families[i].verdicts.size(); ++verdict)
      CHECK(counts.families[i].verdicts[verdict] == family.counts[verdict]);
    for (const std::uint64_t count : family.ulps) hits += count;
    if (family.of(Verdict::missed) == 0) continue;
    ++failing;
    const FailedRays& failed = shards.failures.at({family.family, Verdict::missed});
    const Finding& worst = *family.worst[static_cast<std::size_t>(Verdict::missed)];
    CHECK(failed.worst().number == worst.of.number);
    CHECK(failed.worst().ray == worst.ray);
    CHECK(failed.worst().claim == "miss");
    CHECK(failed.all().size() >= std::min<std::size_t>(failures_kept, family.of(Verdict::missed)));
    CHECK(failed.all().size() <= failures_kept + 1);
  }
  std::uint64_t counted = 0;
  for (const std::uint64_t count : counts.ulps) counted += count;
  CHECK(counted == hits);
  CHECK(hits > 0);
  CHECK(failing > 0);
}

TEST_CASE("every answer goes into a shard's digest, but not the words of a refusal") {
  const Profile profile = test::profile_of_all();
  const SuiteCase of = test::answered_case("generic", 0);
  const auto digest = [&](const Claims& claims) {
    ShardTally tally(two, 0, profile);
    tally.add(of, claims);
    return tally.shards("").counts.begin()->answers;
  };
  const Claims right = test::right_claims(of);
  const std::uint64_t of_right = digest(right);
  CHECK(of_right == digest(right));
  std::set<std::uint64_t> seen = {of_right};
  const auto hit = std::ranges::find(right, Claim::Outcome::hit, &Claim::outcome);
  REQUIRE(hit != right.end());
  const auto changed = [&](const auto& change) {
    Claims claims = right;
    change(claims[static_cast<std::size_t>(hit - right.begin())]);
    return digest(claims);
  };
  CHECK(seen.insert(changed([](Claim& claim) { claim.outcome = Claim::Outcome::miss; })).second);
  CHECK(seen.insert(changed([](Claim& claim) { claim.t = std::nextafter(*claim.t, 0); })).second);
  CHECK(seen.insert(changed([](Claim& claim) { claim.element.reset(); })).second);
  CHECK(seen.insert(changed([](Claim& claim) { claim.punto = glm::dvec3(1, 2, 3); })).second);
  CHECK(seen.insert(changed([](Claim& claim) { claim.punto = glm::dvec3(1, 2, 4); })).second);
  const auto refused = [](const char* why) { return [why](Claim& claim) { claim = {.why = why}; }; };
  CHECK(changed(refused("a")) == changed(refused("b")));
}

TEST_CASE("clauses that skip few rays, and long ones, are counted together") {
  Profile profile = test::profile_of_all();
  constexpr std::size_t rays = 4 * rays_of_a_case;
  ShardTally tally(two, 0, profile);
  for (std::uint64_t number = 0; number < rays / rays_of_a_case; ++number) {
    Claims claims;
    for (std::size_t ray = number * rays_of_a_case; claims.size() < rays_of_a_case; ++ray)
      claims.push_back({.why = "reason " + std::to_string(ray < 40 ? ray % 4 : ray)});
    if (claims.back().why == "reason 63") claims.back().why = std::string(300, 'x');
    tally.add(test::answered_case("generic", number), claims);
  }
  const Shards shards = tally.shards("");
  const ShardCounts& counts = *shards.counts.begin();
  CHECK(counts.clauses.size() == clauses_kept + 1);
  CHECK(std::ranges::is_sorted(counts.clauses));
  CHECK(counts.clauses.back() == other_clauses);
  CHECK(std::ranges::count(counts.clauses, "no answer: reason 3") == 1);
  REQUIRE(counts.families.size() == 1);
  CHECK(counts.families[0].verdicts.empty());
  CHECK(counts.families[0].clauses[0] == 10);
  CHECK(counts.families[0].clauses.back() == rays - 40 - (clauses_kept - 4));
  CHECK(text_of(read(text_of(shards))) == text_of(shards));
}

TEST_CASE("of rays that failed in one way the worst and those of least hash are kept, whatever their order") {
  std::vector<FailedRay> rays;
  for (std::uint64_t number = 0; number < 40; ++number)
    rays.push_back({.number = number, .ray = 5, .elements = 2 + number % 3, .backward = 100});
  for (std::uint64_t number = 40; number < 50; ++number)
    rays.push_back({.number = number, .ray = 5, .elements = 1, .backward = 50});
  FailedRays forth, back;
  for (const FailedRay& ray : rays) {
    if (forth.may_keep(ray)) forth.add(ray);
  }
  for (auto ray = rays.rbegin(); ray != rays.rend(); ++ray) back.add(*ray);
  CHECK(forth.all() == back.all());
  CHECK(forth.worst().number == 0);
  CHECK(back.worst().number == 0);
  CHECK(forth.all().size() >= failures_kept);
  std::uint64_t sum = 0;
  for (const FailedRay& ray : forth.all()) sum += ray.number;
  CHECK(sum > 8 * 10);  // they are not the first ones
}

TEST_CASE("a file of shards is read as it was written") {
  for (const Shards& shards : {blind_shard(0), united(blind_shard(7), blind_shard(2)), Shards{}}) {
    const std::string text = text_of(shards);
    const Shards again = read(text);
    CHECK(again.says == shards.says);
    CHECK(again.counts == shards.counts);
    CHECK(text_of(again) == text);
  }
}

TEST_CASE("shards put together are the same in any order, any grouping, and given again") {
  test::property("laws", [] {
    const Shards a = *any_shards(), b = *any_shards(), c = *any_shards();
    RC_ASSERT(text_of(united(a, b)) == text_of(united(b, a)));
    RC_ASSERT(text_of(united(united(a, b), c)) == text_of(united(a, united(b, c))));
    RC_ASSERT(text_of(united(a, a)) == text_of(a));
    RC_ASSERT(text_of(united(a, Shards{})) == text_of(a));
    RC_ASSERT(text_of(read(text_of(a))) == text_of(a));
    RC_ASSERT(united(a, b).counts.size() >= std::max(a.counts.size(), b.counts.size()));
  });
}

TEST_CASE("shards of another version of the system are not put together") {
  Shards one = blind_shard(0), other = blind_shard(1);
  other.says = "tested 2";
  CHECK_THROWS_WITH(united(one, other), "of \"tested 2\"; expected \"tested 1\", as the others");
  other.says.clear();
  CHECK(united(one, other).says == "tested 1");
  CHECK(united(other, one).says == "tested 1");
}

TEST_CASE("a file of shards with any bit flipped, cut anywhere, or of another campaign is refused") {
  const std::string text = text_of(blind_shard(0));
  REQUIRE(text.size() > 500);
  REQUIRE(refusal(text) == "nothing is wrong");
  std::size_t accepted = 0;
  for (std::size_t bit = 0; bit < 8 * text.size(); ++bit) {
    std::string flipped = text;
    flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << bit % 8));
    accepted += refusal(flipped) == "nothing is wrong";
  }
  CHECK(accepted == 0);
  for (std::size_t size = 0; size < text.size(); ++size)
    accepted += refusal(text.substr(0, size)) == "nothing is wrong";
  CHECK(accepted == 0);
  CHECK(refusal(text + "\n")
            .find("the file is truncated or was altered; expected the digest of what stands before it: ") !=
        std::string::npos);
  CHECK(refusal("") == "s.json:1:1: no file of shards; expected what durero conform shard or merge writes");
  const std::string foreign = shards_text(blind_shard(0), two, "fedcba9876543210");
  CHECK(refusal(foreign) ==
        "s.json:1:50: shards of another campaign, or of a system with another profile: \"fedcba9876543210\"; "
        "expected those of \"0123456789abcdef\"");
  Campaign shorter = two;
  shorter.shards = 3;
  CHECK_NOTHROW(read_shards({"s", text_of(blind_shard(2))}, shorter, name_of_campaign));
  CHECK_THROWS_WITH(read_shards({"s", text_of(blind_shard(3))}, shorter, name_of_campaign),
                    Catch::Contains("shard is 3; expected less than 3"));
}

TEST_CASE("two different contents of one shard are both kept") {
  Shards other = blind_shard(0);
  ShardCounts counts = *other.counts.begin();
  ++counts.answers;
  other.counts = {counts};
  const Shards both = united(blind_shard(0), other);
  CHECK(both.counts.size() == 2);
  CHECK(text_of(read(text_of(both))) == text_of(both));
}

TEST_CASE("a campaign of 10^12 rays has less than 140 MB") {
  // What a shard of 2^25 rays has where a system fails in every way in every family, skips by many clauses, and is off
  // by any number of ulps.
  ShardCounts counts{.shard = 29999, .answers = ~std::uint64_t{0}};
  counts.ulps.assign(ulp_bins, 123456);
  for (std::size_t i = 0; i < 8; ++i)
    counts.clauses.push_back("coordinates of centres and of origins up to " + std::to_string(i));
  counts.families.assign(families().size(),
                         {{500000, 400000, 30000, 9000, 9000, 900, 900, 9000, 20, 9, 2}, {9000, 900}});
  Shards shards{.counts = {counts}};
  Campaign campaign = campaign_of({}, 30000);
  for (const Family& family : families()) campaign.families.push_back(&family);
  const std::size_t one = shards_text(shards, campaign, name_of_campaign).size();
  --counts.shard;
  shards.counts.insert(counts);
  const std::size_t of_a_shard = shards_text(shards, campaign, name_of_campaign).size() - one;
  CHECK(30000 * of_a_shard < 140'000'000);
}

TEST_CASE("ten thousand empty shards are put together at once") { merge_empty_shards(10'000, 20); }
TEST_CASE("a million empty shards are put together within a minute", "[long]") { merge_empty_shards(1'000'000, 60); }
