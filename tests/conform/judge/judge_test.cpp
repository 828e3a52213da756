#include "durero/conform/judge/judge.hpp"

#include <fmt/core.h>

#include <array>
#include <glm/geometric.hpp>
#include <map>

#include "conform/hits.hpp"
#include "conform/perturbed.hpp"
#include "durero/scene/addition.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"

using namespace durero;
using namespace durero::conform;
using namespace durero::test;

namespace {

using Outcome = Claim::Outcome;

std::string shown(const Claim& claim) {
  std::string said = claim.outcome == Outcome::hit ? "hit" : "no hit";
  if (claim.element) said += fmt::format(" {}#{}", model::name(claim.element->tipo), claim.element->index);
  if (claim.t) said += fmt::format(" t={:a}", *claim.t);
  if (claim.punto) said += fmt::format(" ({:a}, {:a}, {:a})", claim.punto->x, claim.punto->y, claim.punto->z);
  return said;
}

Claim hit(double t, scene::ElementRef element) { return {.outcome = Outcome::hit, .element = element, .t = t}; }
Claim miss() { return {.outcome = Outcome::miss}; }

/// A case of one ray, by hand.
SuiteCase one_ray(scene::Scene scene, const model::Rayo& rayo) {
  return answered(families_of_few().front(), {std::move(scene), std::vector<scene::Query>(1, {rayo, {}})});
}

Verdict verdict_of(const SuiteCase& of, const Claim& claim, const Profile& profile) {
  return judge(of, 0, claim, profile).verdict;
}

constexpr scene::ElementRef sphere{model::Tipo::soy_esfera, 0};

bool is_right(Verdict verdict) { return verdict == Verdict::exact || verdict == Verdict::right; }

/// Claims that are exact answers of moved data, for scenes of these seeds: how many were judged so.
struct MovedAnswers {
  std::map<Verdict, std::size_t> verdicts{};
  std::size_t other_outcome = 0, moved = 0;  ///< with a hit for a miss or the other way; by more than a thousand ulps
};
MovedAnswers check_moved_answers(std::uint64_t first_seed, std::uint64_t last_seed) {
  MovedAnswers counted;
  auto& [verdicts, other_outcome, moved] = counted;
  for (const Family& family : families_of_few()) {
    for (std::uint64_t seed = first_seed; seed <= last_seed; ++seed) {
      const SuiteCase of = answered(family, generate(family, seed, 24));
      for (const NumberFormat format : {NumberFormat::binary32, NumberFormat::binary64}) {
        Profile profile = wide_profile(format);
        Perturbation perturbation(seed, format);
        for (std::size_t i = 0; i < of.truths.size(); ++i) {
          const scene::Hit& truth = of.truths[i].hit;
          for (const Measure measure : {Measure::parameter, Measure::length, Measure::point}) {
            profile.measure = measure;
            // A part of t! has room for a nearer answer.
            const auto claim = perturbation.answer(of.the_case.scene, of.the_case.rays[i],
                                                   i % 2 == 0 || !std::isfinite(truth.t) ? 0 : truth.t * 0.99, measure);
            if (!claim) continue;
            const ClaimJudgement judgement = judge(of, i, *claim, profile);
            ++verdicts[judgement.verdict];
            if (judgement.verdict == Verdict::skipped) continue;
            other_outcome += (claim->outcome == Outcome::hit) != (truth.resultado == model::Resultado::hit);
            moved += judgement.ulps > 1e3;
            INFO(replay(family, seed, 24, i) << "\n"
                                             << text(of.the_case.rays[i]) << "\n"
                                             << text(truth) << "\n"
                                             << shown(*claim) << ": " << name(judgement.verdict));
            CHECK(is_right(judgement.verdict));
            if (claim->outcome != Outcome::hit) continue;
            const Claim element_alone{.outcome = Outcome::hit, .element = claim->element};
            CHECK(judge(of, i, element_alone, profile).verdict == Verdict::right);
          }
        }
      }
    }
  }
  return counted;
}

}  // namespace

