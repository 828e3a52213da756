// The judgement on the first touch of a ball that is cast, and its exact answer.
#include "durero/conform/judge/cast_truth.hpp"

#include <fmt/core.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "conform/ask/words.hpp"
#include "conform/drafted.hpp"
#include "conform/faults/caster.hpp"
#include "conform/judge/ball.hpp"
#include "conform/judge/ball_candidates.hpp"
#include "conform/judged.hpp"
#include "durero/conform/ask/question.hpp"
#include "durero/conform/judge/explaining_data.hpp"
#include "durero/conform/judge/judge.hpp"
#include "durero/conform/judge/minimise.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::conform;
using Outcome = Claim::Outcome;
using test::CastFault;

namespace {

/// The case of these elements, along which a ball of the radius is cast.
SuiteCase cast(std::vector<Draft::Element> elements, const glm::dvec3& p, const glm::dvec3& v, double radius) {
  SuiteCase of = test::drafted(std::move(elements), p, v);
  of.question = QuestionKind::cast;
  of.ranges = {{.radio = radius}};
  answer(of);
  return of;
}

/// A ball of radius 1 about (0, 0, 9), on the way along z from (x, 0, 0).
SuiteCase at_ball(double x, double radius) {
  return cast({{"e0", scene::Sphere{glm::dvec3(0, 0, 9), 1}}}, {x, 0, 0}, {0, 0, 1}, radius);
}

Claim touch(double t, const std::optional<glm::dvec3>& contact = {},
            const std::optional<scene::ElementRef>& element = {}) {
  return {.outcome = Outcome::hit, .element = element, .t = t, .punto = contact};
}

Profile profile_of_casts() {
  Profile profile = test::profile_of_all();
  profile.touching = Touching::zero;
  return profile;
}

Verdict verdict(const SuiteCase& of, const Claim& claim, const Profile& profile = profile_of_casts()) {
  return judge(of, 0, claim, profile).verdict;
}

const scene::Triangle flat_triangle{{glm::dvec3(0, 0, 8), glm::dvec3(4, 0, 8), glm::dvec3(0, 4, 8)}};

/// The t of the exact first touch; nothing where there is none.
std::optional<double> first_t(const AskedShape& shape, const glm::dvec3& p, const glm::dvec3& v, double radius) {
  const SuiteCase of = cast({{"e0", shape}}, p, v, radius);
  const scene::Hit& hit = of.truths[0].hit;
  return hit.resultado == model::Resultado::hit ? std::optional(hit.t) : std::nullopt;
}

/// The failures of a program with that fault in the cases of families of spheres, planes and triangles.
std::size_t failures(CastFault fault, std::size_t* gross, std::size_t* rays = nullptr) {
  std::size_t failing = 0;
  Profile profile = profile_of_casts();
  profile.format = NumberFormat::binary32;
  profile.greatest_t = 1e30;
  profile.tipos = {model::Tipo::soy_esfera, model::Tipo::soy_plano, model::Tipo::soy_triangulo};
  const SuiteOptions options{.rays = 32, .tipos = profile.tipos, .question = QuestionKind::cast};
  for (const Family& family : families_of_few()) {
    for (std::uint64_t number = 0; number < cases(options, family); ++number) {
      SuiteCase of = suite_case(options, family, number);
      answer(of);
      ask_question(of, options);
      const CaseJudge of_case(of, profile);
      for (std::size_t ray = 0; ray < of.truths.size(); ++ray) {
        Claim claim = test::Caster(of, ray, fault).claim();
        if (claim.t) claim.t = static_cast<double>(static_cast<float>(*claim.t));
        if (claim.punto) claim.punto = glm::dvec3(glm::vec3(*claim.punto));
        const Verdict is = of_case.judge(ray, claim).verdict;
        failing += is_failure(is);
        if (gross != nullptr) *gross += is_gross(is);
        if (rays != nullptr) ++*rays;
        if (fault == CastFault::none && is_failure(is))
          FAIL_CHECK(of.name() << " ray " << ray << ": " << name(is) << ", R " << of.ranges[ray].radio << ", t "
                               << claim.t.value_or(-1) << ", expected " << of.truths[ray].hit.t);
      }
    }
  }
  return failing;
}

}  // namespace

