#include "durero/conform/judge/minimise.hpp"

#include <bit>

#include "conform/judged.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::conform;

namespace {

Claim blind(const SuiteCase& of) { return test::claims_blind_to_small(of)[0]; }

Finding some_miss() {
  Tally tally;
  for (std::uint64_t number = 0; number < 4; ++number) {
    const SuiteCase of = test::answered_case("tiny", number);
    tally.add(of, test::claims_blind_to_small(of), test::profile_of_all());
  }
  return tally.families()[0].worst[static_cast<std::size_t>(Verdict::missed)].value();
}

int bits_of(double x) {
  if (x == 0) return 0;
  const auto fraction = std::bit_cast<std::uint64_t>(x) << 12U;
  return 53 - (fraction == 0 ? 52 : std::countr_zero(fraction) - 12);
}

}  // namespace

TEST_CASE("a failure keeps its verdict, one element and round numbers") {
  const Finding found = some_miss();
  std::size_t asked = 0;
  const Finding least = minimised(found, test::profile_of_all(), [&](const SuiteCase& of) {
    ++asked;
    return blind(of);
  });
  CHECK(least.judgement.verdict == Verdict::missed);
  CHECK(least.of.the_case.scene.size() == 1);
  CHECK(asked < 1000);
  CHECK(judge(least.of, 0, blind(least.of), test::profile_of_all()).verdict == Verdict::missed);
  const scene::Query& ray = least.of.the_case.rays[0];
  for (int i = 0; i < 3; ++i) {
    CHECK(bits_of(ray.rayo.p().xyz()[i]) <= 4);
    CHECK(bits_of(ray.rayo.v().xyz()[i]) <= 4);
  }
}

TEST_CASE("a failure that nothing rounder shares stays as it is") {
  const Finding found = some_miss();
  const auto right = [](const SuiteCase& of) { return test::right_claims(of)[0]; };
  const Finding least = minimised(found, test::profile_of_all(), right);
  CHECK(least.of.the_case.rays[0].rayo == found.of.the_case.rays[0].rayo);
  CHECK(least.of.the_case.scene.size() == found.of.the_case.scene.size());
}

TEST_CASE("a solid stays closed") {
  Profile profile = test::profile_of_all();
  profile.caps = Caps::solid;
  const SuiteOptions solids{.families = {}, .tipos = {model::Tipo::soy_cilindro}, .caps = Caps::solid};
  const SuiteCase of = test::answered_case("generic", 0, solids);
  const auto blind_to_all = [](const SuiteCase&) { return Claim{Claim::Outcome::miss}; };
  Tally tally;
  tally.add(of, Claims(of.the_case.rays.size(), blind_to_all(of)), profile);
  const Finding found = tally.families()[0].worst[static_cast<std::size_t>(Verdict::missed)].value();
  const Finding least = minimised(found, profile, blind_to_all);
  REQUIRE(least.of.solids.size() == 1);
  CHECK(least.of.solids[0].discs.size() == 2);
  CHECK(least.of.the_case.scene.size() == 3);
  const auto disc = least.of.the_case.scene.shapes<scene::Disc>()[0];
  CHECK(disc.radio == least.of.the_case.scene.shapes<scene::Cylinder>()[0].radio);
}

TEST_CASE("a failure on one face of many is made small with fewer questions than elements") {
  const Profile profile = test::profile_of_all();
  const SuiteCase of = test::answered_case("terrain", 0, {.rays = 64, .faces = 300});
  std::size_t ray = 0;
  while (of.truths[ray].ambiguity != Ambiguity::none || of.truths[ray].hit.elementos.empty()) ++ray;
  const std::string face = of.the_case.scene.name(of.truths[ray].hit.elementos[0]).name();
  std::size_t asked_of_many = 0;
  const Ask blind_to_face = [&](const SuiteCase& asked) {
    asked_of_many += asked.the_case.scene.size() > 32;
    const Claim right = test::right_claims(asked)[0];
    const bool is_face = right.element && asked.the_case.scene.name(*right.element).name() == face;
    return is_face ? Claim{Claim::Outcome::miss} : right;
  };
  const SuiteCase alone = with_ray_alone(of, ray);
  const Claim claim = blind_to_face(alone);
  const Finding least = minimised({alone, ray, claim, judge(alone, 0, claim, profile)}, profile, blind_to_face);
  CHECK(least.judgement.verdict == Verdict::missed);
  CHECK(least.of.the_case.scene.size() == 1);
  CHECK(asked_of_many < 60);
}
