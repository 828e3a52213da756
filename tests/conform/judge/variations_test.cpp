#include "durero/conform/judge/variations.hpp"

#include "conform/drafted.hpp"
#include "conform/judged.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::conform;

namespace {

const Profile all = test::profile_of_all();

double length_of(const SuiteCase& of) {
  const glm::dvec3 v = of.the_case.rays[0].rayo.v().xyz();
  return std::hypot(v.x, v.y, v.z);
}

}  // namespace

TEST_CASE("a failure that hangs on |v| is right with v/|v|, and says so") {
  const Ask misses_long = [](const SuiteCase& of) {
    return length_of(of) > 1.5 ? test::miss() : test::right_claims(of)[0];
  };
  const Finding finding = test::finding_of(test::sphere_case({0, 0, 0}, {0, 0, 2}), test::miss(), all);
  const std::vector<Variation> tried = variations(finding, all, misses_long);
  REQUIRE(tried.size() == 2);  // its size is near 1
  CHECK(variation_text(tried[0], Verdict::missed) == "With v/|v| for v it is right.");
  CHECK(length_of(tried[0].answered.of) == 1);
  CHECK(variation_text(tried[1], Verdict::off).ends_with(" it is missed."));
  CHECK(variation_text(tried[1], Verdict::missed) ==
        "With an origin that is eight times nearer to the first point it is missed as well.");
  CHECK(tried[1].answered.of.the_case.rays[0].rayo.p().xyz() == glm::dvec3(0, 0, 2.625));
}

TEST_CASE("a failure that hangs on the size is right where the scene is as large as 1, at the same t") {
  const SuiteCase of = test::drafted({{"e0", scene::Sphere{glm::dvec3(0, 0, 0x1p22), 0x1p20}}}, {0, 0, 0}, {0, 0, 1});
  const Ask misses_large = [](const SuiteCase& asked) {
    return asked.the_case.scene.shapes<scene::Sphere>()[0].radio > 1000 ? test::miss() : test::right_claims(asked)[0];
  };
  const std::vector<Variation> tried = variations(test::finding_of(of, test::miss(), all), all, misses_large);
  REQUIRE(tried.size() == 2);  // v is of unit length
  CHECK(variation_text(tried[0], Verdict::missed) ==
        "With the whole scene and the origin scaled by 2^-20 it is right.");
  CHECK(tried[0].answered.of.the_case.scene.shapes<scene::Sphere>()[0].radio == 1);
  CHECK(tried[0].answered.of.truths[0].hit.t == of.truths[0].hit.t);
}

TEST_CASE("what the profile does not cover is not tried") {
  Profile small = all;
  small.least_size = 4;
  const SuiteCase of = test::drafted({{"e0", scene::Sphere{glm::dvec3(0, 0, 64), 8}}}, {0, 0, 0}, {0, 0, 1});
  const Ask misses = [](const SuiteCase&) { return test::miss(); };
  for (const Variation& tried : variations(test::finding_of(of, test::miss(), all), small, misses))
    CHECK(tried.what.find("scaled") == tried.what.npos);
}
