// The judgement on the nearest point to a point.
#include <cmath>
#include <glm/geometric.hpp>

#include "conform/drafted.hpp"
#include "conform/judged.hpp"
#include "conform/mover.hpp"
#include "durero/conform/judge/explaining_data.hpp"
#include "durero/conform/judge/judge.hpp"
#include "durero/conform/judge/minimise.hpp"
#include "durero/distance/distances.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::conform;
using Outcome = Claim::Outcome;

namespace {

/// The case of these elements, asked for the nearest point to p.
SuiteCase near(std::vector<Draft::Element> elements, const glm::dvec3& p) {
  SuiteCase of = test::drafted(std::move(elements), p, {0, 0, 1});
  of.question = QuestionKind::closest;
  answer(of);
  return of;
}

/// A ball of radius 1 around (0, 0, 4).
SuiteCase ball(const glm::dvec3& p) { return near({{"e0", scene::Sphere{glm::dvec3(0, 0, 4), 1}}}, p); }

Claim nearest(double distance, const glm::dvec3& point, const std::optional<scene::ElementRef>& element = {}) {
  return {.outcome = Outcome::hit, .element = element, .t = distance, .punto = point};
}

Verdict verdict(const SuiteCase& of, const Claim& claim, const Profile& profile = test::profile_of_all()) {
  return judge(of, 0, claim, profile).verdict;
}

/// The exact nearest of a scene, rounded to a format.
Claim claim_of(const scene::Scene& scene, const glm::dvec3& p, NumberFormat format) {
  distance::DistanceWork work;
  const scene::Proximity is = distance::Distances(scene).nearest(p, work);
  const auto narrow = [&](double x) { return test::narrowed(x, format); };
  return nearest(narrow(is.distance), {narrow(is.point.x), narrow(is.point.y), narrow(is.point.z)},
                 is.elementos.front());
}

/// A fault of a program that finds nearest points.
struct NearestFault {
  const char* name;
  Claim (*plant)(const SuiteCase& of, const glm::dvec3& p, Claim right);
  std::size_t least;  ///< so many failures at least
};

glm::dvec3 centre_of(const SuiteCase& of, scene::ElementRef element) {
  return of.the_case.scene.visit(element, [](const auto& shape) {
    if constexpr (requires { shape.vertices; })
      return shape.vertices[0];
    else
      return shape.centro;
  });
}

const NearestFault nearest_faults[] = {
    {"says the square of the distance",
     [](const SuiteCase&, const glm::dvec3&, Claim claim) {
       *claim.t *= *claim.t;
       return claim;
     },
     100},
    {"says the distance from the centre",
     [](const SuiteCase& of, const glm::dvec3& p, Claim claim) {
       claim.t = glm::length(p - centre_of(of, *claim.element));
       return claim;
     },
     100},
    {"says the centre or a vertex",
     [](const SuiteCase& of, const glm::dvec3& p, Claim claim) {
       claim.punto = centre_of(of, *claim.element);
       claim.t = glm::length(p - *claim.punto);
       return claim;
     },
     100},
    {"is off by a ten thousandth",
     [](const SuiteCase&, const glm::dvec3&, Claim claim) {
       *claim.t *= 1.0001;
       return claim;
     },
     50},
    {"says the point itself",
     [](const SuiteCase&, const glm::dvec3& p, Claim claim) {
       claim.punto = p;
       return claim;
     },
     100},
    {"says 0 where it is nearer than 0.001",
     [](const SuiteCase&, const glm::dvec3& p, Claim claim) {
       return *claim.t < 1e-3 ? nearest(0, p, claim.element) : claim;
     },
     1},
    {"says nothing beyond 1000",
     [](const SuiteCase&, const glm::dvec3&, Claim claim) {
       return *claim.t > 1000 ? Claim{.outcome = Outcome::miss} : claim;
     },
     5},
    {"says a point beside the nearest",
     [](const SuiteCase&, const glm::dvec3& p, Claim claim) {
       const glm::dvec3 way = *claim.punto - p;
       *claim.punto += 1e-3 * glm::dvec3(-way.y, way.x, 0);
       return claim;
     },
     50},
    {"says the first element",
     [](const SuiteCase& of, const glm::dvec3& p, Claim claim) {
       std::optional<scene::ElementRef> first;
       of.the_case.scene.for_each([&](scene::ElementRef e, const auto&) { first = first ? first : e; });
       const scene::Proximity is = distance::nearest_of(of.the_case.scene, *first, p);
       claim = nearest(is.distance, is.point, first);
       return claim;
     },
     20},
};

/// The failures of a program with that fault, or of a right one, in some cases of each family.
std::size_t failures(const NearestFault* fault, std::size_t* rays = nullptr) {
  std::size_t failing = 0;
  const Profile profile = test::profile_of_all();
  for (const Family& family : families_of_few()) {
    for (const SuiteCase& of : test::asked_cases(family, QuestionKind::closest, NumberFormat::binary32, 1)) {
      const CaseJudge of_case(of, profile);
      for (std::size_t ray = 0; ray < of.truths.size(); ray += 2) {  // roots of quartics take their time
        const glm::dvec3 p = of.the_case.rays[ray].rayo.p().xyz();
        Claim claim = claim_of(of.the_case.scene, p, NumberFormat::binary64);
        if (fault != nullptr) claim = fault->plant(of, p, claim);
        failing += is_failure(of_case.judge(ray, claim).verdict);
        if (rays != nullptr) ++*rays;
      }
    }
  }
  return failing;
}

}  // namespace

