// The judgement on first hits within a range of the ray.
#include <cmath>

#include "conform/drafted.hpp"
#include "conform/judged.hpp"
#include "durero/conform/judge/judge.hpp"
#include "durero/conform/judge/minimise.hpp"
#include "durero/conform/judge/trait.hpp"
#include "durero/surface/exact.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::conform;
using Outcome = Claim::Outcome;
using surface::exact::Parameter;

namespace {

/// A ball of radius 1 around (0, 0, 4), asked from the origin: at t = 3 and t = 5.
SuiteCase ball(const AskedRange& range, const glm::dvec3& v = {0, 0, 1}) {
  SuiteCase of = test::sphere_case({0, 0, 0}, v);
  of.question = QuestionKind::range;
  of.ranges = {range};
  answer(of);
  return of;
}

Verdict verdict(const SuiteCase& of, const Claim& claim, const Profile& profile = test::profile_of_all()) {
  return judge(of, 0, claim, profile).verdict;
}

Claim hit_of_ball(double t) {
  Claim claim = test::hit_at(t);
  claim.element = scene::ElementRef{scene::Sphere::tipo, 0};
  return claim;
}

/// The cases of a family as first hits within ranges.
std::vector<SuiteCase> ranged(const Family& family, NumberFormat numbers, std::uint64_t count) {
  return test::asked_cases(family, QuestionKind::range, numbers, count);
}

/// A crossing of a ray by exact arithmetic, element by element, without the trees of the judge.
struct Met {
  scene::ElementRef element;
  double t;
};

/// The points of all crossings, ascending; nothing where one is a stretch.
std::optional<std::vector<Met>> all_met(const SuiteCase& of, std::size_t ray) {
  std::vector<Met> all;
  for (const auto& [element, segment] : surface::exact::all_hits(of.the_case.scene, of.the_case.rays[ray].rayo)) {
    if (!segment.begin || !segment.end || *segment.begin != *segment.end) return std::nullopt;
    all.push_back({element, number::round_to_binary64(*segment.begin)});
  }
  return all;
}

double length_of(const scene::Query& ray) {
  const glm::dvec3 v = ray.rayo.v().xyz();
  return std::hypot(v.x, v.y, v.z);
}

/// How a tracer reads a range.
struct Reading {
  const char* name;
  double begin_factor = 1, end_factor = 1;
  bool measures_length = false;
  bool discards_first = false;  ///< finds the first hit from 0, and says a miss where that lies before the range
  bool passes_equal = false;    ///< the ends are no part of the range
  double least = 0;             ///< begins there at least
};

Claim claim_of(const std::vector<Met>& all, AskedRange range, const Reading& reading, double length) {
  const double unit = reading.measures_length ? length : 1;
  range.begin = std::max(reading.least, range.begin * reading.begin_factor / unit);
  range.end = range.end * reading.end_factor / unit;
  for (const Met& met : all) {
    const bool is_within =
        reading.passes_equal ? met.t > range.begin && met.t < range.end : met.t >= range.begin && met.t <= range.end;
    if (is_within) return {.outcome = Outcome::hit, .element = met.element, .t = met.t};
    if (reading.discards_first) break;
  }
  return {.outcome = Outcome::miss};
}

using Counts = std::array<std::size_t, verdict_count>;

/// The verdicts on a tracer's answers to the rays of some scenes of each family.
Counts judged_ranges(const Reading& reading) {
  Counts counts{};
  const Profile profile = test::profile_of_all();
  for (const Family& family : families_of_few()) {
    for (const SuiteCase& of : ranged(family, NumberFormat::binary32, 4)) {
      for (std::size_t ray = 0; ray < of.truths.size(); ++ray) {
        const auto all = all_met(of, ray);
        if (!all) continue;
        const Claim claim = claim_of(*all, of.ranges[ray], reading, length_of(of.the_case.rays[ray]));
        const ClaimJudgement is = judge(of, ray, claim, profile);
        INFO(reading.name << ", " << of.name() << " ray " << ray << ": " << name(is.verdict));
        if (reading.name == std::string("right")) CHECK_FALSE(is_failure(is.verdict));
        ++counts[static_cast<std::size_t>(is.verdict)];
      }
    }
  }
  return counts;
}

std::size_t failures(const Counts& counts) {
  std::size_t sum = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) sum += is_failure(Verdict(i)) ? counts[i] : 0;
  return sum;
}

}  // namespace