TEST_CASE("the exact answer of data within the declared backward error is never judged off") {
  const std::size_t seeds = fewer_when_sanitized(12);
  const MovedAnswers counted = check_moved_answers(0, seeds - 1);
  CHECK(counted.verdicts.at(Verdict::right) > 1'600 * seeds);
  CHECK(counted.other_outcome > 16 * seeds);
  CHECK(counted.moved > 16 * seeds);
}

TEST_CASE("nor of many more", "[long]") {
  const MovedAnswers counted = check_moved_answers(12, 400);
  CHECK(counted.verdicts.at(Verdict::right) > 1'000'000);
}

TEST_CASE("the answer of a ray across a sphere is right to seven delta, and off from there") {
  scene::Scene scene;
  add(scene, scene::Sphere{{0, 0, 5}, 1});
  const SuiteCase of = one_ray(std::move(scene), ray({0, 0, 0}, {0, 0, 2}));
  for (const NumberFormat format : {NumberFormat::binary32, NumberFormat::binary64}) {
    const Profile profile = wide_profile(format);
    const double unit = format == NumberFormat::binary32 ? 0x1p-24 : 0x1p-53;
    const double delta = 16 * unit * 5 / 2;  // in t; M is 5, of centro
    CHECK(verdict_of(of, hit(2, sphere), profile) == Verdict::exact);
    CHECK(judge(of, 0, hit(2 + 6.5 * delta, sphere), profile).ulps > 30);
    for (const double sign : {-1., 1.}) {
      CHECK(verdict_of(of, hit(2 + sign * 7 * delta, sphere), profile) == Verdict::right);
      CHECK(verdict_of(of, hit(2 + sign * 7.25 * delta, sphere), profile) == Verdict::off);
      CHECK(verdict_of(of, hit(2 + sign * 0.000499, sphere), profile) == Verdict::off);
      CHECK(verdict_of(of, hit(2 + sign * 0.000501, sphere), profile) == Verdict::misplaced);
    }
    CHECK(verdict_of(of, hit(3, sphere), profile) == Verdict::far_root);
    CHECK(verdict_of(of, hit(3 + 6.5 * delta, sphere), profile) == Verdict::far_root);
    CHECK(verdict_of(of, hit(-2, sphere), profile) == Verdict::misplaced);
    CHECK(verdict_of(of, miss(), profile) == Verdict::missed);
    CHECK(verdict_of(of, hit(std::nan(""), sphere), profile) == Verdict::non_finite);
    CHECK(verdict_of(of, hit(-std::numeric_limits<double>::infinity(), sphere), profile) == Verdict::non_finite);
    CHECK(verdict_of(of, {.outcome = Outcome::crashed}, profile) == Verdict::crashed);
    CHECK(verdict_of(of, {.outcome = Outcome::hung}, profile) == Verdict::hung);
    CHECK(verdict_of(of, {}, profile) == Verdict::skipped);
    const double backward = judge(of, 0, hit(2 + 2 * delta, sphere), profile).backward;
    CHECK(backward == Approx(32).epsilon(0.01));  // 2δ is 32 ε·M
  }
}

TEST_CASE("a sphere that data within delta miss or hit may be hit or missed, and one further in or out may not") {
  for (const NumberFormat format : {NumberFormat::binary32, NumberFormat::binary64}) {
    const Profile profile = wide_profile(format);
    const double delta = 16 * (format == NumberFormat::binary32 ? 0x1p-24 : 0x1p-53) * 4;
    const auto past = [&](double deltas) {
      scene::Scene scene;
      add(scene, scene::Sphere{{1 + deltas * delta, 0, 4}, 1});
      return one_ray(std::move(scene), ray({0, 0, 0}, {0, 0, 1}));
    };
    CHECK(verdict_of(past(0), miss(), profile) == Verdict::right);
    CHECK(verdict_of(past(-6), miss(), profile) == Verdict::right);
    CHECK(verdict_of(past(6), hit(4, sphere), profile) == Verdict::right);
    CHECK(verdict_of(past(6), miss(), profile) == Verdict::exact);
    CHECK(verdict_of(past(8), hit(4, sphere), profile) == Verdict::phantom);
    // Where the ray goes deeper than the wall moved in, the sphere is met by all data.
    CHECK(verdict_of(past(-8), miss(), profile) == Verdict::missed);
  }
}

TEST_CASE("a system that declares a thickness may be off by seven of it besides, and by no more") {
  scene::Scene scene;
  add(scene, scene::Sphere{{0, 0, 5}, 1});
  const SuiteCase of = one_ray(std::move(scene), ray({0, 0, 0}, {0, 0, 1}));
  Profile profile = wide_profile(NumberFormat::binary64);
  CHECK(verdict_of(of, hit(4 + 6.9e-6, sphere), profile) == Verdict::off);
  profile.thickness = 1e-6;
  for (const double sign : {-1., 1.}) {
    CHECK(verdict_of(of, hit(4 + sign * 6.9e-6, sphere), profile) == Verdict::right);
    CHECK(verdict_of(of, hit(4 + sign * 7.1e-6, sphere), profile) == Verdict::off);
  }
  CHECK(verdict_of(of, miss(), profile) == Verdict::missed);
  scene::Scene grazed;
  add(grazed, scene::Sphere{{1 - 6e-6, 0, 4}, 1});
  const SuiteCase grazing = one_ray(std::move(grazed), ray({0, 0, 0}, {0, 0, 1}));
  CHECK(verdict_of(grazing, miss(), profile) == Verdict::right);
  profile.thickness = 0;
  CHECK(verdict_of(grazing, miss(), profile) == Verdict::missed);
}

TEST_CASE("another element before, or the name of another, is a wrong element") {
  scene::Scene scene;
  const scene::ElementRef near = add(scene, scene::Sphere{{0, 0, 5}, 1});
  const scene::ElementRef far = add(scene, scene::Sphere{{0, 0, 15}, 1});
  const scene::ElementRef parked = add(scene, scene::Sphere{{0, 0, 5 + 0x1p-50}, 1});
  const SuiteCase of = one_ray(std::move(scene), ray({0, 0, 0}, {0, 0, 1}));
  const Profile profile = wide_profile(NumberFormat::binary64);
  CHECK(verdict_of(of, hit(14, far), profile) == Verdict::wrong_element);
  CHECK(verdict_of(of, hit(4, far), profile) == Verdict::wrong_element);
  CHECK(verdict_of(of, hit(14, near), profile) == Verdict::wrong_element);
  CHECK(verdict_of(of, hit(4, parked), profile) == Verdict::right);
  CHECK(verdict_of(of, {.outcome = Outcome::hit, .t = 4}, profile) == Verdict::exact);
  CHECK(verdict_of(of, {.outcome = Outcome::hit, .t = 14}, profile) == Verdict::wrong_element);
  CHECK(verdict_of(of, {.outcome = Outcome::hit, .t = 6}, profile) == Verdict::far_root);
}

TEST_CASE("in a tie both elements are right, and a point a little off either is off, not of another element") {
  scene::Scene scene;
  const scene::ElementRef cilindro = add(scene, scene::Cylinder{{0, 0, 0}, 1.25, {0, 0, 1}, 16});
  const scene::ElementRef cono = add(scene, scene::Cone{{0, 0, 0}, 2, {0, 0, 1}, 0.625});
  const scene::ElementRef behind = add(scene, scene::Plane{{0, 100, 0}, {0, 1, 0}});
  const SuiteCase of = one_ray(std::move(scene), ray({0.75, -129, 224}, {0, 1, -1.75}));
  REQUIRE(of.truths[0].hit.elementos.size() == 2);
  Profile profile = wide_profile(NumberFormat::binary64);
  profile.measure = Measure::point;
  const auto at = [&](scene::ElementRef element, const glm::dvec3& punto) {
    return verdict_of(of, {.outcome = Outcome::hit, .element = element, .punto = punto}, profile);
  };
  const glm::dvec3 right = of.truths[0].hit.punto;
  for (const scene::ElementRef element : {cilindro, cono}) {
    CHECK(at(element, right) == Verdict::exact);
    for (const double off : {-1e-4, -1e-9, 1e-9, 1e-4})
      CHECK(at(element, right + off * glm::dvec3(0, 1, -1.75)) == Verdict::off);
    for (const double off : {-0.1, 0.1}) CHECK(is_gross(at(element, right + off * glm::dvec3(0, 1, -1.75))));
  }
  CHECK(at(cono, {0.75, -1.000000000003098, 5.43e-12}) == Verdict::off);
  // A ray of moved data passes beside the rim, and meets the plane, but not here.
  CHECK(at(behind, right) == Verdict::wrong_element);
  CHECK(at(behind, right + 1e-9) == Verdict::wrong_element);
}

TEST_CASE("what is first for some data alone is no wrong element a little off, and what is first for none is") {
  scene::Scene scene;
  const scene::ElementRef near = add(scene, scene::Sphere{{0, 0, 5}, 1});
  const scene::ElementRef parked = add(scene, scene::Sphere{{0, 0, 5 + 0x1p-50}, 1});
  const scene::ElementRef later = add(scene, scene::Sphere{{0, 0, 5 + 0x1p-30}, 1});
  const SuiteCase of = one_ray(std::move(scene), ray({0, 0, 0}, {0, 0, 1}));
  const Profile profile = wide_profile(NumberFormat::binary64);
  for (const scene::ElementRef element : {near, parked}) {
    for (const double t : {4 - 0x1p-30, 4 + 0x1p-30}) CHECK(verdict_of(of, hit(t, element), profile) == Verdict::off);
    CHECK(verdict_of(of, hit(6, element), profile) == Verdict::far_root);
    CHECK(verdict_of(of, hit(5, element), profile) == Verdict::misplaced);
  }
  for (const double t : {4., 4 + 0x1p-30, 6 + 0x1p-30})
    CHECK(verdict_of(of, hit(t, later), profile) == Verdict::wrong_element);
}

TEST_CASE("a claim that names no element is off near the truth, whatever it lies on") {
  scene::Scene scene;
  add(scene, scene::Sphere{{0, 0, 5}, 1});
  add(scene, scene::Plane{{0, 0, 4 + 0x1p-20}, {0, 0, 1}});
  const SuiteCase of = one_ray(std::move(scene), ray({0x1p-12, 0, 0}, {0, 0, 1}));
  REQUIRE(of.truths[0].hit.elementos == scene::ElementSet{sphere});
  const Profile profile = wide_profile(NumberFormat::binary64);
  const double behind = 4 + 0x1p-20;  // on the plane, and a little behind the sphere
  CHECK(verdict_of(of, {.outcome = Outcome::hit, .t = behind}, profile) == Verdict::off);
  CHECK(verdict_of(of, hit(behind, sphere), profile) == Verdict::off);
  CHECK(verdict_of(of, hit(behind, {model::Tipo::soy_plano, 0}), profile) == Verdict::wrong_element);
}

TEST_CASE("a distance may be a length, or a point alone, which must lie on the ray") {
  scene::Scene scene;
  add(scene, scene::Sphere{{0, 0, 5}, 1});
  add(scene, scene::Plane{{0, 0, 40}, {0, 0, 1}});
  const SuiteCase of = one_ray(std::move(scene), ray({0, 0, 0}, {0, 1, 8}));
  Profile profile = wide_profile(NumberFormat::binary64);
  const scene::Hit& truth = of.truths[0].hit;
  profile.measure = Measure::length;
  const double length = truth.t * std::sqrt(65.0);
  CHECK(is_right(verdict_of(of, hit(length, sphere), profile)));
  CHECK(judge(of, 0, hit(length, sphere), profile).ulps < 3);
  CHECK(verdict_of(of, hit(truth.t, sphere), profile) == Verdict::misplaced);
  profile.measure = Measure::point;
  const auto at = [](const glm::dvec3& p) { return Claim{.outcome = Outcome::hit, .element = sphere, .punto = p}; };
  CHECK(verdict_of(of, at(truth.punto), profile) == Verdict::exact);
  CHECK(verdict_of(of, at(truth.punto + glm::dvec3(0, 0x1p-50, 0)), profile) == Verdict::right);
  // On the sphere, and beside the ray.
  CHECK(verdict_of(of, at({0, 0, 4}), profile) == Verdict::misplaced);
  CHECK(verdict_of(of, at({0, 0, std::nan("")}), profile) == Verdict::non_finite);
}

TEST_CASE("a hit without a place is right where its element may be first, and never exact") {
  scene::Scene scene;
  add(scene, scene::Sphere{{0, 0, 5}, 1});
  const scene::ElementRef behind = add(scene, scene::Plane{{0, 0, 40}, {0, 0, 1}});
  const scene::ElementRef passed = add(scene, scene::Cylinder{{3, 0, 3}, 1, {0, 0, 1}, 9});
  const scene::ElementRef around = add(scene, scene::Cylinder{{0, 0, -50}, 20, {0, 0, 1}, 100});
  const scene::ElementRef touched = add(scene, scene::Disc{{2, 0, 1}, 2, {0, 0, 1}});
  const scene::ElementRef not_reached = add(scene, scene::Triangle{{{{-1, -1, -2}, {1, -1, -2}, {0, 2, -2}}}});
  const scene::ElementRef parallel = add(scene, scene::Plane{{0, 7, 0}, {0, 1, 0}});
  const auto verdict = [&](const SuiteCase& of, std::optional<scene::ElementRef> element) {
    return verdict_of(of, {.outcome = Outcome::hit, .element = element}, wide_profile(NumberFormat::binary32));
  };
  const SuiteCase of = one_ray(scene, ray({0, 0, 1.5}, {0, 0, 1}));
  CHECK(verdict(of, {}) == Verdict::right);
  for (const auto element : {behind, passed, around, touched, not_reached})
    CHECK(verdict(of, element) == Verdict::wrong_element);
  CHECK(verdict(of, parallel) == Verdict::wrong_element);  // far behind the sphere
  const SuiteCase at_rim = one_ray(scene, ray({0, 0, 0}, {0, 0x1p-20, 1}));
  CHECK(verdict(at_rim, touched) == Verdict::right);
  const SuiteCase beside = one_ray(scene, ray({-0.001, 0, 0}, {0, 0, 1}));
  CHECK(verdict(beside, touched) == Verdict::wrong_element);
  // From inside a solid it is the solid that is named, by who says so.
  scene::Scene nested;
  const scene::ElementRef outer = add(nested, scene::Sphere{{0, 0, 0}, 10});
  add(nested, scene::Sphere{{0, 0, 5}, 1});
  const SuiteCase from_inside = one_ray(std::move(nested), ray({0, 0, 0}, {0, 0, 1}));
  CHECK(verdict(from_inside, outer) == Verdict::wrong_element);
  Profile at_origin = wide_profile(NumberFormat::binary32);
  at_origin.inside = Inside::origin;
  CHECK(verdict_of(from_inside, {.outcome = Outcome::hit, .element = outer}, at_origin) == Verdict::right);
  // Where nothing is met.
  scene::Scene few;
  const scene::ElementRef sphere_aside = add(few, scene::Sphere{{5, 0, 5}, 1});
  const scene::ElementRef open = add(few, scene::Cylinder{{0, 0, 1}, 1, {0, 0, 1}, 2});
  const scene::ElementRef floor = add(few, scene::Plane{{0, -1, 0}, {0, 1, 0}});
  const SuiteCase missed = one_ray(few, ray({0, 0, 0}, {0, 0, 1}));
  CHECK(verdict(missed, sphere_aside) == Verdict::phantom);
  CHECK(verdict(missed, open) == Verdict::phantom);  // in and out by its ends
  CHECK(verdict(missed, floor) == Verdict::right);   // parallel: a turned one is met, far away
  CHECK(verdict(missed, {}) == Verdict::right);
  CHECK(verdict(one_ray(few, ray({0, 0, 0}, {0, 0x1p-10, 1})), floor) == Verdict::phantom);
  CHECK(verdict(one_ray(few, ray({0, 0, 0}, {0, 0x1p-10, 1})), {}) == Verdict::phantom);
  CHECK(verdict(one_ray(few, ray({0, 0, 0}, {0, 0x1p-22, 1})), floor) == Verdict::right);
}

TEST_CASE("of elements that are not first most are known to be wrong ones, by their names alone") {
  std::size_t wrong = 0, all = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const SuiteCase of = answered(families_of_few().front(), generate(families_of_few().front(), seed, 30));
    for (std::size_t i = 0; i < of.truths.size(); ++i) {
      const scene::ElementSet& first = of.truths[i].hit.elementos;
      of.the_case.scene.for_each([&](scene::ElementRef element, const auto&) {
        if (std::find(first.begin(), first.end(), element) != first.end()) return;
        const Claim claim{.outcome = Outcome::hit, .element = element};
        ++all, wrong += is_gross(judge(of, i, claim, wide_profile(NumberFormat::binary32)).verdict);
      });
    }
  }
  INFO(wrong << " of " << all);
  CHECK(all > 3000);
  CHECK(wrong > all * 95 / 100);
}