TEST_CASE("the nearest point and its distance are right together") {
  CHECK(verdict(ball({0, 0, 0}), nearest(3, {0, 0, 3})) == Verdict::exact);
  CHECK(verdict(ball({0, 0, 0}), nearest(std::nextafter(3, 4), {0, 0, 3})) == Verdict::right);
  CHECK(verdict(ball({0, 0, 0}), nearest(3.0005, {0, 0, 3})) == Verdict::off);
  CHECK(verdict(ball({0, 0, 0}), nearest(4, {0, 0, 4})) == Verdict::misplaced);
  CHECK(verdict(ball({0, 0, 0}), nearest(5, {0, 0, 5})) == Verdict::misplaced);
  CHECK(verdict(ball({0, 0, 0}), nearest(2, {0, 0, 2})) == Verdict::misplaced);
  CHECK(is_failure(verdict(ball({0, 0, 0}), nearest(3, {0.001, 0, 3}))));
  CHECK(verdict(ball({0, 0, 0}), nearest(std::nan(""), {0, 0, 3})) == Verdict::non_finite);
  CHECK(verdict(ball({0, 0, 0}), test::miss()) == Verdict::missed);
  CHECK(verdict(ball({0, 0, 4.5}), nearest(0.5, {0, 0, 5})) == Verdict::exact);
  CHECK(verdict(ball({0, 0, 4.5}), nearest(1.5, {0, 0, 3})) == Verdict::misplaced);
}

TEST_CASE("from a centre each point of the sphere is the nearest") {
  CHECK(verdict(ball({0, 0, 4}), nearest(1, {0, 0, 5})) == Verdict::right);
  CHECK(verdict(ball({0, 0, 4}), nearest(1, {1, 0, 4})) == Verdict::right);
  CHECK(is_failure(verdict(ball({0, 0, 4}), nearest(1, {1, 1, 4}))));
}