TEST_CASE("the first hit of a range is that between its ends, both of which belong to it") {
  CHECK(verdict(ball({0, 4}), hit_of_ball(3)) == Verdict::exact);
  CHECK(verdict(ball({3.5, 10}), hit_of_ball(5)) == Verdict::exact);
  CHECK(verdict(ball({3.5, 10}), hit_of_ball(3)) == Verdict::out_of_range);
  CHECK(verdict(ball({3.5, 10}), test::miss()) == Verdict::missed);
  CHECK(verdict(ball({0, 10}), hit_of_ball(5)) == Verdict::far_root);
  CHECK(verdict(ball({3, 10}), hit_of_ball(3)) == Verdict::exact);
  CHECK(verdict(ball({3, 10}), hit_of_ball(5)) == Verdict::right);
  CHECK(verdict(ball({0, 3}), hit_of_ball(3)) == Verdict::exact);
  CHECK(verdict(ball({0, 3}), test::miss()) == Verdict::right);
  CHECK(verdict(ball({3.2, 4.8}), test::miss()) == Verdict::exact);
  CHECK(verdict(ball({3.2, 4.8}), hit_of_ball(3)) == Verdict::out_of_range);
  CHECK(verdict(ball({3.2, 4.8}), hit_of_ball(5)) == Verdict::out_of_range);
  CHECK(verdict(ball({3.2, 4.8}), hit_of_ball(4)) == Verdict::phantom);
  CHECK(verdict(ball({4, 2}), test::miss()) == Verdict::exact);
  CHECK(verdict(ball({4, 2}), hit_of_ball(3)) == Verdict::out_of_range);
}

TEST_CASE("data within the declared error decide at the ends of a range") {
  constexpr double delta = 64 * 0x1p-53;  // 16ε·4
  CHECK(verdict(ball({3 + delta, 10}), hit_of_ball(3)) == Verdict::right);
  CHECK(verdict(ball({3 + 16 * delta, 10}), hit_of_ball(3)) == Verdict::out_of_range);
  CHECK(verdict(ball({3 - delta, 10}), hit_of_ball(5)) == Verdict::right);
  // The ball's zone begins 7δ before the crossing, and a range has to begin 2δ before it.
  CHECK(verdict(ball({3 - 8 * delta, 10}), hit_of_ball(5)) == Verdict::right);
  CHECK(verdict(ball({3 - 10 * delta, 10}), hit_of_ball(5)) == Verdict::far_root);
  CHECK(verdict(ball({4, 5 - delta}), hit_of_ball(5)) == Verdict::right);
  CHECK(verdict(ball({4, 5 - 16 * delta}), hit_of_ball(5)) == Verdict::out_of_range);
  CHECK(verdict(ball({4, 5 + delta}), test::miss()) == Verdict::right);
  CHECK(verdict(ball({4, 5 + 16 * delta}), test::miss()) == Verdict::missed);
}

TEST_CASE("a hit without a place is right where its element may be met within the range") {
  Claim alone = hit_of_ball(0);
  alone.t.reset();
  CHECK(verdict(ball({3.5, 10}), alone) == Verdict::right);
  CHECK(verdict(ball({3.2, 4.8}), alone) == Verdict::phantom);
  CHECK(verdict(ball({0, 2.9}), alone) == Verdict::phantom);
  CHECK(verdict(ball({5.1, 9}), alone) == Verdict::phantom);
}

TEST_CASE("the ends are t, also for a system that measures lengths") {
  Profile lengths = test::profile_of_all();
  lengths.measure = Measure::length;
  CHECK(verdict(ball({1.6, 9}, {0, 0, 2}), hit_of_ball(5), lengths) == Verdict::exact);
  CHECK(verdict(ball({1.6, 9}, {0, 0, 2}), hit_of_ball(3), lengths) == Verdict::out_of_range);
}

TEST_CASE("a range leaves a solid unseen where the system answers the origin inside it") {
  Profile origin = test::profile_of_all();
  origin.inside = Inside::origin;
  SuiteCase inside = test::sphere_case({0, 0, 4}, {0, 0, 1});
  inside.question = QuestionKind::range;
  inside.ranges = {{0.5, 9}};
  answer(inside);
  CHECK(verdict(inside, test::miss(), origin) == Verdict::right);
  CHECK(verdict(inside, test::miss()) == Verdict::missed);
}

TEST_CASE("a range that cuts a stretch in a surface begins or ends it") {
  SuiteCase along =
      test::drafted({{"e0", scene::Disc{glm::dvec3(0, 0, 4), 1, glm::dvec3(0, 1, 0)}}}, {0, 0, 0}, {0, 0, 1});
  along.question = QuestionKind::range;
  const auto truth_within = [&](const AskedRange& range) {
    along.ranges = {range};
    answer(along);
    return along.truths[0];
  };
  CHECK(truth_within({3.5, 9}).hit.t == 3.5);
  CHECK(truth_within({3.5, 9}).ambiguity == Ambiguity::in_surface);
  CHECK(truth_within({0, 9}).hit.t == 3);
  CHECK(truth_within({5.5, 9}).hit.resultado == model::Resultado::miss);
  CHECK(truth_within({0, 2.5}).hit.resultado == model::Resultado::miss);
  CHECK_FALSE(is_failure(verdict(along, test::miss())));
}