namespace {

/// The corners of a tetrahedron around 0, at integers.
const std::array<glm::dvec3, 4> corners{{{8, 8, 8}, {-8, -8, 8}, {-8, 8, -8}, {8, -8, -8}}};

scene::Scene tetrahedron(std::optional<std::size_t> left_out = {}) {
  scene::Scene scene;
  for (std::size_t i = 0; i < 4; ++i)
    if (i != left_out) add(scene, scene::Triangle{{{corners[i], corners[(i + 1) % 4], corners[(i + 2) % 4]}}});
  return scene;
}

Profile watertight_profile(NumberFormat format) {
  Profile profile = wide_profile(format);
  profile.watertight = true;
  return profile;
}

}  // namespace

TEST_CASE("no ray leaves a closed mesh of a system that claims to be watertight, if it starts well inside") {
  const Profile claimed = watertight_profile(NumberFormat::binary32), silent = wide_profile(NumberFormat::binary32);
  for (const glm::dvec3& to : {corners[1], 0.5 * (corners[0] + corners[1]), 0.25 * corners[0] + 0.75 * corners[2]}) {
    SuiteCase of = one_ray(tetrahedron(), ray({0, 0, 0}, to));
    CHECK(verdict_of(of, miss(), claimed) == Verdict::missed);
    CHECK(verdict_of(of, miss(), silent) == Verdict::right);
    CHECK(is_right(verdict_of(of, hit(1, of.truths[0].hit.elementos[0]), claimed)));
    for (std::size_t i = 0; i < 4; ++i) {
      const SuiteCase open = one_ray(tetrahedron(i), ray({0, 0, 0}, to));
      CHECK(is_right(verdict_of(open, miss(), claimed)));
    }
    // What lies behind the mesh is not first.
    scene::Scene with_plane = tetrahedron();
    const scene::ElementRef plane = add(with_plane, scene::Plane{3.0 * to, to / glm::length(to)});
    const SuiteCase behind = one_ray(std::move(with_plane), ray({0, 0, 0}, to));
    CHECK(verdict_of(behind, hit(3, plane), claimed) == Verdict::wrong_element);
    CHECK(verdict_of(behind, {.outcome = Outcome::hit, .element = plane}, claimed) == Verdict::wrong_element);
    CHECK(verdict_of(behind, hit(3, plane), silent) == Verdict::right);
  }
  const SuiteCase from_outside = one_ray(tetrahedron(), ray({0, 0, 24}, {0, 0, -1}));
  CHECK(verdict_of(from_outside, miss(), claimed) == Verdict::right);  // across the edge at (0, 0, 8)
  // Twice the same mesh holds nothing an odd number of times.
  scene::Scene twice = tetrahedron();
  for (std::size_t i = 0; i < 4; ++i)
    add(twice, scene::Triangle{{{corners[i], corners[(i + 1) % 4], corners[(i + 2) % 4]}}});
  CHECK(verdict_of(one_ray(std::move(twice), ray({0, 0, 0}, corners[1])), miss(), claimed) == Verdict::right);
}