TEST_CASE("a distance or a point alone is judged, and an element without either") {
  Claim claim = nearest(3, {0, 0, 3});
  claim.punto.reset();
  CHECK(verdict(ball({0, 0, 0}), claim) == Verdict::exact);
  claim.t = 4;
  CHECK(verdict(ball({0, 0, 0}), claim) == Verdict::misplaced);
  claim = nearest(3, {0, 0, 3});
  claim.t.reset();
  CHECK(verdict(ball({0, 0, 0}), claim) == Verdict::exact);
  claim.punto = {0, 0, 5};
  CHECK(verdict(ball({0, 0, 0}), claim) == Verdict::misplaced);
  const scene::ElementRef first{scene::Sphere::tipo, 0}, second{scene::Sphere::tipo, 1};
  const SuiteCase two =
      near({{"e0", scene::Sphere{glm::dvec3(0, 0, 4), 1}}, {"e1", scene::Sphere{glm::dvec3(0, 0, -9), 1}}}, {0, 0, 0});
  CHECK(verdict(two, {.outcome = Outcome::hit, .element = first}) == Verdict::right);
  CHECK(verdict(two, {.outcome = Outcome::hit, .element = second}) == Verdict::wrong_element);
  CHECK(verdict(two, nearest(8, {0, 0, -8}, second)) == Verdict::wrong_element);
  CHECK(verdict(two, nearest(3, {0, 0, 3}, second)) == Verdict::wrong_element);
}

TEST_CASE("the nearest point of a flat element is its foot, an edge, a vertex or the rim") {
  const scene::Triangle triangle{{glm::dvec3(0, 0, 0), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)}};
  const auto of_triangle = [&](const glm::dvec3& p, const glm::dvec3& q) {
    return verdict(near({{"e0", triangle}}, p), nearest(glm::length(p - q), q));
  };
  CHECK_FALSE(is_failure(of_triangle({0.25, 0.25, 2}, {0.25, 0.25, 0})));
  CHECK(is_failure(of_triangle({0.25, 0.25, 2}, {0.2501, 0.25, 0})));
  CHECK_FALSE(is_failure(of_triangle({0.5, -1, 0}, {0.5, 0, 0})));
  CHECK(is_failure(of_triangle({0.5, -1, 0}, {0.50001, 0, 0})));
  CHECK_FALSE(is_failure(of_triangle({2, -1, 1}, {1, 0, 0})));
  const scene::Disc disc{glm::dvec3(0, 0, 0), 1, glm::dvec3(0, 0, 1)};
  const auto of_disc = [&](const glm::dvec3& p, const glm::dvec3& q) {
    return verdict(near({{"e0", disc}}, p), nearest(glm::length(p - q), q));
  };
  CHECK_FALSE(is_failure(of_disc({0.5, 0, 2}, {0.5, 0, 0})));
  CHECK(is_failure(of_disc({0.5, 0, 2}, {0.50001, 0, 0})));
  CHECK_FALSE(is_failure(of_disc({3, 0, 2}, {1, 0, 0})));
  CHECK(is_failure(of_disc({3, 0, 2}, {std::cos(1e-4), std::sin(1e-4), 0})));
  const scene::Plane plane{glm::dvec3(0, 0, 1), glm::dvec3(0, 0, 1)};
  const auto of_plane = [&](const glm::dvec3& p, const glm::dvec3& q) {
    return verdict(near({{"e0", plane}}, p), nearest(glm::length(p - q), q));
  };
  CHECK_FALSE(is_failure(of_plane({7, 8, 4}, {7, 8, 1})));
  CHECK(is_failure(of_plane({7, 8, 4}, {7.000001, 8, 1})));
}

TEST_CASE("inside a solid a system may answer the point itself, where it says so") {
  Profile profile = test::profile_of_all();
  CHECK(is_failure(verdict(ball({0, 0, 4.5}), nearest(0, {0, 0, 4.5}), profile)));
  profile.inside = Inside::origin;
  CHECK(verdict(ball({0, 0, 4.5}), nearest(0, {0, 0, 4.5}), profile) == Verdict::right);
  CHECK(is_failure(verdict(ball({0, 0, 4.5}), nearest(0.25, {0, 0, 4.5}), profile)));
  CHECK(is_failure(verdict(ball({0, 0, 0}), nearest(0, {0, 0, 0}), profile)));
}

TEST_CASE("a distance without a name may be that of an element that some data have nearer") {
  const SuiteCase of = near(
      {{"e0", scene::Sphere{glm::dvec3(0, 0, 10.999), 1}}, {"e1", scene::Sphere{glm::dvec3(0, 0, -1e12), 1e12 - 10}}},
      {0, 0, 0});
  Claim alone{.outcome = Outcome::hit, .t = 9.995};
  CHECK(verdict(of, alone) == Verdict::right);
  alone.t = 9.98;
  CHECK(is_failure(verdict(of, alone)));
}

