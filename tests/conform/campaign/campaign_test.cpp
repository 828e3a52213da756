#include "durero/conform/campaign/campaign.hpp"

#include <map>
#include <set>

#include "conform/judged.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::conform;

namespace {

const std::string least =
    R"({"format":"durero-campaign","version":1,"system":"embree","seed":3,"rays_of_a_shard":1000,"shards":7})";

const std::string whole = R"({"format":"durero-campaign","version":1,"system":"embree","seed":3,"rays_of_a_shard":1000,
"shards":7,"families":["tiny","generic"],"types":["esfera","cono"],"solids":true,"numbers":"binary64","time":0.5})";

const std::string of_program = R"({"format":"durero-campaign","version":1,"system":"command:./ask","profile":"p.json",
"seed":3,"rays_of_a_shard":1000,"shards":7})";

Campaign read(const std::string& text) { return read_campaign({"c.json", text}); }

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  REQUIRE(text.find(what) != text.npos);
  return text.replace(text.find(what), what.size(), with);
}

std::string refusal(const std::string& text, const std::string& what, const std::string& with) {
  try {
    read(replaced(text, what, with));
  } catch (const io::InputError& error) {
    return error.what();
  }
  return "nothing is wrong";
}

}  // namespace

TEST_CASE("a campaign is read") {
  const Campaign campaign = read(whole);
  CHECK(campaign.system == "embree");
  CHECK(campaign.profile.empty());
  CHECK(campaign.seed == 3);
  CHECK(campaign.rays_of_a_shard == 1000);
  CHECK(campaign.shards == 7);
  CHECK(campaign.families == std::vector{find_family("generic"), find_family("tiny")});
  CHECK(campaign.tipos == std::vector{model::Tipo::soy_esfera, model::Tipo::soy_cono});
  CHECK(campaign.caps == Caps::solid);
  CHECK(campaign.numbers == NumberFormat::binary64);
  CHECK(campaign.time == 0.5);
  CHECK(read(of_program).profile == "p.json");
}

TEST_CASE("a campaign that says the least asks all families what the system's profile claims") {
  const Campaign campaign = read(least);
  CHECK(campaign.families.size() == families().size());
  CHECK(campaign.time == 10);
  Profile profile = test::profile_of_all();
  profile.tipos = {model::Tipo::soy_disco};
  profile.caps = Caps::solid;
  const SuiteOptions options = suite_options(campaign, profile);
  CHECK(options.tipos == profile.tipos);
  CHECK(options.caps == Caps::solid);
  CHECK(options.numbers == NumberFormat::binary32);
  CHECK(options.seed == 3);
  const SuiteOptions of_whole = suite_options(read(whole), test::profile_of_all());
  CHECK(of_whole.tipos.size() == 2);
  CHECK(of_whole.caps == Caps::solid);
  CHECK(of_whole.numbers == NumberFormat::binary64);
}

TEST_CASE("a campaign asks another question of a system that claims it, and is another by that") {
  Profile profile = test::profile_of_all();
  const std::string of_all = replaced(whole, "0.5", "0.5,\"question\":\"all\"");
  const Campaign campaign = read(of_all);
  CHECK(read(whole).question == QuestionKind::first);
  CHECK(campaign.question == QuestionKind::all);
  CHECK_THROWS_WITH(suite_options(campaign, profile),
                    "tested does not claim the question all; expected one of its profile's questions");
  const std::string of_first = identity(read(whole), profile);
  profile.questions = {QuestionKind::first, QuestionKind::all};
  CHECK(identity(read(whole), profile) == of_first);
  CHECK(identity(campaign, profile) != of_first);
  const SuiteOptions options = suite_options(campaign, profile);
  const SuiteCase of = suite_case(options, cases_of_shard(campaign, options, 0).front());
  CHECK(of.question == QuestionKind::all);
  CHECK(of.truths.size() == of.the_case.rays.size());
  CHECK(std::ranges::any_of(of.truths, [](const ExactAnswer& truth) { return truth.all.size() > 1; }));
}