TEST_CASE("an origin nearer to a closed mesh than six delta may be outside") {
  const double delta = 16 * 0x1p-24 * (2 + 0x1p-4) * 8;
  const glm::dvec3 face = (corners[0] + corners[1] + corners[2]) / 3.0, inwards = -face / glm::length(face);
  for (const auto& [deltas, expected] : {std::pair(5.9, Verdict::right), std::pair(6.1, Verdict::missed)}) {
    const glm::dvec3 p = face + deltas * delta * inwards;
    const SuiteCase of = one_ray(tetrahedron(), ray(p, corners[0] - p));
    CHECK(verdict_of(of, miss(), watertight_profile(NumberFormat::binary32)) == expected);
  }
}

TEST_CASE("the exact answer of a mesh whose shared vertices moved together is never off for who claims watertight") {
  std::size_t hits = 0, misses = 0, silent_misses = 0;
  const Family& family = *find_family("vertex");
  for (const NumberFormat format : {NumberFormat::binary32, NumberFormat::binary64}) {
    const Profile claimed = watertight_profile(format), silent = wide_profile(format);
    for (std::uint64_t seed = 0; seed < fewer_when_sanitized(20); ++seed) {
      Case the_case = generate(family, seed, 20);
      // Some origins a few δ from a face, on either side.
      conform::Random random(seed);
      const scene::Triangle& face = the_case.scene.shapes<scene::Triangle>()[0];
      const auto& [a, b, c] = face.vertices;
      const glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
      double longest = 0;
      for (const scene::Triangle& triangle : the_case.scene.shapes<scene::Triangle>())
        for (const glm::dvec3& vertex : triangle.vertices)
          for (int i = 0; i < 3; ++i) longest = std::max(longest, std::abs(vertex[i]));
      const double M = (2 + 0x1p-4) * longest, delta = (format == NumberFormat::binary32 ? 0x1p-20 : 0x1p-49) * M;
      for (int i = 0; i < 40; ++i) {
        const double of_b = random.uniform(0.1, 0.4), of_c = random.uniform(0.1, 0.4);
        const glm::dvec3 p = a + of_b * (b - a) + of_c * (c - a) + random.uniform(-8, 8) * delta * normal;
        const double side = random.sign();
        const glm::dvec3 along = side * normal + 0.5 * random.in_cube(1);
        const scene::Query query{ray(p, along), {}};
        the_case.rays.push_back(query);
      }
      const SuiteCase of = answered(family, the_case);
      Perturbation perturbation(seed, format);
      for (std::size_t i = 0; i < of.truths.size(); ++i) {
        silent_misses +=
            is_right(judge(of, i, miss(), silent).verdict) && judge(of, i, miss(), claimed).verdict == Verdict::missed;
        const auto check = [&](const std::optional<Claim>& claim) {
          if (!claim) return;
          (claim->outcome == Outcome::miss ? misses : hits) += 1;
          INFO(replay(family, seed, 20, i) << "\n" << text(of.the_case.rays[i]) << "\n" << shown(*claim));
          CHECK(is_right(judge(of, i, *claim, claimed).verdict));
        };
        check(perturbation.answer_of_mesh(of.the_case.scene, of.the_case.rays[i]));
        const auto of_all = perturbation.answer_of_mesh(of.the_case.scene, of.the_case.rays[i], M);
        if (of_all && of_all->outcome == Outcome::miss) check(of_all);
      }
    }
  }
  INFO(hits << " hits, " << misses << " misses, " << silent_misses << " misses are off by the claim alone");
  CHECK(hits > fewer_when_sanitized(1000));
  CHECK(misses > fewer_when_sanitized(100));
  CHECK(silent_misses > fewer_when_sanitized(100));
}