TEST_CASE("a ball touches a sphere where their middles are as far apart as both radii") {
  CHECK(at_ball(0, 2).truths[0].hit.t == 6);
  CHECK(verdict(at_ball(0, 2), touch(6)) == Verdict::exact);
  CHECK(verdict(at_ball(0, 2), touch(6, glm::dvec3(0, 0, 8))) == Verdict::exact);
  CHECK(verdict(at_ball(0, 2), touch(std::nextafter(6, 7))) == Verdict::right);
  CHECK(verdict(at_ball(0, 2), touch(6.0001)) == Verdict::off);
  CHECK(verdict(at_ball(0, 2), touch(7)) == Verdict::far_root);
  CHECK(verdict(at_ball(0, 2), touch(5)) == Verdict::misplaced);
  CHECK(verdict(at_ball(0, 2), touch(-6)) == Verdict::misplaced);
  const SuiteCase behind = cast({{"e0", scene::Sphere{glm::dvec3(0, 0, -9), 1}}}, {0, 0, 0}, {0, 0, 1}, 2);
  CHECK(verdict(behind, touch(-6)) == Verdict::phantom);
  CHECK(verdict(at_ball(0, 2), touch(6, glm::dvec3(0, 0, 6))) == Verdict::off);
  CHECK(verdict(at_ball(0, 2), touch(6, glm::dvec3(0.001, 0, 8))) != Verdict::exact);
  CHECK(verdict(at_ball(0, 2), touch(std::nan(""))) == Verdict::non_finite);
  CHECK(verdict(at_ball(0, 2), test::miss()) == Verdict::missed);
  CHECK(verdict(at_ball(4, 2), test::miss()) == Verdict::exact);
  CHECK(verdict(at_ball(4, 2), touch(9)) == Verdict::phantom);
  // A ball that just touches, and one that just does not, may be answered in either way.
  CHECK(at_ball(3, 2).truths[0].hit.t == 9);
  CHECK(verdict(at_ball(3, 2), test::miss()) == Verdict::right);
  CHECK(verdict(at_ball(std::nextafter(3, 4), 2), touch(9)) == Verdict::right);
  CHECK(verdict(at_ball(3.0001, 2), touch(9)) == Verdict::phantom);
}

TEST_CASE("a ball inside a sphere touches its surface from there, and one that is as large touches at once") {
  const std::vector<Draft::Element> around = {{"e0", scene::Sphere{glm::dvec3(0, 0, 0), 8}}};
  const SuiteCase inside = cast(around, {0, 0, 0}, {0, 0, 2}, 3);
  CHECK(verdict(inside, touch(2.5, glm::dvec3(0, 0, 8))) == Verdict::exact);
  CHECK(verdict(inside, test::miss()) == Verdict::missed);
  CHECK(first_t(around[0].shape, {0, 0, 0}, {0, 0, 2}, 8) == 0);
  CHECK(first_t(around[0].shape, {0, 0, 0}, {0, 0, 2}, 100) == 0);
  Profile profile = profile_of_casts();
  profile.inside = Inside::origin;
  CHECK(verdict(inside, touch(0), profile) == Verdict::right);
  CHECK(verdict(inside, touch(0)) == Verdict::misplaced);
  profile.inside = Inside::nothing;
  CHECK(verdict(inside, test::miss(), profile) == Verdict::right);
  profile.inside = Inside::undefined;
  CHECK(judge(inside, 0, touch(0), profile).clause == "a start inside");
}

TEST_CASE("a ball touches a triangle by its face, an edge or a vertex") {
  const auto t = [](double x, double y) { return first_t(flat_triangle, {x, y, 0}, {0, 0, 1}, 2.5); };
  CHECK(t(1, 1) == 5.5);
  CHECK(t(1, -1.5) == 6);   // the edge: √(2.5² − 1.5²) = 2 before it
  CHECK(t(-1.5, -2) == 8);  // the vertex, at a distance of 2.5
  CHECK(t(-2, -1.5) == 8);
  CHECK(!t(-2, -1.6));
  CHECK(t(5.5, 0) == 6);                                              // the vertex at (4, 0)
  CHECK(first_t(flat_triangle, {1, 1, 16}, {0, 0, -1}, 2.5) == 5.5);  // from behind
  CHECK(first_t(flat_triangle, {1, 1, 9}, {0, 0, 1}, 2.5) == 0);
  CHECK(first_t(flat_triangle, {1, -10, 8}, {0, 1, 0}, 2.5) == 7.5);  // in its plane
  const SuiteCase of = cast({{"e0", flat_triangle}}, {1, -1.5, 0}, {0, 0, 1}, 2.5);
  CHECK(verdict(of, touch(6, glm::dvec3(1, 0, 8))) == Verdict::exact);
  CHECK(is_failure(verdict(of, touch(6, glm::dvec3(1, 0.5, 8)))));
  CHECK(is_failure(verdict(of, touch(5.5))));
  CHECK(is_failure(verdict(of, test::miss())));
}

