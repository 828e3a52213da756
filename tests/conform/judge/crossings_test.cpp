// The judgement on all hits of a ray, and on their number.
#include <cmath>
#include <set>

#include "conform/drafted.hpp"
#include "conform/judged.hpp"
#include "durero/conform/judge/explaining_data.hpp"
#include "durero/conform/judge/fuzz.hpp"
#include "durero/conform/judge/judge.hpp"
#include "durero/conform/judge/minimise.hpp"
#include "durero/conform/judge/trait.hpp"
#include "durero/surface/exact.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::conform;
using Outcome = Claim::Outcome;

namespace {

constexpr QuestionKind both[] = {QuestionKind::all, QuestionKind::count};

SuiteCase asked(SuiteCase of, QuestionKind question) {
  of.question = question;
  answer(of);
  return of;
}

/// A ball of radius 1 around (0, 0, 4), asked from p along z for all hits: from (0, 0, 0) at t = 3 and t = 5.
SuiteCase ball(const glm::dvec3& p = {0, 0, 0}) { return asked(test::sphere_case(p, {0, 0, 1}), QuestionKind::all); }

/// A hit of a list.
struct Listed {
  scene::ElementRef element;
  double t;
};
constexpr scene::ElementRef the_ball{scene::Sphere::tipo, 0};

Claim claim_of(const std::vector<Listed>& list) {
  if (list.empty()) return {.outcome = Outcome::miss};
  std::vector<Claim> all;
  for (const auto& [element, t] : list) all.push_back({.outcome = Outcome::hit, .element = element, .t = t});
  Claim first = all.front();
  first.behind.assign(all.begin() + 1, all.end());
  return first;
}

Claim of_ball(const std::vector<double>& ts) {
  std::vector<Listed> list;
  for (const double t : ts) list.push_back({the_ball, t});
  return claim_of(list);
}

Claim count_of(std::uint64_t count) { return {.outcome = count > 0 ? Outcome::hit : Outcome::miss, .count = count}; }

Verdict verdict(const SuiteCase& of, const Claim& claim, const Profile& profile = test::profile_of_all()) {
  return judge(of, 0, claim, profile).verdict;
}

/// All crossings by exact arithmetic, element by element, without the trees of the judge; nothing where one is a
/// stretch.
std::optional<std::vector<Listed>> all_met(const SuiteCase& of, std::size_t ray) {
  std::vector<Listed> all;
  for (const auto& [element, segment] : surface::exact::all_hits(of.the_case.scene, of.the_case.rays[ray].rayo)) {
    if (!segment.begin || !segment.end || *segment.begin != *segment.end) return std::nullopt;
    all.push_back({element, number::round_to_binary64(*segment.begin)});
  }
  return all;
}

using Fault = void (*)(std::vector<Listed>&);

void merge(std::vector<Listed>& list, double apart, bool only_of_one_element) {
  std::vector<Listed> kept;
  for (const Listed& hit : list) {
    const bool is_merged =
        !kept.empty() && hit.t - kept.back().t <= apart && (!only_of_one_element || hit.element == kept.back().element);
    if (!is_merged) kept.push_back(hit);
  }
  list = kept;
}

/// A fault of a tracer that lists all hits.
struct ListFault {
  const char* name;
  Fault plant;
  std::size_t least_of_lists;   ///< so many failures at least
  std::size_t least_of_counts;  ///< of its counts
};

const ListFault list_faults[] = {
    {"drops the last",
     [](auto& list) {
       if (!list.empty()) list.pop_back();
     },
     500, 500},
    {"drops the first",
     [](auto& list) {
       if (!list.empty()) list.erase(list.begin());
     },
     500, 500},
    {"drops the second",
     [](auto& list) {
       if (list.size() > 1) list.erase(list.begin() + 1);
     },
     500, 500},
    {"stops after two",
     [](auto& list) {
       list.resize(std::min<std::size_t>(list.size(), 2), {the_ball, 0});
     },
     50, 50},
    {"says each twice",
     [](auto& list) {
       std::vector<Listed> twice;
       for (const Listed& hit : list) twice.insert(twice.end(), 2, hit);
       list = twice;
     },
     500, 500},
    {"says the last twice",
     [](auto& list) {
       if (!list.empty()) list.push_back(list.back());
     },
     500, 500},
    {"says the farthest first", [](auto& list) { std::reverse(list.begin(), list.end()); }, 300, 0},
    {"sorts by the element",
     [](auto& list) {
       std::stable_sort(list.begin(), list.end(), [](auto a, auto b) { return a.element < b.element; });
     },
     50, 0},
    {"merges what is nearer than 0.001", [](auto& list) { merge(list, 1e-3, false); }, 50, 50},
    {"merges what is nearer than 10^-6", [](auto& list) { merge(list, 1e-6, false); }, 20, 20},
    {"merges what is at one t", [](auto& list) { merge(list, 0, false); }, 5, 5},
    {"begins behind 0.001", [](auto& list) { std::erase_if(list, [](auto hit) { return hit.t < 1e-3; }); }, 20, 20},
    {"goes on 0.001 behind each hit",
     [](auto& list) {
       std::vector<Listed> kept;
       for (const Listed& hit : list)
         if (kept.empty() || hit.t > kept.back().t + 1e-3) kept.push_back(hit);
       list = kept;
     },
     50, 50},
    {"says one hit of an element alone",
     [](auto& list) {
       std::set<scene::ElementRef> seen;
       std::erase_if(list, [&](auto hit) { return !seen.insert(hit.element).second; });
     },
     500, 500},
    {"says the first t for each",
     [](auto& list) {
       for (auto& hit : list) hit.t = list.front().t;
     },
     300, 0},
    {"is off by 0.0001",
     [](auto& list) {
       for (auto& hit : list) hit.t *= 1.0001;
     },
     500, 0},
    {"names the first element alone",
     [](auto& list) {
       for (auto& hit : list) hit.element = list.front().element;
     },
     50, 0},
};

struct Judged {
  std::size_t lists = 0, failures = 0, counts_failing = 0;
};

/// A tracer with that fault, or a right one, on the rays of some scenes of each family.
Judged judged(Fault plant) {
  Judged sum;
  const Profile profile = test::profile_of_all();
  for (const Family& family : families_of_few()) {
    for (const SuiteCase& of : test::asked_cases(family, QuestionKind::all, NumberFormat::binary32, 4)) {
      const CaseJudge of_lists(of, profile);
      SuiteCase counted = of;
      counted.question = QuestionKind::count;
      const CaseJudge of_counts(counted, profile);
      for (std::size_t ray = 0; ray < of.truths.size(); ++ray) {
        auto all = all_met(of, ray);
        if (!all) continue;
        if (plant != nullptr) plant(*all);
        ++sum.lists;
        sum.failures += is_failure(of_lists.judge(ray, claim_of(*all)).verdict);
        sum.counts_failing += is_failure(of_counts.judge(ray, count_of(all->size())).verdict);
      }
    }
  }
  return sum;
}

}  // namespace