TEST_CASE("of a solid its discs and its wall are one, and from inside the profile says what is right") {
  scene::Scene scene;
  const scene::ElementRef wall = add(scene, scene::Cylinder{{0, 0, 0}, 1, {0, 0, 1}, 2});
  const scene::ElementRef base = add(scene, scene::Disc{{0, 0, 0}, 1, {0, 0, 1}});
  const scene::ElementRef top = add(scene, scene::Disc{{0, 0, 2}, 1, {0, 0, 1}});
  const scene::ElementRef floor = add(scene, scene::Plane{{0, 0, 10}, {0, 0, 1}});
  SuiteCase of = one_ray(std::move(scene), ray({0, 0, 1}, {0, 0, 1}));
  of.solids.push_back({wall, {base, top}});
  Profile profile = wide_profile(NumberFormat::binary64);
  CHECK(verdict_of(of, hit(1, wall), profile) == Verdict::wrong_element);
  profile.caps = Caps::solid;
  CHECK(verdict_of(of, hit(1, wall), profile) == Verdict::exact);
  CHECK(verdict_of(of, hit(9, floor), profile) == Verdict::wrong_element);
  CHECK(verdict_of(of, miss(), profile) == Verdict::missed);
  CHECK(verdict_of(of, hit(0, wall), profile) == Verdict::misplaced);
  profile.inside = Inside::nothing;
  CHECK(verdict_of(of, hit(9, floor), profile) == Verdict::right);
  CHECK(verdict_of(of, miss(), profile) == Verdict::missed);  // of the floor
  profile.inside = Inside::origin;
  CHECK(verdict_of(of, hit(0, wall), profile) == Verdict::right);
  CHECK(verdict_of(of, hit(1e-6, wall), profile) == Verdict::off);
  CHECK(verdict_of(of, hit(0.1, wall), profile) == Verdict::misplaced);
  CHECK(verdict_of(of, hit(1e-6, floor), profile) == Verdict::misplaced);
  CHECK(verdict_of(of, hit(0, floor), profile) == Verdict::misplaced);
  CHECK(verdict_of(of, miss(), profile) == Verdict::missed);
  profile.inside = Inside::undefined;
  CHECK(outside(of, 0, profile) == "a start inside");
  CHECK(verdict_of(of, hit(0, floor), profile) == Verdict::skipped);
  profile.caps = Caps::open;  // nothing is a solid then
  CHECK(outside(of, 0, profile).empty());
}

