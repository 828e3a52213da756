#include "conform/judge/torus.hpp"

#include "conform/judge/torus_space.hpp"
#include "conform/right_torus.hpp"
#include "durero/conform/judge/judge.hpp"
#include "durero/conform/random.hpp"
#include "durero/conform/report/explanation.hpp"
#include "durero/conform/report/tally.hpp"
#include "support/catch.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::conform;

namespace {

/// A ring of radius 2 in the plane of x and z, and a tube of radius 1.
const AskedBody torus{BodyKind::toro, {0, 0, 10}, {{{2, 0, 0}, {0, 1, 0}, {0, 0, 2}}}, 1};
constexpr scene::ElementRef the_torus{scene::Sphere::tipo, 0};

SuiteCase asked(const glm::dvec3& p, const glm::dvec3& v, QuestionKind question = QuestionKind::first) {
  scene::Scene scene;
  REQUIRE(add_body(scene, model::Elemento("e0"), torus));
  SuiteCase of{.family = &families_of_bodies().front(),
               .the_case = {std::move(scene), std::vector<scene::Query>(1, {test::ray(p, v), {}})},
               .question = question};
  of.bodies = {{the_torus, torus}};
  answer(of);
  return of;
}

Verdict verdict(const SuiteCase& of, const Claim& claim, Inside inside = Inside::exit_point) {
  const Profile profile{.format = NumberFormat::binary64, .bodies = {BodyKind::toro}, .inside = inside};
  return judge(of, 0, claim, profile).verdict;
}

Claim hits(const std::vector<double>& ts) {
  std::vector<Claim> all;
  for (const double t : ts) all.push_back({.outcome = Claim::Outcome::hit, .element = the_torus, .t = t});
  Claim first = all.front();
  first.behind.assign(all.begin() + 1, all.end());
  return first;
}
Claim no_hit() { return {.outcome = Claim::Outcome::miss}; }

std::vector<double> truths(const glm::dvec3& p, const glm::dvec3& v) {
  const SuiteCase of = asked(p, v, QuestionKind::all);
  std::vector<double> all;
  for (const scene::Hit& hit : of.truths[0].all) all.push_back(hit.t);
  return all;
}

using Numbers = std::vector<double>;

}  // namespace

TEST_CASE("a ray meets a torus up to four times") {
  CHECK(truths({0, 0, 0}, {0, 0, 1}) == Numbers{7, 9, 11, 13});
  CHECK(truths({0, 0, 0}, {0, 0, 2}) == Numbers{3.5, 4.5, 5.5, 6.5});
  CHECK(truths({2, -3, 10}, {0, 1, 0}) == Numbers{2, 4});
  CHECK(truths({0, -3, 10}, {0, 1, 0}).empty());
  CHECK(truths({0, 0, 10}, {0, 0, 1}) == Numbers{1, 3});
  CHECK(truths({0, 0, 8}, {0, 0, 1}) == Numbers{1, 3, 5});
  CHECK(truths({3.5, 0, 0}, {0, 0, 1}).empty());
  CHECK(truths({2, 0, 0}, {0, 0, 1}).size() == 2);
  CHECK(truths({0.5, 0.25, 0}, {0, 0, 1}).size() == 4);
}

TEST_CASE("a crossing of a torus is told in decimals") {
  const std::string text = exact_answer(asked({0.5, 0.25, 0}, {0, 0, 1}), 0);
  CHECK(text.starts_with("the exact answer: e0 at t = 7.07"));
  CHECK(text.find("e0:\n  t = 7.07") != text.npos);
  CHECK(text.size() < 1200);
}

TEST_CASE("a touching ray meets it once, and its answer is ambiguous") {
  CHECK(truths({3, 0, 0}, {0, 0, 1}) == Numbers{10});
  const SuiteCase equator = asked({3, 0, 0}, {0, 0, 1});
  CHECK(equator.truths[0].ambiguity == Ambiguity::tangent);
  CHECK(verdict(equator, no_hit()) == Verdict::right);
  CHECK(verdict(equator, hits({10})) == Verdict::exact);
  CHECK(truths({1, 0, 0}, {0, 0, 1}).size() == 3);
  CHECK(truths({0, 1, 0}, {0, 0, 1}) == Numbers{8, 12});
}

TEST_CASE("the crossings are those of the polynomial through five values") {
  Random random(1);
  const auto number = [&] { return random.uniform(-4, 4); };
  std::size_t some = 0;
  for (int i = 0; i < 300; ++i) {
    const model::Rayo rayo = test::ray({number(), number(), 10 + number()}, {number(), number(), number()});
    const std::vector<TubeRoot> roots = tube_roots(Torus(torus).along(rayo, 1));
    const auto expected = test::torus_crossings(torus, rayo);
    REQUIRE(roots.size() == expected.size());
    for (std::size_t k = 0; k < roots.size(); ++k)
      CHECK(number::round_to_binary64(crossing_at(roots[k])) == number::round_to_binary64(expected[k]));
    some += roots.size();
  }
  CHECK(some > 100);
}

