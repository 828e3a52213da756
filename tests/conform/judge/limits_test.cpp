// The limits of a profile on the distance, against all data that may be meant: what may be beyond a limit may be passed
// by, what is certainly within may not.
#include "conform/judge/limits.hpp"

#include <array>

#include "conform/hits.hpp"
#include "conform/perturbed.hpp"
#include "durero/conform/judge/explaining_data.hpp"
#include "durero/conform/judge/judge.hpp"
#include "durero/scene/addition.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::conform;
using namespace durero::test;

namespace {

Claim hit(double t, scene::ElementRef element) { return {.outcome = Claim::Outcome::hit, .element = element, .t = t}; }
const Claim miss{.outcome = Claim::Outcome::miss};

constexpr scene::ElementRef sphere{model::Tipo::soy_esfera, 0}, plane{model::Tipo::soy_plano, 0};

/// A case of one ray, by hand.
SuiteCase one_ray(scene::Scene scene, const model::Rayo& rayo) {
  SuiteCase of{.family = &families().front(), .the_case = {std::move(scene), std::vector<scene::Query>(1, {rayo, {}})}};
  answer(of);
  return of;
}

/// Of every type, with limits.
Profile limited(double least_t, double greatest_t, Measure measure = Measure::parameter) {
  Profile profile = wide_profile(NumberFormat::binary64);
  profile.least_t = least_t;
  profile.greatest_t = greatest_t;
  profile.measure = measure;
  return profile;
}

constexpr double no_limit = std::numeric_limits<double>::infinity();

Verdict verdict_of(const SuiteCase& of, const Claim& claim, const Profile& profile) {
  return judge(of, 0, claim, profile).verdict;
}

/// A sphere from 0 along v.
SuiteCase sphere_at(const glm::dvec3& centro, double radio, const glm::dvec3& v) {
  scene::Scene scene;
  add(scene, scene::Sphere{centro, radio});
  return one_ray(std::move(scene), ray({0, 0, 0}, v));
}

}  // namespace

TEST_CASE("where data may leave out what is within the limits, a miss of what is beyond them is right") {
  scene::Scene planes;
  add(planes, scene::Plane{{0, 0, 0}, {1, 0, 0}});
  add(planes, scene::Plane{{0, 0, 0}, {0, 0, 1}});
  const SuiteCase in_surface = one_ray(std::move(planes), ray({0, 0, 0x1p35}, {0, 0, -1}));
  CHECK(verdict_of(in_surface, miss, limited(0, 1000)) == Verdict::right);
  CHECK(verdict_of(in_surface, miss, limited(0, no_limit)) == Verdict::missed);

  scene::Scene scene;
  add(scene, scene::Sphere{{1, 0, 4}, 1});
  add(scene, scene::Plane{{0, 0, 2000}, {0, 0, 1}});
  const SuiteCase tangent = one_ray(std::move(scene), ray({0, 0, 0}, {0, 0, 1}));
  CHECK(verdict_of(tangent, miss, limited(0, 1000)) == Verdict::right);
  CHECK(verdict_of(tangent, miss, limited(0, 3000)) == Verdict::missed);
  CHECK(verdict_of(tangent, hit(2000, plane), limited(0, 1000)) == Verdict::right);
  CHECK(verdict_of(tangent, hit(1900, plane), limited(0, 1000)) == Verdict::misplaced);
  CHECK(verdict_of(tangent, {.outcome = Claim::Outcome::hit, .element = plane}, limited(0, 1000)) == Verdict::right);
  CHECK(verdict_of(tangent, hit(4, sphere), limited(0, 1000)) == Verdict::exact);
}

TEST_CASE("a hit is certainly within a limit from nine delta on, in t as in a length") {
  const double delta = 16 * 0x1p-53 * 8;  // M is 8
  const SuiteCase along_z = sphere_at({0, 0, 8}, 1, {0, 0, 1});
  const SuiteCase twice = sphere_at({0, 0, 8}, 1, {0, 0, 2});
  struct Row {
    const SuiteCase& of;
    double t, unit;
    Measure measure;
  };
  for (const auto& [of, t, unit, measure] :
       {Row{along_z, 7, 1, Measure::parameter}, Row{along_z, 7, 1, Measure::length}, Row{along_z, 7, 1, Measure::point},
        Row{twice, 3.5, 0.5, Measure::parameter}, Row{twice, 7, 1, Measure::length}}) {
    // The walls of a sphere are seven δ from it, and a number is off by two.
    CHECK(verdict_of(of, miss, limited(0, t, measure)) == Verdict::right);
    CHECK(verdict_of(of, miss, limited(0, t + 8.5 * delta * unit, measure)) == Verdict::right);
    CHECK(verdict_of(of, miss, limited(0, t + 9.5 * delta * unit, measure)) == Verdict::missed);
    CHECK(verdict_of(of, miss, limited(t, no_limit, measure)) == Verdict::missed);  // of the way out
    CHECK(verdict_of(of, miss, limited(t, t, measure)) == Verdict::right);
    if (measure == Measure::point) continue;
    const Claim far = hit(t + 2 * unit, sphere);
    CHECK(verdict_of(of, far, limited(t, no_limit, measure)) == Verdict::right);
    CHECK(verdict_of(of, far, limited(t - 8.5 * delta * unit, no_limit, measure)) == Verdict::right);
    CHECK(verdict_of(of, far, limited(t - 9.5 * delta * unit, no_limit, measure)) == Verdict::far_root);
  }
}