TEST_CASE("a disc that closes a solid is off by what its wall is off, and one of its own by less") {
  scene::Scene scene;
  const scene::ElementRef wall = add(scene, scene::Cone{{0, 0, 0}, 8, {0, 0, -1}, 0.5});
  const scene::ElementRef base = add(scene, scene::Disc{{0, 0, 0}, 4, {0, 0, -1}});
  const double delta = 16 * 0x1p-53 * 8;
  const auto down = [&](double x) {
    SuiteCase of = one_ray(scene, ray({x, 0, 8}, {0, 0, -1}));
    of.solids.push_back({wall, {base}});
    return of;
  };
  Profile open = wide_profile(NumberFormat::binary64), solid = open;
  solid.caps = Caps::solid;
  CHECK(verdict_of(down(0), hit(8 - 9 * delta, base), open) == Verdict::off);
  CHECK(verdict_of(down(0), hit(8 - 10.5 * delta, wall), solid) == Verdict::right);
  CHECK(verdict_of(down(0), hit(8 - 11.5 * delta, wall), solid) == Verdict::off);
  // Beyond the rim, which altura moves by k = 8 times as much.
  CHECK(verdict_of(down(4 + 16 * delta), hit(8, base), open) == Verdict::phantom);
  CHECK(verdict_of(down(4 + 16 * delta), hit(8, wall), solid) == Verdict::right);
  CHECK(verdict_of(down(4 - 16 * delta), miss(), solid) == Verdict::right);
  CHECK(verdict_of(down(4 - 19 * delta), miss(), solid) == Verdict::missed);
  CHECK(verdict_of(down(4 - 8 * delta), miss(), open) == Verdict::missed);
}

