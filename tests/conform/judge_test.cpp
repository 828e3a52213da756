#include "durero/conform/judge.hpp"

#include <fmt/core.h>

#include <array>
#include <map>

#include "hits.hpp"
#include "perturbed.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::conform;
using namespace durero::test;

namespace {

using Outcome = Claim::Outcome;

std::string text(const Claim& claim) {
  std::string said = claim.outcome == Outcome::hit ? "hit" : "no hit";
  if (claim.element) said += fmt::format(" {}#{}", model::name(claim.element->tipo), claim.element->index);
  if (claim.t) said += fmt::format(" t={:a}", *claim.t);
  if (claim.punto) said += fmt::format(" ({:a}, {:a}, {:a})", claim.punto->x, claim.punto->y, claim.punto->z);
  return said;
}

bool is_right(Verdict verdict) { return verdict == Verdict::exact || verdict == Verdict::right; }

}  // namespace

TEST_CASE("the exact answer of data within the declared backward error is never judged off") {
  std::map<Verdict, std::size_t> verdicts;
  std::size_t other_outcome = 0, moved = 0;
  for (const Family& family : families()) {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      const SuiteCase of = answered(family, generate(family, seed, 24));
      for (const Format format : {Format::binary32, Format::binary64}) {
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
            const Judgement judgement = judge(of, i, *claim, profile);
            ++verdicts[judgement.verdict];
            if (judgement.verdict == Verdict::skipped) continue;
            other_outcome += (claim->outcome == Outcome::hit) != (truth.resultado == model::Resultado::hit);
            moved += judgement.ulps > 1e3;
            INFO(replay(family, seed, 24, i) << "\n"
                                             << text(of.the_case.rays[i]) << "\n"
                                             << text(truth) << "\n"
                                             << text(*claim) << ": " << name(judgement.verdict));
            CHECK(is_right(judgement.verdict));
          }
        }
      }
    }
  }
  for (const auto& [verdict, count] : verdicts) fmt::print("{}: {}\n", name(verdict), count);
  fmt::print("another outcome: {}, off by more than a thousand ulps: {}\n", other_outcome, moved);
  CHECK(verdicts[Verdict::right] > 20'000);
  CHECK(other_outcome > 200);
  CHECK(moved > 200);
}