TEST_CASE("what may be beyond a limit of the profile need not be found") {
  Profile profile = test::profile_of_all();
  profile.greatest_t = 3;
  CHECK(verdict(ball({0, 0, 0}), test::miss(), profile) == Verdict::right);
  CHECK(verdict(ball({0, 0, 0}), nearest(3, {0, 0, 3}), profile) == Verdict::exact);
  profile.greatest_t = 3.0000001;
  CHECK(verdict(ball({0, 0, 0}), test::miss(), profile) == Verdict::missed);
  profile.greatest_t = std::numeric_limits<double>::infinity();
  const scene::ElementRef second{scene::Sphere::tipo, 1};
  const SuiteCase two =
      near({{"e0", scene::Sphere{glm::dvec3(0, 0, 4), 1}}, {"e1", scene::Sphere{glm::dvec3(0, 0, -9), 1}}}, {0, 0, 0});
  profile.least_t = 3;
  CHECK(verdict(two, nearest(8, {0, 0, -8}, second), profile) == Verdict::right);
  CHECK(verdict(two, test::miss(), profile) == Verdict::right);
  Claim alone{.outcome = Outcome::hit, .element = second};
  CHECK(verdict(two, alone, profile) == Verdict::right);
  profile.least_t = 2.9999999;
  CHECK(verdict(two, nearest(8, {0, 0, -8}, second), profile) == Verdict::wrong_element);
  CHECK(verdict(two, test::miss(), profile) == Verdict::missed);
  CHECK(verdict(two, alone, profile) == Verdict::wrong_element);
  profile.inside = Inside::origin;
  profile.least_t = 0.25;
  CHECK(verdict(ball({0, 0, 4.5}), test::miss(), profile) == Verdict::right);
  profile.inside = Inside::exit_point;
  CHECK(verdict(ball({0, 0, 4.5}), test::miss(), profile) == Verdict::missed);
}

TEST_CASE("a question for nearest points has the points alone, and its rays go to the nearest") {
  const SuiteCase of = test::asked_cases(*find_family("generic"), QuestionKind::closest, NumberFormat::binary32, 1)[0];
  for (std::size_t i = 0; i < of.truths.size(); ++i) {
    const model::Rayo& rayo = of.the_case.rays[i].rayo;
    const scene::Hit& hit = of.truths[i].hit;
    CHECK(glm::length(rayo.p().xyz() + hit.t * rayo.v().xyz() - hit.punto) <= 1e-9 * (1 + hit.t));
  }
}

TEST_CASE("right nearest points are right, and faults are seen") {
  std::size_t rays = 0;
  CHECK(failures(nullptr, &rays) == 0);
  CHECK(rays > 250);
  for (const NearestFault& fault : nearest_faults) {
    const std::size_t failing = failures(&fault);
    INFO(fault.name << ": " << failing << " of " << rays);
    CHECK(failing >= fault.least);
  }
}

TEST_CASE("a failing nearest point is made small, and is off by so much at least") {
  const Profile profile = test::profile_of_all();
  const Ask centre = [](const SuiteCase& of) {
    const glm::dvec3 p = of.the_case.rays[0].rayo.p().xyz();
    const scene::ElementRef first = of.truths[0].hit.elementos.front();
    return nearest(glm::length(p - centre_of(of, first)), centre_of(of, first), first);
  };
  const SuiteCase of = ball({0.3, 0.4, 0.5});
  const Finding finding = test::finding_of(of, centre(of), profile);
  REQUIRE(is_failure(finding.judgement.verdict));
  CHECK(explaining_data(finding, profile)->excluded >= 40);
  const Finding least = minimised(finding, profile, centre);
  CHECK(least.of.question == QuestionKind::closest);
  CHECK(least.judgement.verdict == finding.judgement.verdict);
}
