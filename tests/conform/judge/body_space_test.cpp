#include "conform/judge/body_space.hpp"

#include "durero/conform/judge/judge.hpp"
#include "durero/conform/report/explanation.hpp"
#include "support/catch.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::conform;

namespace {

constexpr std::array<glm::dvec3, 3> boxed = {{{3, 0, 0}, {0, 2, 0}, {0, 0, 1}}};
constexpr std::array<glm::dvec3, 3> round_across = {{{1, 0, 0}, {0, 2, 0}, {0, 0, 1}}};

Point<Dyadic> point(double x, double y, double z) { return {x, y, z}; }

std::pair<double, double> ends(const AskedBody& body, const glm::dvec3& p, const glm::dvec3& v, double eta) {
  const BodyStretch of = stretch_in(body, test::ray(p, v), Dyadic(eta)).value();
  return {number::round_to_binary64(of.begin), number::round_to_binary64(of.end)};
}

using Ends = std::pair<double, double>;

SuiteCase asked(const AskedBody& body, const glm::dvec3& p, const glm::dvec3& v) {
  scene::Scene scene;
  REQUIRE(add_body(scene, model::Elemento("e0"), body));
  SuiteCase of{.family = &families_of_bodies().front(),
               .the_case = {std::move(scene), std::vector<scene::Query>(1, {test::ray(p, v), {}})}};
  of.bodies = {{of.the_case.scene.find("e0").value(), body}};
  answer(of);
  return of;
}

Verdict verdict(const SuiteCase& of, const Claim& claim) {
  Profile profile{.format = NumberFormat::binary64};
  for (std::size_t i = 0; i < body_count; ++i) profile.bodies.push_back(static_cast<BodyKind>(i));
  return judge(of, 0, claim, profile).verdict;
}
Claim hit(double t) {
  return {.outcome = Claim::Outcome::hit, .element = scene::ElementRef{scene::Sphere::tipo, 0}, .t = t};
}
Claim no_hit() { return {.outcome = Claim::Outcome::miss}; }

}  // namespace