TEST_CASE("a list of all hits has each crossing once, in order") {
  CHECK(verdict(ball(), of_ball({3, 5})) == Verdict::exact);
  CHECK(verdict(ball(), of_ball({3, std::nextafter(5, 6)})) == Verdict::right);
  CHECK(verdict(ball(), of_ball({5, 3})) == Verdict::unsorted);
  CHECK(verdict(ball(), of_ball({3})) == Verdict::missed);
  CHECK(verdict(ball(), of_ball({5})) == Verdict::missed);
  CHECK(verdict(ball(), of_ball({})) == Verdict::missed);
  CHECK(verdict(ball(), of_ball({3, 3, 5})) == Verdict::doubled);
  CHECK(verdict(ball(), of_ball({3, 3})) == Verdict::missed);
  CHECK(verdict(ball(), of_ball({5, 5})) == Verdict::missed);
  CHECK(verdict(ball(), of_ball({3, 5, 5})) == Verdict::doubled);
  CHECK(verdict(ball(), of_ball({3, 4, 5})) == Verdict::misplaced);
  CHECK(verdict(ball(), of_ball({3, 5.0001})) == Verdict::off);
  CHECK(verdict(ball(), of_ball({3.0001, 5})) == Verdict::off);
  CHECK(verdict(ball(), of_ball({3.0001})) == Verdict::missed);
  CHECK(verdict(ball(), of_ball({3, 5, std::nan("")})) == Verdict::non_finite);
  CHECK(verdict(ball({0, 0, 10}), of_ball({})) == Verdict::exact);
  CHECK(verdict(ball({0, 0, 10}), of_ball({3})) == Verdict::phantom);
  CHECK(verdict(ball({0, 0, 4}), of_ball({1})) == Verdict::exact);
  CHECK(verdict(ball({0, 0, 4}), of_ball({1, 1})) == Verdict::doubled);
}