TEST_CASE("answers about a torus are right within what data may be off, and no further") {
  const SuiteCase through = asked({0, 0, 0}, {0, 0, 1});
  CHECK(verdict(through, hits({7})) == Verdict::exact);
  CHECK(verdict(through, hits({std::nextafter(7, 8)})) == Verdict::right);
  CHECK(verdict(through, hits({7.0001})) == Verdict::off);
  CHECK(verdict(through, hits({7.5})) == Verdict::misplaced);
  for (const double t : {9.0, 11.0, 13.0}) CHECK(verdict(through, hits({t})) == Verdict::far_root);
  CHECK(verdict(through, no_hit()) == Verdict::missed);
  CHECK(verdict(asked({0, -3, 10}, {0, 1, 0}), hits({3})) == Verdict::phantom);
  CHECK(verdict(asked({3 + 0x1p-50, 0, 0}, {0, 0, 1}), hits({10})) == Verdict::right);
  CHECK(verdict(asked({3.001, 0, 0}, {0, 0, 1}), hits({10})) == Verdict::phantom);
  CHECK(verdict(asked({2.999, 0, 0}, {0, 0, 1}), no_hit()) == Verdict::missed);
  CHECK(verdict(asked({3 - 0x1p-51, 0, 0}, {0, 0, 1}), no_hit()) == Verdict::right);
}

TEST_CASE("a ray from inside the tube is from inside, and one from the hole is not") {
  const SuiteCase inside = asked({0, 0, 8}, {0, 0, 1}), hole = asked({0, 0, 10}, {0, 0, 1});
  CHECK(verdict(inside, hits({1})) == Verdict::exact);
  CHECK(verdict(inside, hits({0})) == Verdict::misplaced);
  CHECK(verdict(inside, hits({0}), Inside::origin) == Verdict::right);
  CHECK(verdict(inside, no_hit(), Inside::nothing) == Verdict::right);
  CHECK(verdict(hole, hits({1})) == Verdict::exact);
  CHECK(verdict(hole, no_hit(), Inside::nothing) == Verdict::missed);
  CHECK(is_failure(verdict(hole, hits({0}), Inside::origin)));
}

TEST_CASE("all hits of a torus are there once, and their number") {
  const SuiteCase through = asked({0, 0, 0}, {0, 0, 1}, QuestionKind::all);
  CHECK(verdict(through, hits({7, 9, 11, 13})) == Verdict::exact);
  CHECK(verdict(through, hits({7, 13})) == Verdict::missed);
  CHECK(verdict(through, hits({7, 9, 11, 13, 13})) == Verdict::right);  // a thin stretch may hold three
  CHECK(is_failure(verdict(through, hits({7, 9, 10, 11, 13}))));
  const SuiteCase counted = asked({0, 0, 0}, {0, 0, 1}, QuestionKind::count);
  const auto count = [&](std::uint64_t n) { return verdict(counted, {.outcome = Claim::Outcome::hit, .count = n}); };
  CHECK(count(4) == Verdict::exact);
  CHECK(count(3) == Verdict::wrong_count);
  CHECK(count(2) == Verdict::wrong_count);
}

TEST_CASE("a tube moved out and in bounds the stretches in which it may be met") {
  const auto stretches = torus_stretches(torus, test::ray({0, 0, 0}, {0, 0, 1}), Dyadic(0.25)).value();
  REQUIRE(stretches.size() == 4);
  const auto ends = [&](std::size_t i) {
    return std::pair(number::round_to_binary64(stretches[i].begin),
                     number::round_to_binary64(stretches[i].end.value()));
  };
  CHECK(ends(0) == std::pair(6.75, 7.25));
  CHECK(ends(1) == std::pair(8.75, 9.25));
  CHECK(ends(3) == std::pair(12.75, 13.25));
  const auto beside = torus_stretches(torus, test::ray({3.125, 0, 0}, {0, 0, 1}), Dyadic(0.25)).value();
  CHECK(beside.size() == 1);
  const auto at_end = torus_stretches(torus, test::ray({3.25, 0, 0}, {0, 0, 1}), Dyadic(0.25)).value();
  REQUIRE(at_end.size() == 1);
  CHECK(number::round_to_binary64(at_end[0].begin) == 10);
  CHECK(torus_stretches(torus, test::ray({3.5, 0, 0}, {0, 0, 1}), Dyadic(0.25))->empty());
  CHECK_FALSE(torus_stretches(torus, test::ray({0, 0, 0}, {0, 0, 1}), Dyadic(1.25)));
  const auto from_inside = torus_stretches(torus, test::ray({0, 0, 8.9}, {0, 0, 1}), Dyadic(0.25)).value();
  CHECK(number::sign(from_inside[0].begin) == 0);
}