TEST_CASE("a body moved out and in is met before and behind it") {
  const AskedBody box{BodyKind::caja, {0, 0, 10}, boxed};
  CHECK(ends(box, {}, {0, 0, 1}, 0) == Ends{9, 11});
  CHECK(ends(box, {}, {0, 0, 1}, 0.25) == Ends{8.75, 11.25});
  CHECK(ends(box, {}, {0, 0, 1}, -0.25) == Ends{9.25, 10.75});
  CHECK_FALSE(stretch_in(box, test::ray({}, {0, 0, 1}), Dyadic(-1.5)));
  CHECK_FALSE(stretch_in(box, test::ray({3.5, 0, 0}, {0, 0, 1}), Dyadic(0.25)));
  CHECK(stretch_in(box, test::ray({3.5, 0, 0}, {0, 0, 1}), Dyadic(0.75)));
  const AskedBody capsule{BodyKind::capsula, {0, 0, 10}, round_across};
  CHECK(ends(capsule, {0, 9, 10}, {0, -1, 0}, 0.5) == Ends{5.5, 12.5});
  CHECK(ends(capsule, {0, 0, 0}, {0, 0, 2}, -0.5) == Ends{4.75, 5.25});
  CHECK_FALSE(stretch_in(capsule, test::ray({}, {0, 0, 1}), Dyadic(-1.5)));
  const AskedBody ball{BodyKind::elipsoide, {0, 0, 10}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
  const auto [begin, end] = ends(ball, {}, {0, 0, 1}, 0.25);
  CHECK((begin <= 8.75 && begin > 8.5 && end >= 11.25 && end < 11.5));
  CHECK_FALSE(stretch_in(ball, test::ray({}, {0, 0, 1}), Dyadic(-1.5)));
}

TEST_CASE("a rounded box moved out and in has another radius, and is a box where none is left") {
  const AskedBody rounded{BodyKind::caja_redonda, {0, 0, 10}, boxed, 0.5};
  CHECK(ends(rounded, {}, {0, 0, 1}, 0) == Ends{8.5, 11.5});
  CHECK(ends(rounded, {}, {0, 0, 1}, 0.25) == Ends{8.25, 11.75});
  CHECK(ends(rounded, {}, {0, 0, 1}, -0.5) == Ends{9, 11});
  CHECK(ends(rounded, {}, {0, 0, 1}, -0.75) == Ends{9.25, 10.75});
  CHECK(ends(rounded, {3.6, 2, 0}, {0, 0, 1}, 0.5) == Ends{8.2, 11.8});
  CHECK(ends(rounded, {3.6, 0, 0}, {0, 0, 1}, 0.5) == Ends{8.2, 11.8});
  CHECK(ends(rounded, {0, 2.8, 0}, {0, 0, 1}, 0.5) == Ends{8.4, 11.6});
  CHECK(ends(rounded, {3.3, 2.3, 0}, {0, 0, 1}, 0.5).first == Approx(9 - std::sqrt(0.82)));
  CHECK_FALSE(stretch_in(rounded, test::ray({3.8, 2.8, 0}, {0, 0, 1}), Dyadic(0.5)));
  CHECK_FALSE(stretch_in(rounded, test::ray({3, 0, 0}, {0, 0, 1}), Dyadic(-0.75)));
  CHECK_FALSE(stretch_in(rounded, test::ray({}, {0, 0, 1}), Dyadic(-1.75)));
}

TEST_CASE("a point lies outside of a body, on it or inside") {
  const AskedBody box{BodyKind::caja, {}, boxed}, ball{BodyKind::elipsoide, {}, boxed},
      capsule{BodyKind::capsula, {}, round_across};
  CHECK(place_in(box, point(3, 1, 0), {}) == BodyPlace::surface);
  CHECK(place_in(box, point(3.25, 1, 0), {}) == BodyPlace::outside);
  CHECK(place_in(box, point(3.25, 1, 0), Dyadic(0.5)) == BodyPlace::inside);
  CHECK(place_in(box, point(2.75, 1, 0), Dyadic(-0.5)) == BodyPlace::outside);
  CHECK(place_in(ball, point(0, 2, 0), {}) == BodyPlace::surface);
  CHECK(place_in(ball, point(2, 1, 0), {}) == BodyPlace::inside);
  CHECK(place_in(capsule, point(0, 2, 0), {}) == BodyPlace::inside);
  CHECK(place_in(capsule, point(0, -3, 0), {}) == BodyPlace::surface);
  CHECK(place_in(capsule, point(1, 1, 0), {}) == BodyPlace::surface);
  CHECK(place_in(capsule, point(0.9, 2.9, 0), {}) == BodyPlace::outside);
}

TEST_CASE("the distance of a point is from the surface") {
  const AskedBody box{BodyKind::caja, {}, boxed}, ball{BodyKind::elipsoide, {}, boxed},
      capsule{BodyKind::capsula, {}, round_across};
  CHECK(distance_of_body(box, point(3.5, 0, 0), Dyadic(1)) == 0.5);
  CHECK(distance_of_body(box, point(0, 0, 0.75), Dyadic(2)) == 0.125);
  CHECK(distance_of_body(ball, point(0, 2.001, 0), Dyadic(1)) == Approx(0.001).epsilon(0.01));
  CHECK(distance_of_body(ball, point(0, 0, 0), Dyadic(1)) == 1);
  CHECK(distance_of_body(capsule, point(0, -3.5, 0), Dyadic(1)) == 0.5);
  CHECK(distance_of_body(capsule, point(1.25, 1, 0), Dyadic(1)) == 0.25);
  const AskedBody rounded{BodyKind::caja_redonda, {}, boxed, 0.5};
  CHECK(distance_of_body(rounded, point(3.75, 0, 0), Dyadic(1)) == 0.25);
  CHECK(distance_of_body(rounded, point(3.3, 2.4, 0), Dyadic(1)) == Approx(0).margin(1e-8));
  CHECK(distance_of_body(rounded, point(0, 0, 0.5), Dyadic(1)) == 1);
}

TEST_CASE("a body is one element: a ray through the edge of a box may not pass it") {
  const AskedBody box{BodyKind::caja, {0, 0, 10}, boxed};
  const SuiteCase at_edge = asked(box, {0, 10, 13}, {0, -1, -0.25});
  REQUIRE(at_edge.truths[0].hit.t == 8);
  CHECK(verdict(at_edge, hit(8)) == Verdict::exact);
  CHECK(verdict(at_edge, hit(std::nextafter(8, 9))) == Verdict::right);
  CHECK(verdict(at_edge, hit(8 + 1e-7)) == Verdict::off);
  CHECK(verdict(at_edge, hit(12)) == Verdict::far_root);
  CHECK(verdict(at_edge, no_hit()) == Verdict::missed);
}

TEST_CASE("what a ray misses by a rounding may be hit or not, and what it hits or misses by more may not") {
  const AskedBody box{BodyKind::caja, {0, 0, 10}, boxed};
  const SuiteCase beside = asked(box, {3 + 0x1p-51, 0, 0}, {0, 0, 1});
  CHECK(verdict(beside, no_hit()) == Verdict::exact);
  CHECK(verdict(beside, hit(9)) == Verdict::right);
  const SuiteCase along = asked(box, {3, 0, 0}, {0, 0, 1});
  CHECK(verdict(along, no_hit()) == Verdict::right);
  CHECK(verdict(along, hit(9)) != Verdict::off);
  const SuiteCase apart = asked(box, {3.001, 0, 0}, {0, 0, 1});
  CHECK(verdict(apart, hit(9)) == Verdict::phantom);
  const SuiteCase into = asked(box, {2.999, 0, 0}, {0, 0, 1});
  CHECK(verdict(into, no_hit()) == Verdict::missed);
  CHECK(verdict(into, hit(11)) == Verdict::far_root);
  CHECK(verdict(into, hit(9.5)) == Verdict::misplaced);
}

TEST_CASE("a system that has no such body is not asked about it") {
  const SuiteCase of = asked({BodyKind::capsula, {0, 0, 10}, round_across}, {}, {0, 0, 1});
  CHECK(outside(of, 0, {.bodies = {BodyKind::caja}}) == "no capsula");
  CHECK(outside(of, 0, {.bodies = {BodyKind::capsula}}).empty());
  CHECK(outside(of, 0, {.bodies = {BodyKind::capsula}, .greatest_size = 1.5}) == "a size at most 1.5");
  CHECK(outside(of, 0, {.bodies = {BodyKind::capsula}, .greatest_coordinate = 5}) == "a coordinate at most 5");
  const SuiteCase rounded = asked({BodyKind::caja_redonda, {0, 0, 10}, boxed, 0.5}, {}, {0, 0, 1});
  CHECK(outside(rounded, 0, {.bodies = {BodyKind::caja_redonda}}).empty());
  CHECK(outside(rounded, 0, {.bodies = {BodyKind::caja_redonda}, .least_size = 0.75}) == "a size at least 0.75");
}

TEST_CASE("the exact answer about a body is of the body, and not of what stands for it in the tables") {
  const SuiteCase through = asked({BodyKind::caja, {0, 0, 10}, boxed}, {}, {0, 0, 1});
  const std::string text = exact_answer(through, 0);
  CHECK(text.starts_with("the exact answer: e0 at t = 9\n"));
  CHECK(text.find("e0:\n  t = 9\n") != text.npos);
  CHECK(text.find("e0:\n  t = 11\n") != text.npos);
  CHECK(all_crossings(through.the_case.scene, through.the_case.rays[0]).size() == 2);
  const SuiteCase along = asked({BodyKind::caja, {0, 0, 10}, boxed}, {3, 0, 0}, {0, 0, 1});
  const auto stretch = all_crossings(along.the_case.scene, along.the_case.rays[0]);
  REQUIRE(stretch.size() == 1);
  CHECK(number::round_to_binary64(stretch[0].segment.begin.value()) == 9);
  CHECK(number::round_to_binary64(stretch[0].segment.end.value()) == 11);
  CHECK(along.truths[0].ambiguity == Ambiguity::in_surface);
  const SuiteCase beside = asked({BodyKind::elipsoide, {0, 0, 10}, boxed}, {3, 0, 0}, {0, 0, 1});
  CHECK(beside.truths[0].ambiguity == Ambiguity::tangent);
}

TEST_CASE("the truth within a range is the first crossing of a body there") {
  const SuiteCase of = asked({BodyKind::caja, {0, 0, 10}, boxed}, {}, {0, 0, 1});
  const SceneTruths truths(of.the_case.scene, 1);
  const scene::Query& ray = of.the_case.rays[0];
  CHECK(truths.within(ray, {0, 20}).hit.t == 9);
  CHECK(truths.within(ray, {9.5, 20}).hit.t == 11);
  CHECK(truths.within(ray, {9.5, 10}).hit.resultado == model::Resultado::miss);
  CHECK(truths.crossings(ray) == std::vector<double>{9, 11});
}