TEST_CASE("a number of hits is right where some data within the declared error have it") {
  const auto of_count = [](const glm::dvec3& p, std::uint64_t count) {
    return verdict(asked(ball(p), QuestionKind::count), count_of(count));
  };
  CHECK(of_count({0, 0, 0}, 2) == Verdict::exact);
  CHECK(of_count({0, 0, 0}, 1) == Verdict::wrong_count);
  CHECK(of_count({0, 0, 0}, 0) == Verdict::wrong_count);
  CHECK(of_count({0, 0, 0}, 3) == Verdict::wrong_count);
  CHECK(of_count({0, 0, 4}, 1) == Verdict::exact);
  CHECK(of_count({0, 0, 4}, 2) == Verdict::wrong_count);
  CHECK(of_count({0, 0, 4}, 0) == Verdict::wrong_count);
  CHECK(of_count({0, 0, 10}, 0) == Verdict::exact);
  CHECK(of_count({0, 0, 10}, 1) == Verdict::wrong_count);
  CHECK(of_count({1, 0, 0}, 1) == Verdict::exact);
  CHECK(of_count({1, 0, 0}, 0) == Verdict::right);
  CHECK(of_count({1, 0, 0}, 2) == Verdict::right);
  CHECK(of_count({1, 0, 0}, 3) == Verdict::wrong_count);
  CHECK(judge(asked(ball(), QuestionKind::count), 0, of_ball({3, 5}), test::profile_of_all()).clause ==
        "no answer: no count");
}

TEST_CASE("a tangent is a hit, two, or none") {
  const SuiteCase tangent = ball({1, 0, 0});
  CHECK(verdict(tangent, of_ball({4})) == Verdict::exact);
  CHECK(verdict(tangent, of_ball({})) == Verdict::right);
  CHECK(verdict(tangent, of_ball({4, 4})) == Verdict::right);
  CHECK(verdict(tangent, of_ball({4, 4, 4})) == Verdict::doubled);
  const SuiteCase beside = ball({1 + 0x1p-40, 0, 0});
  CHECK(verdict(beside, of_ball({})) == Verdict::exact);
  CHECK(verdict(beside, of_ball({4})) != Verdict::exact);
}

TEST_CASE("a hit finds room at its own crossing alone, where another may be missed by a rim") {
  const scene::Cylinder open{glm::dvec3(0, 0, 0), 1, glm::dvec3(0, 0, 1), 2};
  const scene::ElementRef wall{scene::Cylinder::tipo, 0};
  const SuiteCase leaves = asked(test::drafted({{"e0", open}}, {0, -3, 0}, {0, 2, 1}), QuestionKind::all);
  CHECK(verdict(leaves, claim_of({{wall, 1}, {wall, 2}})) == Verdict::exact);
  CHECK(verdict(leaves, claim_of({{wall, 1}})) == Verdict::right);
  CHECK(verdict(leaves, claim_of({{wall, 1}, {wall, 1}})) == Verdict::doubled);
  const SuiteCase enters = asked(test::drafted({{"e0", open}}, {0, -3, 3}, {0, 2, -1}), QuestionKind::all);
  CHECK(verdict(enters, claim_of({{wall, 1}, {wall, 2}})) == Verdict::exact);
  CHECK(verdict(enters, claim_of({{wall, 2}})) == Verdict::right);
  CHECK(verdict(enters, claim_of({{wall, 2}, {wall, 2}})) == Verdict::doubled);
}

