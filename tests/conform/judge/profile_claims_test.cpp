// What a system claims besides: a larger error, backs that are not seen, and planes that are half-spaces.
#include "conform/drafted.hpp"
#include "conform/judged.hpp"
#include "durero/conform/judge/judge.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::conform;

namespace {

Verdict verdict(const SuiteCase& of, const Claim& claim, const Profile& profile) {
  return judge(of, 0, claim, profile).verdict;
}

/// Two triangles before the ray along z, the first of which shows its back where `is_back`.
SuiteCase triangles(bool is_back) {
  const glm::dvec3 a(-1, -1, 4), b(3, -1, 4), c(-1, 3, 4), up(0, 0, 2);
  const scene::Triangle first = is_back ? scene::Triangle{{a, b, c}} : scene::Triangle{{a, c, b}};
  return test::drafted({{"e0", first}, {"e1", scene::Triangle{{a + up, c + up, b + up}}}}, {0, 0, 0}, {0, 0, 1});
}

SuiteCase plane(const glm::dvec3& p) {
  return test::drafted({{"e0", scene::Plane{glm::dvec3(0, 0, 4), glm::dvec3(0, 0, 1)}}}, p, {0, 0, 1});
}

}  // namespace

TEST_CASE("a system that claims a larger error may be off by that") {
  const SuiteCase of = test::sphere_case({0, 0, 0}, {0, 0, 1});
  Profile profile = test::profile_of_all();
  CHECK(is_failure(verdict(of, test::hit_at(3 + 0x1p-40), profile)));
  profile.error = 1 << 13;
  CHECK(verdict(of, test::hit_at(3 + 0x1p-40), profile) == Verdict::right);
  CHECK(is_failure(verdict(of, test::hit_at(3 + 0x1p-30), profile)));
  CHECK(verdict(of, test::miss(), profile) == Verdict::missed);
}

TEST_CASE("a system that leaves backs unseen may miss them, and may see them") {
  Profile profile = test::profile_of_all();
  const SuiteCase back = triangles(true), front = triangles(false);
  CHECK(is_failure(verdict(back, test::hit_at(6), profile)));
  profile.back_faces = BackFaces::unseen;
  CHECK(verdict(back, test::hit_at(4), profile) == Verdict::exact);
  CHECK(verdict(back, test::hit_at(6), profile) == Verdict::right);
  CHECK(verdict(back, test::miss(), profile) == Verdict::missed);
  CHECK(is_failure(verdict(front, test::hit_at(6), profile)));
  CHECK(verdict(front, test::miss(), profile) == Verdict::missed);
  const glm::dvec3 along(0, 0, 1);
  const SuiteCase disc = test::drafted({{"e0", scene::Disc{glm::dvec3(0, 0, 4), 1, along}}}, {0, 0, 0}, along);
  const SuiteCase turned = test::drafted({{"e0", scene::Disc{glm::dvec3(0, 0, 4), 1, -along}}}, {0, 0, 0}, along);
  CHECK(verdict(disc, test::miss(), profile) == Verdict::right);
  CHECK(verdict(turned, test::miss(), profile) == Verdict::missed);
  CHECK(verdict(plane({0, 0, 0}), test::miss(), profile) == Verdict::right);
  CHECK(verdict(test::sphere_case({0, 0, 4}, along), test::miss(), profile) == Verdict::missed);
}

TEST_CASE("a watertight system that leaves backs unseen may leave a mesh") {
  Profile profile = test::profile_of_all();
  profile.watertight = true;
  const glm::dvec3 a(-1, -1, -1), b(3, -1, -1), c(-1, 3, -1), d(-1, -1, 3), p(-0.5, -0.5, -0.5);
  const SuiteCase of = test::drafted({{"f0", scene::Triangle{{a, c, b}}},
                                      {"f1", scene::Triangle{{a, b, d}}},
                                      {"f2", scene::Triangle{{a, d, c}}},
                                      {"f3", scene::Triangle{{b, c, d}}}},
                                     p, (b + c) / 2.0 - p);
  CHECK(verdict(of, test::miss(), profile) == Verdict::missed);
  profile.back_faces = BackFaces::unseen;
  CHECK(verdict(of, test::miss(), profile) == Verdict::right);
}

TEST_CASE("a plane that is a half-space has an inside") {
  Profile profile = test::profile_of_all();
  profile.inside = Inside::nothing;
  CHECK(verdict(plane({0, 0, 0}), test::miss(), profile) == Verdict::missed);
  profile.half_spaces = true;
  CHECK(verdict(plane({0, 0, 0}), test::miss(), profile) == Verdict::right);
  profile.inside = Inside::origin;
  CHECK(verdict(plane({0, 0, 0}), test::hit_at(0), profile) == Verdict::right);
  CHECK(is_failure(verdict(plane({0, 0, 0}), test::hit_at(1), profile)));
  profile.inside = Inside::undefined;
  CHECK(outside(plane({0, 0, 0}), 0, profile) == "a start inside");
  CHECK(outside(plane({0, 0, 9}), 0, profile).empty());
  profile.half_spaces = false;
  CHECK(outside(plane({0, 0, 0}), 0, profile).empty());
}
