// The judge of a whole case: what it finds once for the scene changes no verdict.
#include <cmath>
#include <limits>

#include "conform/judge/closed_mesh.hpp"
#include "conform/judged.hpp"
#include "conform/perturbed.hpp"
#include "durero/conform/judge/judge.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::conform;
using namespace durero::test;

namespace {

/// Claims of each kind about a ray: right, another element, another place, a miss, without a name, without a number.
std::vector<Claim> claims_about(const SuiteCase& of, std::size_t ray) {
  const Claim right = right_claim(of.truths[ray]);
  const auto faces = static_cast<std::uint32_t>(of.the_case.scene.size());
  Claim other = right, beyond = right, nameless = right, beside = right, bare = right;
  const Claim miss{.outcome = Claim::Outcome::miss};
  const Claim hit{.outcome = Claim::Outcome::hit, .element = scene::ElementRef{scene::Triangle::tipo, 0}, .t = 1.0};
  if (!right.element) return {right, hit};
  other.element->index = (other.element->index + 1) % faces;
  beyond.t = *right.t * 1.5;
  nameless.element.reset();
  beside = nameless;
  beside.t = *right.t * (1 + 0x1p-20);
  bare.t.reset();
  return {right, other, beyond, nameless, beside, bare, miss};
}

}  // namespace

TEST_CASE("the verdicts on all rays of a mesh are those on each alone") {
  std::array<std::size_t, verdict_count> seen{};
  for (const char* name : {"mesh_solid", "mesh_inside", "needles", "seams", "box_faces", "nested", "stack"}) {
    const SuiteCase of = answered_case(name, 0, {.rays = 24, .faces = 120});
    for (const bool is_watertight : {false, true}) {
      Profile profile = profile_of_all();
      profile.watertight = is_watertight;
      profile.format = NumberFormat::binary32;
      const CaseJudge judge_of(of, profile);
      for (std::size_t ray = 0; ray < of.truths.size(); ++ray) {
        for (const Claim& claim : claims_about(of, ray)) {
          const ClaimJudgement whole = judge_of.judge(ray, claim);
          const ClaimJudgement alone = judge(with_ray_alone(of, ray), 0, claim, profile);
          INFO(of.name() << " ray " << ray << ": " << conform::name(whole.verdict) << ", alone "
                         << conform::name(alone.verdict));
          CHECK(whole.verdict == alone.verdict);
          CHECK(whole.ulps == alone.ulps);
          CHECK(whole.backward == alone.backward);
          ++seen[static_cast<std::size_t>(whole.verdict)];
        }
      }
    }
  }
  for (const Verdict verdict : {Verdict::exact, Verdict::right, Verdict::missed, Verdict::wrong_element,
                                Verdict::phantom, Verdict::misplaced, Verdict::off})
    CHECK(seen[static_cast<std::size_t>(verdict)] > 0);
}

TEST_CASE("a place beside the boxes of faces is judged alike with a name and without one") {
  const SuiteCase of = answered_case("box_faces", 0, {.rays = 128, .faces = 120});
  Profile profile = profile_of_all();
  profile.format = NumberFormat::binary32;
  const CaseJudge judge_of(of, profile);
  std::size_t hits = 0;
  for (std::size_t ray = 0; ray < of.truths.size(); ++ray) {
    Claim claim = right_claim(of.truths[ray]);
    if (!claim.element) continue;
    claim.punto.reset();
    const double t = *claim.t;
    for (const double ulps : {1.0, 3.0, 5.0, 7.0}) {
      claim.t = t * (1 + std::ldexp(ulps, -24));
      claim.element = right_claim(of.truths[ray]).element;
      const Verdict named = judge_of.judge(ray, claim).verdict;
      claim.element.reset();
      const Verdict nameless = judge_of.judge(ray, claim).verdict;
      INFO(of.name() << " ray " << ray << ": " << conform::name(named) << ", without a name "
                     << conform::name(nameless));
      CHECK(nameless == named);
    }
    ++hits;
  }
  CHECK(hits > 20);
}

TEST_CASE("claims on all rays are judged in order, and clauses are those of each ray") {
  SuiteCase of = answered_case("mesh_solid", 1, {.rays = 600});
  const std::vector<scene::Query> rays = of.the_case.rays;
  const std::vector<ExactAnswer> truths = of.truths;
  for (int turn = 0; turn < 20; ++turn) {  // so many that they are judged in several blocks
    of.the_case.rays.insert(of.the_case.rays.end(), rays.begin(), rays.end());
    of.truths.insert(of.truths.end(), truths.begin(), truths.end());
  }
  Claims claims = right_claims(of);
  claims[3] = {.outcome = Claim::Outcome::crashed};
  Profile profile = profile_of_all();
  profile.greatest_t = 1;
  const CaseJudge judge_of(of, profile);
  const std::vector<ClaimJudgement> all = judge_of.judge(claims);
  const std::vector<std::string> clauses = judge_of.outside();
  REQUIRE(all.size() == claims.size());
  REQUIRE(clauses.size() == claims.size());
  for (std::size_t ray = 0; ray < claims.size(); ++ray) {
    CHECK(all[ray].verdict == judge_of.judge(ray, claims[ray]).verdict);
    CHECK(clauses[ray] == outside(of, ray, profile));
    CHECK(all[ray].clause == clauses[ray]);
  }
  CHECK((all[3].verdict == Verdict::crashed || !clauses[3].empty()));
  profile.tipos = {model::Tipo::soy_esfera};
  CHECK(CaseJudge(of, profile).outside(0) == "no triangulo");
}

TEST_CASE("a miss from inside a closed mesh of many faces is gross of a watertight system alone") {
  const SuiteCase of = answered_case("mesh_inside", 2, {.rays = 256, .faces = 5000});
  const Claims misses(of.truths.size(), Claim{.outcome = Claim::Outcome::miss});
  Profile profile = profile_of_all();
  const auto count_missed = [&] {
    std::size_t missed = 0;
    for (const ClaimJudgement& is : CaseJudge(of, profile).judge(misses)) missed += is.verdict == Verdict::missed;
    return missed;
  };
  const std::size_t open = count_missed();
  profile.watertight = true;
  const std::size_t closed = count_missed();
  CHECK(open < of.truths.size());
  CHECK(closed > open);
  CHECK(closed > of.truths.size() * 9 / 10);
}