TEST_CASE("hits of several elements at one t are all there, in any order") {
  const scene::ElementRef second{scene::Sphere::tipo, 1};
  const SuiteCase two = asked(
      test::drafted({{"e0", scene::Sphere{glm::dvec3(0, 0, 4), 1}}, {"e1", scene::Sphere{glm::dvec3(0, 0, 5), 2}}},
                    {0, 0, 0}, {0, 0, 1}),
      QuestionKind::all);
  CHECK(verdict(two, claim_of({{the_ball, 3}, {second, 3}, {the_ball, 5}, {second, 7}})) == Verdict::exact);
  CHECK(verdict(two, claim_of({{second, 3}, {the_ball, 3}, {the_ball, 5}, {second, 7}})) == Verdict::exact);
  CHECK(verdict(two, claim_of({{the_ball, 3}, {the_ball, 5}, {second, 7}})) == Verdict::missed);
  CHECK(verdict(two, claim_of({{the_ball, 3}, {the_ball, 3}, {the_ball, 5}, {second, 7}})) == Verdict::missed);
  Profile nameless = test::profile_of_all();
  nameless.names_elements = false;
  Claim claim = claim_of({{the_ball, 3}, {second, 3}, {the_ball, 5}, {second, 7}});
  claim.element.reset();
  for (Claim& behind : claim.behind) behind.element.reset();
  CHECK(verdict(two, claim, nameless) == Verdict::exact);
  claim.behind.erase(claim.behind.begin());
  CHECK(verdict(two, claim, nameless) == Verdict::missed);
  claim.behind.insert(claim.behind.begin(), 2, Claim{.outcome = Outcome::hit, .t = 3});
  CHECK(verdict(two, claim, nameless) == Verdict::doubled);
}

TEST_CASE("a list whose hits have no place is right where its elements are met so often") {
  Claim alone = of_ball({3, 5});
  alone.t.reset();
  alone.behind[0].t.reset();
  CHECK(verdict(ball(), alone) == Verdict::right);
  alone.behind.clear();
  CHECK(verdict(ball(), alone) == Verdict::missed);
  CHECK(verdict(ball({0, 0, 10}), alone) == Verdict::phantom);
  alone.behind.assign(2, alone);
  CHECK(verdict(ball(), alone) == Verdict::doubled);
}

TEST_CASE("all hits of a ray from inside a solid are what the profile says") {
  const SuiteCase inside = ball({0, 0, 4});
  Profile profile = test::profile_of_all();
  profile.inside = Inside::nothing;
  CHECK(verdict(inside, of_ball({}), profile) == Verdict::right);
  CHECK(verdict(inside, of_ball({1}), profile) == Verdict::exact);
  profile.inside = Inside::origin;
  CHECK(verdict(inside, of_ball({0, 1}), profile) == Verdict::right);
  CHECK(verdict(inside, of_ball({0}), profile) == Verdict::right);
  CHECK(verdict(inside, of_ball({0, 0, 1}), profile) == Verdict::doubled);
  const SuiteCase counted = asked(inside, QuestionKind::count);
  CHECK(verdict(counted, count_of(2), profile) == Verdict::right);
  CHECK(verdict(counted, count_of(3), profile) == Verdict::wrong_count);
}

TEST_CASE("hits beyond a limit of the profile need not be listed") {
  Profile profile = test::profile_of_all();
  profile.greatest_t = 4;
  CHECK(verdict(ball(), of_ball({3}), profile) == Verdict::right);
  CHECK(verdict(ball(), of_ball({3, 5}), profile) == Verdict::exact);
  CHECK(verdict(asked(ball(), QuestionKind::count), count_of(1), profile) == Verdict::right);
  CHECK(verdict(asked(ball(), QuestionKind::count), count_of(0), profile) == Verdict::wrong_count);
}