TEST_CASE("a ball touches a plane, a disc and its rim, a cylinder, and a cone") {
  const scene::Plane plane{glm::dvec3(0, 0, 8), glm::dvec3(0, 0, 1)};
  CHECK(first_t(plane, {0, 0, 0}, {0, 0, 2}, 2) == 3);
  CHECK(first_t(plane, {0, 0, 10}, {0, 0, -2}, 1) == 0.5);
  CHECK(!first_t(plane, {0, 0, 0}, {0, 0, -1}, 2));
  CHECK(!first_t(plane, {0, 0, 0}, {1, 0, 0}, 2));
  const scene::Disc disc{glm::dvec3(0, 0, 8), 3, glm::dvec3(0, 0, 1)};
  CHECK(first_t(disc, {1, 0, 0}, {0, 0, 1}, 2) == 6);
  CHECK(first_t(disc, {4.5, 0, 0}, {0, 0, 1}, 2.5) == 6);  // the rim, 1.5 beside
  CHECK(first_t(disc, {0, -4.5, 0}, {0, 0, 1}, 2.5) == 6);
  CHECK(!first_t(disc, {6, 0, 0}, {0, 0, 1}, 2.5));
  CHECK(first_t(disc, {-20, 0, 8}, {1, 0, 0}, 7) == 10);  // a ball that is larger than the disc
  CHECK(first_t(disc, {5, 0, 0}, {0, 0, 1}, 10) == 0);
  const scene::Cylinder cylinder{glm::dvec3(0, 0, 0), 4, glm::dvec3(0, 0, 1), 10};
  CHECK(first_t(cylinder, {20, 0, 5}, {-1, 0, 0}, 2) == 14);
  CHECK(first_t(cylinder, {0, 0, 5}, {1, 0, 0}, 1) == 3);   // from inside
  CHECK(first_t(cylinder, {0, 0, -9}, {0, 0, 1}, 5) == 6);  // a rim: 4 beside the middle, 3 before it
  CHECK(!first_t(cylinder, {0, 0, -9}, {0, 0, 1}, 3));      // it fits through
  CHECK(first_t(cylinder, {5.5, 0, -9}, {0, 0, 1}, 2.5) == 7);
  CHECK(first_t(cylinder, {0, 0, -1}, {0, 0, -1}, 8) == 0);                   // a ball around the whole rim
  const scene::Cone cone{glm::dvec3(0, 0, 0), 0.75, glm::dvec3(0, 0, 1), 8};  // of the radius 6 at the base
  CHECK(first_t(cone, {0, 0, 20}, {0, 0, -1}, 2) == 10);                      // the apex
  CHECK(first_t(cone, {30, 0, 4}, {-1, 0, 0}, 4) == 22);                      // 3 + 4·√(1 + 0.75²) from the axis
  CHECK(first_t(cone, {0, 0, 0}, {0, 0, 1}, 2.4) == 4);    // from inside, as wide as 8 − 4·… leaves
  CHECK(first_t(cone, {30, 0, -3}, {-1, 0, 0}, 5) == 20);  // the rim
  const scene::TruncatedCone tronco{glm::dvec3(0, 0, 0), 3, 0.75, glm::dvec3(0, 0, 1), 4};
  CHECK(first_t(tronco, {0, 0, 20}, {0, 0, -1}, 5) == 12);  // the rim of the end, of radius 3 at 4
  CHECK(!first_t(tronco, {0, 0, 20}, {0, 0, -1}, 2.9));
  CHECK(first_t(tronco, {30, 0, 2}, {-1, 0, 0}, 2) == 23);
}