TEST_CASE("in the error of t the largest coordinate stands for the length of v, in a length the root itself") {
  const double delta = 16 * 0x1p-53 * 12;
  const SuiteCase slanted = sphere_at({4, 6, 12}, 7, {2, 3, 6});  // at t = 1, a length of 7
  CHECK(verdict_of(slanted, miss, limited(0, 7 + 9.5 * delta, Measure::length)) == Verdict::missed);
  CHECK(verdict_of(slanted, miss, limited(0, 7 + 8.5 * delta, Measure::length)) == Verdict::right);
  CHECK(verdict_of(slanted, miss, limited(0, 1 + 9.5 * delta / 6, Measure::parameter)) == Verdict::missed);
  CHECK(verdict_of(slanted, miss, limited(0, 1 + 8.5 * delta / 7, Measure::parameter)) == Verdict::right);
}

TEST_CASE("from inside a solid, the origin is nearer than any least distance") {
  scene::Scene scene;
  add(scene, scene::Sphere{{0, 0, 0}, 4});
  add(scene, scene::Plane{{0, 0, 9}, {0, 0, 1}});
  const SuiteCase of = one_ray(std::move(scene), ray({0, 0, 0}, {0, 0, 1}));
  Profile profile = limited(0, no_limit);
  profile.inside = Inside::origin;
  CHECK(verdict_of(of, hit(9, plane), profile) == Verdict::wrong_element);
  profile.least_t = 1e-4;
  for (const Claim& claim : {hit(0, sphere), hit(4, sphere), hit(9, plane)})
    CHECK((verdict_of(of, claim, profile) == Verdict::right || verdict_of(of, claim, profile) == Verdict::exact));
  CHECK(verdict_of(of, miss, profile) == Verdict::missed);  // of the plane
  profile.inside = Inside::exit_point;
  CHECK(verdict_of(of, hit(9, plane), profile) == Verdict::wrong_element);
}

TEST_CASE("of a ray outside a profile by its distance, what is listed beside it knows no limit") {
  const SuiteCase of = sphere_at({0, 0, 8}, 1, {0, 0, 1});
  for (const Profile& profile : {limited(0, 6), limited(7.5, no_limit)}) {
    const ClaimJudgement is = judge(of, 0, miss, profile);
    CHECK(is.verdict == Verdict::skipped);
    CHECK(is.otherwise == Verdict::missed);
  }
}

TEST_CASE("of a miss, data whose hits are all beyond the limits are an explanation") {
  scene::Scene scene;
  add(scene, scene::Sphere{{0, 0, 1001}, 1.5});
  const SuiteCase of = one_ray(std::move(scene), ray({0, 0, 0}, {0, 0, 1}));
  const Profile profile = limited(0, 1000);
  const Finding finding{of, 0, miss, judge(of, 0, miss, profile)};
  REQUIRE(finding.judgement.verdict == Verdict::missed);
  const auto data = explaining_data(finding, profile);
  REQUIRE(data);
  REQUIRE(data->nearest);
  CHECK(data->nearest->of.truths[0].hit.t > 1000);
  CHECK(data->nearest->off * data->epsilon * data->M <= 1);
  REQUIRE(data->excluded);
  // Half a unit to the limit, of which the walls and the number share nine.
  CHECK(std::ldexp(data->epsilon * data->M, *data->excluded) <= 0.5 / 9);
  CHECK(std::ldexp(data->epsilon * data->M, *data->excluded) > 0.5 / 40);
}

TEST_CASE("a mesh that holds water holds it up to the limits") {
  const std::array<glm::dvec3, 4> corners{{{8, 8, 8}, {-8, -8, 8}, {-8, 8, -8}, {8, -8, -8}}};
  scene::Scene scene;
  for (std::size_t i = 0; i < 4; ++i)
    add(scene, scene::Triangle{{{corners[i], corners[(i + 1) % 4], corners[(i + 2) % 4]}}});
  const SuiteCase of = one_ray(std::move(scene), ray({0, 0, 0}, corners[1]));
  Profile profile = limited(0, 1);
  profile.watertight = true;
  CHECK(verdict_of(of, miss, profile) == Verdict::right);
  profile.greatest_t = 1.01;
  CHECK(verdict_of(of, miss, profile) == Verdict::missed);
}