TEST_CASE("what hits of a list say besides is judged as that of a first hit") {
  Profile profile = test::profile_of_all();
  profile.normal = NormalSide::outward;
  Claim claim = of_ball({3, 5});
  claim.normal = {0, 0, -1};
  claim.behind[0].normal = {0, 0, 1};
  CHECK(verdict(ball(), claim, profile) == Verdict::exact);
  claim.behind[0].normal = {0, 0, -1};
  CHECK(verdict(ball(), claim, profile) == Verdict::wrong_normal);
}

TEST_CASE("a stretch in a surface is hit at its ends, or anywhere between, or not at all") {
  const scene::ElementRef disc{scene::Disc::tipo, 0};
  const SuiteCase along =
      asked(test::drafted({{"e0", scene::Disc{glm::dvec3(0, 0, 4), 1, glm::dvec3(0, 1, 0)}}}, {0, 0, 0}, {0, 0, 1}),
            QuestionKind::all);
  CHECK(along.truths[0].all.size() == 2);
  CHECK(verdict(along, claim_of({{disc, 3}, {disc, 5}})) == Verdict::exact);
  CHECK(verdict(along, claim_of({{disc, 3}})) == Verdict::right);
  CHECK(verdict(along, claim_of({{disc, 4}})) == Verdict::right);
  CHECK(verdict(along, claim_of({})) == Verdict::right);
  CHECK(verdict(along, claim_of({{disc, 3}, {disc, 4}, {disc, 5}})) == Verdict::doubled);
}

TEST_CASE("a flat element is met once, also at its edge, where its crossing is not certain") {
  const scene::ElementRef flat{scene::Triangle::tipo, 0};
  const scene::Triangle triangle{{glm::dvec3(0, -1, 4), glm::dvec3(0, 1, 4), glm::dvec3(1, 0, 4)}};
  const SuiteCase edge = asked(test::drafted({{"e0", triangle}}, {0, 0, 0}, {0, 0, 1}), QuestionKind::all);
  CHECK(verdict(edge, claim_of({{flat, 4}})) == Verdict::exact);
  CHECK(verdict(edge, claim_of({})) == Verdict::right);
  CHECK(verdict(edge, claim_of({{flat, 4}, {flat, 4}})) == Verdict::doubled);
  CHECK(verdict(asked(edge, QuestionKind::count), count_of(0)) == Verdict::right);
  CHECK(verdict(asked(edge, QuestionKind::count), count_of(2)) == Verdict::wrong_count);
}

TEST_CASE("a watertight system hits the closed mesh around the origin, also by an edge") {
  Profile profile = test::profile_of_all();
  profile.watertight = true;
  const glm::dvec3 a(-1, -1, -1), b(3, -1, -1), c(-1, 3, -1), d(-1, -1, 3), p(-0.5, -0.5, -0.5);
  const SuiteCase of = asked(test::drafted({{"f0", scene::Triangle{{a, c, b}}},
                                            {"f1", scene::Triangle{{a, b, d}}},
                                            {"f2", scene::Triangle{{a, d, c}}},
                                            {"f3", scene::Triangle{{b, c, d}}}},
                                           p, (b + c) / 2.0 - p),
                             QuestionKind::all);
  REQUIRE(of.truths[0].all.size() == 2);
  const auto& all = of.truths[0].all;
  const Claim one = claim_of({{all[0].elementos[0], all[0].t}});
  CHECK(verdict(of, one, profile) == Verdict::right);
  CHECK(verdict(of, claim_of({}), profile) == Verdict::missed);
  CHECK(verdict(of, claim_of({})) == Verdict::right);
  CHECK(verdict(asked(of, QuestionKind::count), count_of(0), profile) == Verdict::wrong_count);
  CHECK(verdict(asked(of, QuestionKind::count), count_of(0)) == Verdict::right);
}