TEST_CASE("whatever the truth permits is right, in a suite of both kinds") {
  std::map<Ambiguity, std::size_t> ambiguities;
  std::size_t permitted = 0;
  for (const Caps caps : {Caps::open, Caps::solid}) {
    SuiteOptions options;
    options.caps = caps;
    for (const Family& family : families_of_few()) {
      for (std::uint64_t number = 0; number < std::min<std::uint64_t>(cases(options, family), 4); ++number) {
        SuiteCase of = suite_case(options, family, number);
        answer(of);
        for (std::size_t i = 0; i < of.truths.size(); ++i) {
          const auto check = [&](const Claim& claim) {
            for (const NumberFormat format : {NumberFormat::binary32, NumberFormat::binary64}) {
              Profile profile = wide_profile(format);
              profile.caps = caps;
              // An open element is asked of who knows no solids.
              if (!outside(of, i, profile).empty()) profile.caps = Caps::open;
              const Verdict verdict = judge(of, i, claim, profile).verdict;
              INFO(of.name() << " ray " << i << "\n"
                             << text(of.the_case.rays[i]) << "\n"
                             << text(of.truths[i].hit) << "\n"
                             << shown(claim) << ": " << name(verdict));
              CHECK((is_right(verdict) || verdict == Verdict::skipped));
            }
          };
          const ExactAnswer& truth = of.truths[i];
          ++ambiguities[truth.ambiguity];
          for (const scene::Hit& permissible : truth.permissible) {
            ++permitted;
            if (permissible.resultado == model::Resultado::miss) check(miss());
            for (const scene::ElementRef element : permissible.elementos) check(hit(permissible.t, element));
          }
          for (const scene::ElementRef element : truth.hit.elementos) check(hit(truth.hit.t, element));
        }
      }
    }
  }
  CHECK(permitted > 1000);
  CHECK(ambiguities.size() == 7);
}

