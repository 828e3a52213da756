#include "durero/conform/report/fuzz_report.hpp"

#include "conform/judged.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::conform;

namespace {

const Profile all = test::profile_of_all();

/// Misses what is smaller than 1/2, and is right elsewhere.
Claim blind(const SuiteCase& of) { return test::claims_blind_to_small(of)[0]; }

Fuzzing found() {
  return fuzz({.steps = 1500}, all, blind, [] { return true; });
}

}  // namespace

TEST_CASE("what fuzzing found has few causes, each with a small case and the call that finds it again") {
  const Fuzzing fuzzing = found();
  const FuzzedCauses causes = fuzzed_causes(fuzzing, all, blind, {});
  REQUIRE_FALSE(causes.all.empty());
  CHECK(causes.all.size() < fuzzing.failing.size());
  CHECK(causes.all[0].trait == Trait::small);
  CHECK(causes.all[0].least.finding.of.the_case.scene.size() == 1);
  CHECK(causes.all[0].verdicts.contains(Verdict::missed));
  const std::string text = fuzz_text(fuzzing, causes, all, "durero conform fuzz blind --seed 1 --steps 1500");
  CHECK(text.starts_with("1500 questions, "));
  CHECK(text.find("\nthe same again: durero conform fuzz blind --seed 1 --steps 1500\n") != text.npos);
  CHECK(text.find("\nThe element is small\n") != text.npos);
  CHECK(text.find("; right with the whole scene scaled to a size near 1\n    missed: expected ") != text.npos);
  CHECK(text.find("    in hexadecimal:\n") != text.npos);
  CHECK(text == fuzz_text(found(), fuzzed_causes(found(), all, blind, {}), all,
                          "durero conform fuzz blind --seed 1 --steps 1500"));
}

TEST_CASE("what is over the number or the time is said") {
  const Fuzzing fuzzing = found();
  const FuzzedCauses one = fuzzed_causes(fuzzing, all, blind, {.findings = 1});
  CHECK(one.all.size() == 1);
  CHECK(one.left_out == fuzzing.failing.size() - 1);
  const FuzzedCauses none = fuzzed_causes(fuzzing, all, blind, {.time = std::chrono::duration<double>(0)});
  CHECK(none.all.empty());
  CHECK(none.left_out == fuzzing.failing.size());
  CHECK(fuzz_text(fuzzing, none, all, "").find(" kinds were not examined") != std::string::npos);
}

TEST_CASE("of a search that was stopped the causes are guessed, and nobody is asked") {
  const Fuzzing fuzzing = found();
  const FuzzedCauses causes = guessed_causes(fuzzing, all);
  CHECK(causes.left_out == 0);
  std::uint64_t alike = 0;
  for (const FuzzedCause& cause : causes.all) alike += cause.alike;
  CHECK(alike == fuzzing.failures);
}