TEST_CASE("what is wrong in a campaign is said at its place") {
  CHECK(refusal(whole, "embree", "embree4") == "nothing is wrong");
  CHECK(refusal(whole, "durero-campaign", "durero-suite") ==
        "c.json:1:11: format is \"durero-suite\"; expected \"durero-campaign\"");
  CHECK(refusal(whole, "\"version\":1", "\"version\":2") ==
        "c.json:1:39: version 2 of durero-campaign; expected 1 (written by a newer durero?)");
  CHECK(refusal(whole, "\"embree\"", "\"\"") == "c.json:1:50: system is empty; expected some text");
  CHECK(refusal(whole, "\"seed\":3", "\"seed\":-3") == "c.json:1:66: seed is -3; expected a whole number up to 2^53");
  CHECK(refusal(whole, ":1000", ":0.5") == "c.json:1:86: rays_of_a_shard is 0.5; expected a whole number up to 2^53");
  CHECK(refusal(whole, ":1000", ":0") == "nothing is wrong");
  CHECK(refusal(whole, "\"shards\":7", "\"shards\":0") == "c.json:2:10: shards is 0; expected one at least");
  CHECK(refusal(whole, "\"shards\":7", "\"shards\":9007199254741") ==
        "c.json:2:10: 9007199254741 shards of 1000 rays; expected 2^53 rays at most");
  CHECK(refusal(whole, "\"shards\":7", "\"shards\":9007199254740") == "nothing is wrong");
  CHECK(refusal(whole, "\"tiny\"", "\"minute\"") ==
        "c.json:2:24: a family is \"minute\"; expected one that durero conform list shows");
  CHECK(refusal(whole, "\"tiny\"", "\"generic\"") ==
        "c.json:2:34: family \"generic\" stands twice; expected each once");
  CHECK(refusal(whole, "[\"tiny\",\"generic\"]", "[]") ==
        "c.json:2:23: families is empty; expected one at least, or no key families");
  CHECK(refusal(whole, "\"cono\"", "\"cubo\"").starts_with("c.json:2:60: a tipo is \"cubo\"; expected one of esfera"));
  CHECK(refusal(whole, "true", "1").starts_with("c.json:2:77: solids is a number"));
  CHECK(refusal(whole, "binary64", "binary16") ==
        "c.json:2:92: numbers is \"binary16\"; expected one of binary32, binary64");
  CHECK(refusal(whole, "0.5", "0") == "c.json:2:110: time is 0; expected seconds, from 0.001 to 86400");
  CHECK(refusal(whole, "0.5", "1e6").starts_with("c.json:2:110: time is 1000000; expected seconds"));
  CHECK(refusal(whole, "\"time\"", "\"times\"").starts_with("c.json:2:103: unknown key \"times\" in a campaign"));
  CHECK(refusal(whole, "\"shards\":7,", "").find("shards") != std::string::npos);
  CHECK(refusal(whole, "\"seed\":3,", "").find("seed") != std::string::npos);
  CHECK(refusal(of_program, "\"profile\":\"p.json\",", "") ==
        "c.json:1:50: command: without profile; expected the key profile, which says what it claims");
  CHECK(refusal(of_program, "command:./ask", "embree") ==
        "c.json:1:69: profile of a system that has one; expected it with system command:PROGRAM alone");
}