TEST_CASE("a ball that touches what it begins at is skipped, or answered with 0") {
  const SuiteCase of = cast({{"e0", flat_triangle}}, {1, 1, 7}, {0, 0, 1}, 2);
  CHECK(verdict(of, touch(0, glm::dvec3(1, 1, 8))) == Verdict::exact);
  CHECK(verdict(of, test::miss()) == Verdict::missed);
  CHECK(is_failure(verdict(of, touch(1))));
  CHECK(judge(of, 0, touch(0), test::profile_of_all()).clause == "a start in touch");
  const SuiteCase nearly = cast({{"e0", flat_triangle}}, {1, 1, 0}, {0, 0, 1}, std::nextafter(8, 7));
  CHECK(judge(nearly, 0, touch(0), test::profile_of_all()).clause == "a start in touch");
  const SuiteCase apart = cast({{"e0", flat_triangle}}, {1, 1, 0}, {0, 0, 1}, 7.999);
  CHECK(outside(apart, 0, test::profile_of_all()).empty());
}

TEST_CASE("a contact alone is judged, and an element alone") {
  Claim claim = touch(6, glm::dvec3(0, 0, 8));
  claim.t.reset();
  CHECK(verdict(at_ball(0, 2), claim) == Verdict::right);
  claim.punto = {0, 0, 10};
  CHECK(is_failure(verdict(at_ball(0, 2), claim)));
  claim.punto = {0, 0, 6};
  CHECK(is_failure(verdict(at_ball(0, 2), claim)));
  const scene::ElementRef first{scene::Sphere::tipo, 0}, second{scene::Sphere::tipo, 1};
  const SuiteCase two =
      cast({{"e0", scene::Sphere{glm::dvec3(0, 0, 9), 1}}, {"e1", scene::Sphere{glm::dvec3(2, 0, 12), 1}}}, {0, 0, 0},
           {0, 0, 1}, 2);
  CHECK(verdict(two, {.outcome = Outcome::hit, .element = first}) == Verdict::right);
  CHECK(verdict(two, {.outcome = Outcome::hit, .element = second}) == Verdict::wrong_element);
  CHECK(verdict(two, touch(12 - std::sqrt(5), {}, second)) == Verdict::wrong_element);
  CHECK(verdict(two, touch(6, {}, first)) == Verdict::exact);
}

TEST_CASE("limits, sizes and back faces of a profile hold for balls") {
  Profile profile = profile_of_casts();
  profile.greatest_t = 5.999;
  CHECK(judge(at_ball(0, 2), 0, touch(6), profile).clause == "a distance at most 5.999");
  profile.greatest_t = 6;
  CHECK(verdict(at_ball(0, 2), test::miss(), profile) == Verdict::right);
  profile.greatest_t = 6.001;
  CHECK(verdict(at_ball(0, 2), test::miss(), profile) == Verdict::missed);
  profile.greatest_size = 1.5;
  CHECK(judge(at_ball(0, 2), 0, touch(6), profile).clause == "a size at most 1.5");
  Profile culling = profile_of_casts();
  culling.back_faces = BackFaces::unseen;
  const SuiteCase back = cast({{"e0", flat_triangle}}, {1, 1, 0}, {0, 0, 1}, 2);  // its front looks along +z
  CHECK(verdict(back, test::miss(), culling) == Verdict::right);
  CHECK(verdict(back, touch(6), culling) == Verdict::exact);
  const SuiteCase front = cast({{"e0", flat_triangle}}, {1, 1, 16}, {0, 0, -1}, 2);
  CHECK(verdict(front, test::miss(), culling) == Verdict::missed);
  Profile lengths = profile_of_casts();
  lengths.measure = Measure::length;
  const SuiteCase fast = cast({{"e0", scene::Sphere{glm::dvec3(0, 0, 9), 1}}}, {0, 0, 0}, {0, 0, 4}, 2);
  CHECK(verdict(fast, touch(6), lengths) == Verdict::exact);
  CHECK(is_failure(verdict(fast, touch(1.5), lengths)));
}

TEST_CASE("a question of casts has a radius behind each ray, which is read back") {
  const SuiteCase of = at_ball(0, 2.5);
  const std::string text = question_text(of, Caps::open, std::vector<std::size_t>{0});
  CHECK(text.ends_with("casts 1\n0 0 0 0 0 1 2.5\n"));
  std::FILE* const file = std::tmpfile();
  std::fputs(text.c_str(), file);
  std::rewind(file);
  const std::optional<Question> read = QuestionReader(*file).next();
  std::fclose(file);
  REQUIRE(read);
  CHECK(read->kind == QuestionKind::cast);
  CHECK(read->ranges == std::vector<AskedRange>{{.radio = 2.5}});
}

