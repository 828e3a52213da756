#include "durero/conform/judge/fuzz.hpp"

#include <fmt/core.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <set>

#include "conform/drafted.hpp"
#include "conform/faults/tracer.hpp"
#include "conform/judged.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::conform;

namespace {

bool for_ever() { return true; }

/// What plain arithmetic can do without scaling.
Profile plain_profile(NumberFormat format) {
  Profile profile = test::profile_of_all();
  profile.format = format;
  const int places = format == NumberFormat::binary32 ? 30 : 240;
  profile.least_size = std::ldexp(1, -places);
  profile.greatest_size = profile.greatest_coordinate = std::ldexp(1, places);
  return profile;
}

template <class N>
Ask tracer(test::Fault fault) {
  return [fault](const SuiteCase& of) {
    return test::Tracer<N>(of.the_case.scene, fault).first_hit(of.the_case.rays[0].rayo);
  };
}

Claim right(const SuiteCase& of) { return test::right_claims(of)[0]; }

glm::dvec3 direction_of(const SuiteCase& of) { return of.the_case.rays[0].rayo.v().xyz(); }

/// Faults of few questions, as authors make them: something is taken for 0 or for the same.
struct RareFault {
  const char* name;
  bool (*is_wrong)(const SuiteCase& of);
};

bool has_twins(const SuiteCase& of) {
  const auto spheres = of.the_case.scene.shapes<scene::Sphere>();
  for (std::size_t i = 0; i < spheres.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (spheres[i].radio == spheres[j].radio && spheres[i].centro != spheres[j].centro) return true;
  return false;
}

constexpr RareFault rare_faults[] = {
    {"a coordinate of v that is one of p",
     [](const SuiteCase& of) {
       const glm::dvec3 v = direction_of(of), p = of.the_case.rays[0].rayo.p().xyz();
       return v.x == p.x && v.x != 0;
     }},
    {"spheres with one radius at two places", has_twins},
    {"a radius of more than 2²⁴ and a v of less than 2⁻¹²",
     [](const SuiteCase& of) {
       const auto spheres = of.the_case.scene.shapes<scene::Sphere>();
       return !spheres.empty() && spheres[0].radio > 0x1p24 && glm::length(direction_of(of)) < 0x1p-12;
     }},
    {"a sphere far from its origin and near to the ray's",
     [](const SuiteCase& of) {
       const auto spheres = of.the_case.scene.shapes<scene::Sphere>();
       if (spheres.empty()) return false;
       const double r = spheres[0].radio, far = glm::length(spheres[0].centro);
       const double near = glm::length(spheres[0].centro - of.the_case.rays[0].rayo.p().xyz());
       return far > 0x1p12 * r && near < 0x1.01p0 * r && near > r;
     }},
};

Ask missing_where(const RareFault& fault) {
  return [&fault](const SuiteCase& of) { return fault.is_wrong(of) ? Claim{Claim::Outcome::miss} : right(of); };
}

/// How many rays of a run of so many of each family are failures.
std::uint64_t failures_of_run(const Ask& ask, std::size_t rays, const Profile& profile) {
  std::uint64_t failures = 0;
  const SuiteOptions options{.rays = rays};
  for (const Family& family : families_of_few()) {
    for (std::uint64_t number = 0; number < cases(options, family); ++number) {
      SuiteCase of = suite_case(options, family, number);
      answer(of);
      for (std::size_t ray = 0; ray < of.truths.size(); ++ray)
        failures += is_failure(judge(of, ray, ask(with_ray_alone(of, ray)), profile).verdict);
    }
  }
  return failures;
}

}  // namespace

TEST_CASE("the same seed and steps make the same questions, whatever the time") {
  const Profile profile = test::profile_of_all();
  std::vector<std::string> one, two, other;
  const auto written = [](std::vector<std::string>& to) {
    return [&to](const SuiteCase& of) {
      const glm::dvec3 v = direction_of(of);
      to.push_back(fmt::format("{} {:a} {:a} {:a}", of.name(), v.x, v.y, v.z));
      return test::claims_blind_to_small(of)[0];
    };
  };
  const Fuzzing first = fuzz({.steps = 600}, profile, written(one), for_ever);
  const Fuzzing second = fuzz({.steps = 600}, profile, written(two), for_ever);
  fuzz({.suite = {.seed = 2}, .steps = 600}, profile, written(other), for_ever);
  CHECK(one == two);
  CHECK(one != other);
  CHECK(first.steps == 600);
  CHECK(first.asked == one.size());
  CHECK(first.failures == second.failures);
  REQUIRE(first.failing.size() == second.failing.size());
  std::uint64_t alike = 0;
  for (std::size_t i = 0; i < first.failing.size(); ++i) {
    CHECK(first.failing[i].step == second.failing[i].step);
    alike += first.failing[i].alike;
  }
  CHECK(alike == first.failures);
}

TEST_CASE("a search ends when it is told, and counts no answer after that") {
  std::size_t asked = 0;
  const auto crashed_by_interrupt = [&](const SuiteCase& of) {
    return ++asked == 50 ? Claim{.outcome = Claim::Outcome::crashed} : right(of);
  };
  const Fuzzing found = fuzz({}, test::profile_of_all(), crashed_by_interrupt, [&] { return asked < 50; });
  CHECK(asked == 50);
  CHECK(found.asked == 49);
  CHECK(found.failures == 0);
}

TEST_CASE("a search keeps to the families, types and numbers that it is given, and to the profile") {
  Profile profile = test::profile_of_all();
  profile.greatest_coordinate = 8;
  const FuzzOptions spheres{.suite = {.families = {find_family("rim"), find_family("tiny")},
                                      .tipos = {model::Tipo::soy_esfera, model::Tipo::soy_disco}},
                            .steps = 500};
  const Fuzzing found = fuzz(
      spheres, profile,
      [&](const SuiteCase& of) {
        CHECK((of.family->name == "rim" || of.family->name == "tiny"));
        CHECK(outside(of, 0, profile).empty());
        const glm::dvec3 v = direction_of(of);
        CHECK(v == glm::dvec3(glm::vec3(v)));
        of.the_case.scene.for_each([](scene::ElementRef e, const auto&) {
          CHECK((e.tipo == model::Tipo::soy_esfera || e.tipo == model::Tipo::soy_disco));
        });
        return right(of);
      },
      for_ever);
  CHECK(found.asked > 300);
  CHECK_THROWS_AS(fuzz({.suite = {.families = {find_family("apex")}, .tipos = {model::Tipo::soy_esfera}}, .steps = 1},
                       profile, right, for_ever),
                  std::invalid_argument);
}

TEST_CASE("a change that leaves the range of binary64 makes no question") {
  const double infinity = std::numeric_limits<double>::infinity();
  SuiteCase of = test::sphere_case({0, 0, 0}, {0, 0, 1});
  Draft far(of);
  std::get<scene::Sphere>(far.elements[0].shape).centro.x = -infinity;
  CHECK_FALSE(far.built(of));
  Draft solid(of);
  solid.are_closed = true;
  solid.elements = {{"e0", scene::Cylinder{glm::dvec3(0, 0, 1.5e308), 1, glm::dvec3(0, 0, 1), 1.5e308}}};
  CHECK_FALSE(solid.built(of));
}

TEST_CASE("nothing gross is found in right tracers, exact and of plain arithmetic in both formats") {
  const auto gross = [](const Fuzzing& found) {
    return std::ranges::count_if(found.failing,
                                 [](const FuzzedFailure& kind) { return is_gross(kind.finding.judgement.verdict); });
  };
  constexpr std::uint64_t steps = 8000;
  CHECK(fuzz({.steps = steps}, test::profile_of_all(), right, for_ever).failures == 0);
  CHECK(gross(fuzz({.steps = steps}, plain_profile(NumberFormat::binary64), tracer<double>(test::Fault::none),
                   for_ever)) == 0);
  // Products of three lengths of a small triangle vanish in binary32, and no limit of a profile is on triangles.
  const Profile narrow = plain_profile(NumberFormat::binary32);
  SuiteOptions round;
  std::ranges::copy_if(narrow.tipos, std::back_inserter(round.tipos),
                       [](model::Tipo tipo) { return tipo != model::Tipo::soy_triangulo; });
  CHECK(gross(fuzz({.suite = round, .steps = steps}, narrow, tracer<float>(test::Fault::none), for_ever)) == 0);
}

TEST_CASE("each planted fault is found in few steps, from all families or from those that are meant to see it") {
  constexpr std::uint64_t steps = 1500;
  const Profile profile = plain_profile(NumberFormat::binary64);
  std::size_t by_all = 0;
  for (const test::FaultRow& row : test::faults()) {
    const Ask ask =
        row.fault == test::Fault::binary32_arithmetic ? tracer<float>(row.fault) : tracer<double>(row.fault);
    std::uint64_t failures = fuzz({.steps = steps}, profile, ask, for_ever).failures;
    by_all += failures > 0;
    FuzzOptions meant{.suite = {.numbers = NumberFormat::binary64}, .steps = steps};
    for (const std::string_view family : row.seen_by) meant.suite.families.push_back(find_family(family));
    if (failures == 0) failures = fuzz(meant, profile, ask, for_ever).failures;
    INFO(row.name);
    CHECK(failures > 0);
  }
  CHECK(by_all * 10 >= test::faults().size() * 9);
}

TEST_CASE("faults of shadow rays are found, and nothing in right ones") {
  const FuzzOptions shadows{.suite = {.question = QuestionKind::shadow}, .steps = 3000};
  const auto shadow_of = [](double end_factor, bool measures_length) {
    return [=](const SuiteCase& of) {
      const scene::Hit& hit = of.truths[0].hit;
      REQUIRE(of.ranges.size() == 1);
      const double end = of.ranges[0].end * end_factor / (measures_length ? glm::length(direction_of(of)) : 1);
      const bool is_hit =
          hit.resultado == model::Resultado::no_minimum || (hit.resultado == model::Resultado::hit && hit.t <= end);
      return Claim{.outcome = is_hit ? Claim::Outcome::hit : Claim::Outcome::miss};
    };
  };
  const Profile profile = test::profile_of_all();
  CHECK(fuzz(shadows, profile, shadow_of(1, false), for_ever).failures == 0);
  CHECK(fuzz(shadows, profile, shadow_of(1 - 0x1p-12, false), for_ever).failures > 20);
  CHECK(fuzz(shadows, profile, shadow_of(1, true), for_ever).failures > 100);
}

TEST_CASE("faults of few questions are found that a run of as many rays of the families does not find") {
  constexpr std::size_t rays = 256;
  const Profile profile = test::profile_of_all();
  std::size_t found_alone = 0;
  for (const RareFault& fault : rare_faults) {
    const Ask ask = missing_where(fault);
    const Fuzzing found =
        fuzz({.suite = {.tipos = profile.tipos}, .steps = rays * families_of_few().size()}, profile, ask, for_ever);
    const std::uint64_t of_run = failures_of_run(ask, rays, profile);
    fmt::print("{:52} fuzzing {:4}, run {:4}\n", fault.name, found.failures, of_run);
    INFO(fault.name);
    CHECK(found.failures > 0);
    found_alone += of_run == 0;
  }
  CHECK(found_alone >= 2);
}