TEST_CASE("a campaign's identity is that of what it says and of what the system claims, however it is written") {
  const Profile profile = test::profile_of_all();
  const std::string of_whole = identity(read(whole), profile);
  CHECK(of_whole.size() == 16);
  CHECK(identity(read(replaced(replaced(whole, "\"time\":0.5", "\"time\":5e-1"), "\"tiny\",\"generic\"",
                               "\"generic\", \"tiny\"")),
                 profile) == of_whole);
  CHECK(identity(read(replaced(whole, "\"shards\":7", "\"shards\":8")), profile) == of_whole);
  std::set<std::string> others = {of_whole};
  const std::pair<std::string, std::string> changes[] = {
      {"embree", "ode"},   {"\"seed\":3", "\"seed\":4"}, {"1000", "1001"},         {"tiny", "tie"},
      {"\"esfera\",", ""}, {"\"solids\":true,", ""},     {"binary64", "binary32"}, {"0.5", "0.25"}};
  for (const auto& [what, with] : changes)
    CHECK(others.insert(identity(read(replaced(whole, what, with)), profile)).second);
  Profile narrow = profile;
  narrow.greatest_t = 1e6;
  CHECK(others.insert(identity(read(whole), narrow)).second);
  narrow.sources = {{"greatest_t", "No ray is longer than 1e6.", "manual"}};
  CHECK_FALSE(others.insert(identity(read(whole), narrow)).second);  // where it is claimed changes no verdict
}

TEST_CASE("every ray of a campaign is in one shard, and a shard has as many as the campaign says") {
  for (const std::uint64_t rays : {0, 1, 2, 3, 64, 129, 1000}) {
    Campaign campaign = read(whole);
    campaign.rays_of_a_shard = rays;
    const SuiteOptions options = suite_options(campaign, test::profile_of_all());
    std::set<std::pair<const Family*, std::uint64_t>> seen;
    for (std::uint64_t shard = 0; shard < campaign.shards; ++shard) {
      std::map<const Family*, std::uint64_t> of_family;
      for (const CasePlace& place : cases_of_shard(campaign, options, shard)) {
        CHECK(seen.insert({place.family, place.number}).second);
        CHECK(place.rays > 0);
        CHECK(place.rays <= rays_of_a_case);
        of_family[place.family] += place.rays;
      }
      CHECK(of_family[campaign.families[0]] == (rays + 1) / 2);
      CHECK(of_family[campaign.families[1]] == rays / 2);
    }
    for (const auto& [family, number] : seen) CHECK((number == 0 || seen.contains({family, number - 1})));
  }
}

TEST_CASE("the first shards of a campaign are those of a longer one, and a family without scenes has no cases") {
  Campaign campaign = read(replaced(least, "\"shards\":7", "\"shards\":9007199254740"));
  campaign.tipos = {model::Tipo::soy_esfera};
  const SuiteOptions options = suite_options(campaign, test::profile_of_all());
  const std::vector<CasePlace> last = cases_of_shard(campaign, options, campaign.shards - 1);
  REQUIRE_FALSE(last.empty());
  CHECK(std::ranges::none_of(last, [](const CasePlace& place) { return place.family == find_family("apex"); }));
  CHECK(last.front().number == 2 * (campaign.shards - 1));  // 28 rays of a family are two cases
  Campaign shorter = campaign;
  shorter.shards = 4;
  CHECK(cases_of_shard(shorter, options, 3) == cases_of_shard(campaign, options, 3));
}

TEST_CASE("a case of a shard is that which its name makes again, up to its last ray") {
  const Campaign campaign = read(whole);
  const SuiteOptions options = suite_options(campaign, test::profile_of_all());
  for (const CasePlace& place : cases_of_shard(campaign, options, 6)) {
    const SuiteCase of = suite_case(options, place);
    SuiteOptions of_all = options;
    of_all.rays = (place.number + 1) * rays_of_a_case;
    const SuiteCase named = suite_case(of_all, *place.family, place.number);
    REQUIRE(of.the_case.rays.size() == place.rays);
    CHECK(of.name() == named.name());
    for (std::size_t ray = 0; ray < place.rays; ++ray)
      CHECK(of.the_case.rays[ray].rayo == named.the_case.rays[ray].rayo);
  }
  const SuiteCase far = suite_case(options, {find_family("generic"), 123456789012, 1});
  CHECK(far.name() == "generic/123456789012");
  CHECK(far.the_case.rays.size() == 1);
}