TEST_CASE("a ray is outside a profile by a clause of it, and what the system says there is listed") {
  scene::Scene scene;
  add(scene, scene::Sphere{{0, 0, 5}, 1});
  add(scene, scene::Cylinder{{0, 0, 30}, 2, {0, 0, 1}, 3e9});
  const SuiteCase of = one_ray(std::move(scene), ray({0, 0, 0}, {0, 0, 0x1p-130}));
  const auto clause = [&](const auto& change) {
    Profile profile = wide_profile(NumberFormat::binary64);
    change(profile);
    return outside(of, 0, profile);
  };
  CHECK(clause([](Profile&) {}).empty());
  CHECK(clause([](Profile& p) { p.tipos = {model::Tipo::soy_esfera}; }) == "no cilindro");
  CHECK(clause([](Profile& p) { p.caps = Caps::solid; }) == "no open cilindro");
  CHECK(clause([](Profile& p) { p.format = NumberFormat::binary32; }) == "numbers of binary32");
  CHECK(clause([](Profile& p) { p.least_size = 1.5; }) == "a size at least 1.5");
  CHECK(clause([](Profile& p) { p.greatest_size = 1e9; }) == "a size at most 1000000000");
  CHECK(clause([](Profile& p) { p.greatest_coordinate = 29; }) == "a coordinate at most 29");
  CHECK(clause([](Profile& p) { p.greatest_t = 1e20; }) == "a distance at most 1e+20");
  CHECK(clause([](Profile& p) { p.least_t = 0x1p133; }).starts_with("a distance at least"));
  CHECK(clause([](Profile& p) { p.measure = Measure::length, p.least_t = 4.5; }) == "a distance at least 4.5");
  Profile profile = wide_profile(NumberFormat::binary64);
  profile.least_t = 0x1p133;
  const ClaimJudgement far = judge(of, 0, hit(0x1.8p132, sphere), profile);
  CHECK(far.verdict == Verdict::skipped);
  CHECK(far.otherwise == Verdict::far_root);
  CHECK_FALSE(judge(of, 0, {}, profile).otherwise.has_value());
}

TEST_CASE("a verdict is the same where everything is a power of two larger") {
  const auto scaled = [](const Case& of, int k) {
    const double by = std::ldexp(1, k);
    Case result;
    of.scene.for_each([&](scene::ElementRef element, auto shape) {
      scene::for_each_attribute<decltype(shape)>([&](const auto& attribute) {
        if (attribute.word == "vector" || attribute.word == "proporcion") return;
        auto& value = shape.*attribute.field;
        if constexpr (std::is_same_v<decltype(value), scene::Corners&>)
          for (glm::dvec3& corner : value) corner *= by;
        else
          value *= by;
      });
      result.scene.apply(scene::addition(of.scene.name(element), shape));
    });
    result.rays = of.rays;
    for (scene::Query& query : result.rays) query.rayo = ray(query.rayo.p().xyz() * by, query.rayo.v().xyz());
    return result;
  };
  std::map<Verdict, int> verdicts;
  conform::Random random(3);
  for (const char* name : {"generic", "disc", "edge", "tangent", "rim", "cap"}) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const Case of = generate(*find_family(name), seed, 20);
      const int k = random.integer(-60, 60);
      const SuiteCase here = answered(*find_family(name), of), there = answered(*find_family(name), scaled(of, k));
      for (std::size_t i = 0; i < here.truths.size(); ++i) {
        const scene::Hit& truth = here.truths[i].hit;
        if (truth.resultado != model::Resultado::hit) continue;
        // Nearer and nearer to the truth.
        for (int places = 0; places < 24; ++places) {
          const double t = truth.t * (1 + std::ldexp(random.uniform(-1, 1), -places));
          const Claim claim = hit(t, truth.elementos[0]), larger = hit(std::ldexp(t, k), truth.elementos[0]);
          const Verdict verdict = judge(here, i, claim, wide_profile(NumberFormat::binary32)).verdict;
          ++verdicts[verdict];
          CHECK(verdict == judge(there, i, larger, wide_profile(NumberFormat::binary32)).verdict);
        }
      }
    }
  }
  for (const Verdict verdict : {Verdict::right, Verdict::off, Verdict::misplaced}) CHECK(verdicts[verdict] > 50);
}