TEST_CASE("radii are of every order, and balls just touch and just pass") {
  std::map<std::string, std::size_t> kinds;
  std::size_t rays = 0, in_touch = 0, misses = 0;
  for (const Family& family : families_of_few()) {
    for (const SuiteCase& of : test::asked_cases(family, QuestionKind::cast, NumberFormat::binary32, 2)) {
      for (std::size_t i = 0; i < of.truths.size(); ++i, ++rays) {
        CHECK(of.ranges[i].radio == static_cast<double>(static_cast<float>(of.ranges[i].radio)));
        in_touch += of.truths[i].hit.resultado == model::Resultado::hit && of.truths[i].hit.t == 0;
        misses += of.truths[i].hit.resultado == model::Resultado::miss;
      }
    }
  }
  CHECK(rays > 1000);
  CHECK(in_touch < rays / 2);
  CHECK(misses > rays / 25);
  CHECK(misses < rays / 2);
}

TEST_CASE("the elements that binary64 leaves out are touched by no ball") {
  const SuiteOptions options{.rays = 32, .faces = 200, .question = QuestionKind::cast};
  std::size_t touched = 0, left_out = 0;
  for (const Family& family : families_of_meshes()) {
    SuiteCase of = suite_case(options, family, 0);
    answer(of);
    ask_question(of, options);
    const scene::Scene& scene = of.the_case.scene;
    for (std::size_t ray = 0; ray < of.truths.size(); ray += 8) {
      const model::Rayo& rayo = of.the_case.rays[ray].rayo;
      const double radius = of.ranges[ray].radio;
      std::optional<BallTouch> first;
      scene.for_each([&](scene::ElementRef e, const auto&) {
        const auto found = first_touch(AskedElements(scene), e, rayo, radius);
        if (found && (!first || *found < *first)) first = found;
      });
      const scene::Hit& hit = of.truths[ray].hit;
      REQUIRE(first.has_value() == (hit.resultado == model::Resultado::hit));
      if (first) CHECK(hit.t == (first->root ? algebra::rounded_linear({}, 1, *first->root) : 0));
      touched += first.has_value();
      std::size_t visited = 0;
      BallWay(scene, rayo, radius).any_of([&] { return hit.t; }, [&](scene::ElementRef) { return ++visited, false; });
      left_out += scene.size() - visited;
    }
  }
  CHECK(touched > 15);
  CHECK(left_out > 2000);
}

TEST_CASE("right casters are right, and faults are seen") {
  std::size_t rays = 0, gross = 0;
  CHECK(failures(CastFault::none, &gross, &rays) == 0);
  CHECK(rays > 600);
  for (std::size_t i = 1; i < test::cast_fault_words.size(); ++i) {
    gross = 0;
    const std::size_t failing = failures(static_cast<CastFault>(i), &gross);
    INFO(test::cast_fault_words[i] << ": " << failing << " of " << rays << ", gross " << gross);
    CHECK(failing >= 5);
  }
}

TEST_CASE("a failing cast is made small, and is off by so much at least") {
  const Profile profile = profile_of_casts();
  const Ask of_ray = [](const SuiteCase& of) { return test::Caster(of, 0, CastFault::doubles_the_radius).claim(); };
  const SuiteCase of = cast({{"e0", scene::Sphere{glm::dvec3(0.3, 0.1, 9.7), 1.3}}, {"e1", flat_triangle}},
                            {0.1, 0.2, 0.3}, {0, 0, 1}, 0.7);
  const Finding finding = test::finding_of(of, of_ray(of), profile);
  REQUIRE(is_failure(finding.judgement.verdict));
  CHECK(explaining_data(finding, profile)->excluded >= 40);
  const Finding least = minimised(finding, profile, of_ray);
  CHECK(least.of.question == QuestionKind::cast);
  CHECK(least.of.the_case.scene.size() == 1);
  CHECK(least.of.ranges[0].radio == 0.5);
  CHECK(least.judgement.verdict == finding.judgement.verdict);
}