TEST_CASE("the truth within a range is the first of all crossings there") {
  std::size_t hits = 0, misses = 0;
  for (const Family& family : families()) {
    if (is_of_bodies(family)) continue;  // all_met() knows shapes alone
    for (const SuiteCase& of : ranged(family, NumberFormat::binary64, is_of_meshes(family) ? 1 : 6)) {
      for (std::size_t ray = 0; ray < of.truths.size(); ray += is_of_meshes(family) ? 16 : 1) {
        const auto all = all_met(of, ray);
        if (!all) continue;
        const scene::Hit& hit = of.truths[ray].hit;
        const Claim claim = claim_of(*all, of.ranges[ray], {}, 1);
        INFO(of.name() << " ray " << ray << ", " << of.ranges[ray].begin << " to " << of.ranges[ray].end);
        // A crossing beside an end may be rounded to it.
        const auto is_at_end = [&](const Met& met) {
          return met.t == of.ranges[ray].begin || met.t == of.ranges[ray].end;
        };
        if (std::any_of(all->begin(), all->end(), is_at_end)) continue;
        REQUIRE((hit.resultado == model::Resultado::hit) == (claim.outcome == Outcome::hit));
        if (claim.t) CHECK(hit.t == *claim.t);
        (claim.t ? hits : misses) += 1;
      }
    }
  }
  CHECK(hits > 1000);
  CHECK(misses > 300);
}

TEST_CASE("a right tracer is right about ranges, also where its ends are open, and faults are seen") {
  const Counts right = judged_ranges({.name = "right"});
  CHECK(failures(right) == 0);
  CHECK(failures(judged_ranges({.name = "ends are no part", .passes_equal = true})) == 0);
  CHECK(failures(judged_ranges({.name = "no begin", .begin_factor = 0})) > 300);
  CHECK(failures(judged_ranges({.name = "no end", .end_factor = 0x1p60})) > 200);
  CHECK(failures(judged_ranges({.name = "lengths", .measures_length = true})) > 200);
  CHECK(failures(judged_ranges({.name = "discards the first hit", .discards_first = true})) > 50);
  CHECK(failures(judged_ranges({.name = "begins late", .begin_factor = 1.0001})) > 30);
  CHECK(failures(judged_ranges({.name = "begins early", .begin_factor = 0.9999})) > 30);
  CHECK(failures(judged_ranges({.name = "ends late", .end_factor = 1.0001})) > 30);
  CHECK(failures(judged_ranges({.name = "ends early", .end_factor = 0.9999})) > 30);
  CHECK(failures(judged_ranges({.name = "an epsilon", .least = 1e-3})) > 30);
}

TEST_CASE("ranges lie at, beside, between and behind crossings, from 0 and empty, the same for the same options") {
  std::size_t empty = 0, from_zero = 0, without_hit = 0, of_later_hit = 0, near_begin = 0, near_end = 0;
  for (const Family& family : families_of_few()) {
    const std::vector<SuiteCase> once = ranged(family, NumberFormat::binary32, 3),
                                 again = ranged(family, NumberFormat::binary32, 3);
    for (std::size_t i = 0; i < once.size(); ++i) {
      CHECK(once[i].ranges == again[i].ranges);
      for (std::size_t ray = 0; ray < once[i].ranges.size(); ++ray) {
        const auto& [begin, end, radio] = once[i].ranges[ray];
        CHECK((begin >= 0 && std::isfinite(begin) && end >= 0 && std::isfinite(end)));
        CHECK(begin == static_cast<double>(static_cast<float>(begin)));
        empty += begin > end;
        from_zero += begin == 0;
        const auto all = all_met(once[i], ray);
        if (!all || all->empty()) continue;
        without_hit += once[i].truths[ray].hit.resultado == model::Resultado::miss;
        of_later_hit += once[i].truths[ray].hit.t > all->front().t;
        for (const Met& met : *all) {
          near_begin += begin > 0 && std::abs(met.t / begin - 1) < 0x1p-10;
          near_end += std::abs(met.t / end - 1) < 0x1p-10;
        }
      }
    }
  }
  CHECK(empty > 100);
  CHECK(from_zero > 100);
  CHECK(without_hit > 100);
  CHECK(of_later_hit > 50);
  CHECK(near_begin > 100);
  CHECK(near_end > 100);
}

TEST_CASE("a range stays where it is while its failure is made small and its cause is looked for") {
  const Profile all = test::profile_of_all();
  const Ask as_lengths = [](const SuiteCase& of) {
    return claim_of(all_met(of, 0).value(), of.ranges[0], {.measures_length = true}, length_of(of.the_case.rays[0]));
  };
  const SuiteCase of = ball({1.75, 4}, {0.0625, 0.125, 2});
  const Finding finding = test::finding_of(of, as_lengths(of), all);
  REQUIRE(is_failure(finding.judgement.verdict));
  CHECK(cause_of(finding, all, as_lengths) == Trait::not_unit);
  const Finding least = minimised(finding, all, as_lengths);
  CHECK(least.judgement.verdict == finding.judgement.verdict);
  REQUIRE(least.of.ranges.size() == 1);
  Draft draft(ball({1, 3.5}));
  scale_direction(draft, 2);
  CHECK(draft.range == AskedRange{0.5, 1.75});
  move_along(draft, 0.25);
  CHECK(draft.range == AskedRange{0.25, 1.5});
  move_along(draft, 0.5);
  CHECK(draft.range == AskedRange{0, 1});
  scale_with_t(draft, 2);
  CHECK(draft.range == AskedRange{0, 4});
}