TEST_CASE("lists and counts of a right tracer are right, and faults of either are seen") {
  const Judged right = judged(nullptr);
  CHECK(right.lists > 2000);
  CHECK(right.failures == 0);
  CHECK(right.counts_failing == 0);
  for (const ListFault& fault : list_faults) {
    const Judged wrong = judged(fault.plant);
    INFO(fault.name << ": " << wrong.failures << " lists, " << wrong.counts_failing << " counts of " << wrong.lists);
    CHECK(wrong.failures >= fault.least_of_lists);
    CHECK(wrong.counts_failing >= fault.least_of_counts);
    if (fault.least_of_counts == 0) CHECK(wrong.counts_failing == 0);
  }
}

TEST_CASE("lists and counts of meshes are right or not by every face") {
  const Profile profile = test::profile_of_all();
  std::size_t failing = 0, counts = 0;
  for (const Family& family : families_of_meshes()) {
    for (const SuiteCase& of : test::asked_cases(family, QuestionKind::all, NumberFormat::binary32, 1)) {
      const CaseJudge judge(of, profile);
      for (std::size_t ray = 0; ray < of.truths.size(); ray += 8) {
        auto all = all_met(of, ray);
        if (!all) continue;
        INFO(of.name() << " ray " << ray);
        CHECK(judge.judge(ray, claim_of(*all)).verdict == Verdict::exact);
        if (all->size() < 2) continue;
        all->erase(all->begin() + 1);
        failing += is_failure(judge.judge(ray, claim_of(*all)).verdict);
        const SuiteCase counted = asked(with_ray_alone(of, ray), QuestionKind::count);
        counts += is_failure(verdict(counted, count_of(all->size())));
      }
    }
  }
  CHECK(failing > 50);
  CHECK(counts > 50);
}

TEST_CASE("a failing list or count is made small, its cause is found, and how far its data are off at least") {
  const Profile profile = test::profile_of_all();
  for (const QuestionKind question : both) {
    const Ask blind_to_small = [&](const SuiteCase& of) {
      std::vector<Listed> all = all_met(of, 0).value();
      merge(all, 1e-3, true);
      return question == QuestionKind::all ? claim_of(all) : count_of(all.size());
    };
    const SuiteCase of = asked(test::drafted({{"e0", scene::Sphere{glm::dvec3(0.25, 0, 4), 1}},
                                              {"e1", scene::Sphere{glm::dvec3(0, 0, 8), 0x1p-14}}},
                                             {0, 0, 0}, {0, 0, 1}),
                               question);
    const Finding finding = test::finding_of(of, blind_to_small(of), profile);
    REQUIRE(is_failure(finding.judgement.verdict));
    CHECK(explaining_data(finding, profile)->excluded >= 10);
    const Finding least = minimised(finding, profile, blind_to_small);
    CHECK(least.of.question == question);
    CHECK(least.judgement.verdict == finding.judgement.verdict);
    CHECK(least.of.the_case.scene.size() == 1);
  }
}

TEST_CASE("a search asks for all hits and for counts, and finds what is wrong with them") {
  const Profile profile = test::profile_of_all();
  for (const QuestionKind question : both) {
    const FuzzOptions options{.suite = {.question = question}, .steps = 1500};
    const auto goes_on = [] { return true; };
    const auto asking = [&](Fault plant) {
      return [question, plant](const SuiteCase& of) -> Claim {
        auto all = all_met(of, 0);
        if (!all) return {.why = "a stretch"};
        if (plant != nullptr) plant(*all);
        return question == QuestionKind::all ? claim_of(*all) : count_of(all->size());
      };
    };
    CHECK(fuzz(options, profile, asking(nullptr), goes_on).failures == 0);
    CHECK(fuzz(options, profile, asking([](auto& list) { merge(list, 1e-6, false); }), goes_on).failures > 0);
  }
}

TEST_CASE("a miss without a number is a count of none") {
  CHECK(verdict(asked(ball(), QuestionKind::count), test::miss()) == Verdict::wrong_count);
  CHECK(verdict(asked(ball({0, 0, 10}), QuestionKind::count), test::miss()) == Verdict::exact);
}
