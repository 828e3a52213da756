#include "durero/conform/report/fuzz_report.hpp"

#include <fmt/format.h>

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

FuzzReport report_of(const Fuzzing& fuzzing, const FuzzedCauses& causes) {
  return {.title = "Blind <1>",
          .version = "blind 1.0",
          .call = "durero conform fuzz blind --seed 1 --steps 1500",
          .seed = 1,
          .profile = all,
          .fuzzing = fuzzing,
          .causes = causes};
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
  const std::string text = fuzz_text(report_of(fuzzing, causes));
  CHECK(text.starts_with("1500 questions, "));
  CHECK(text.find("\nthe same again: durero conform fuzz blind --seed 1 --steps 1500\n") != text.npos);
  CHECK(text.find("\nThe element is small\n") != text.npos);
  CHECK(text.find("; right with the whole scene scaled to a size near 1\n    missed: expected ") != text.npos);
  CHECK(text.find("    in hexadecimal:\n") != text.npos);
  CHECK(text == fuzz_text(report_of(found(), fuzzed_causes(found(), all, blind, {}))));
}

TEST_CASE("a search is a page and JSON, with the same causes, questions and answers") {
  const Fuzzing fuzzing = found();
  FuzzReport report = report_of(fuzzing, fuzzed_causes(fuzzing, all, blind, {}));
  const FuzzedCause& first = report.causes.all[0];
  const std::string html = fuzz_html(report), json = fuzz_json(report);
  CHECK(json.starts_with("{\"format\":\"durero-search\",\"version\":1"));
  CHECK(json.find("\"title\":\"Blind <1>\",\"system_version\":\"blind 1.0\"") != json.npos);
  CHECK(json.find("\"steps\":1500,\"asked\":") != json.npos);
  CHECK(json.find(fmt::format("\"cause\":\"{}\",\"title\":\"{}\"", name(first.trait), first.title)) != json.npos);
  CHECK(json.find(fmt::format("\"failures\":{},\"step\":{}", first.alike, first.step)) != json.npos);
  CHECK(json.find("\"verdict\":\"missed\",\n\"least\":{\"question\":\"scene ") != json.npos);
  CHECK(json.find("\"excluded\":") != json.npos);
  CHECK(html.find("<h1>Blind &lt;1&gt;</h1>\n<p>1500 questions, ") != html.npos);
  CHECK(html.find("<pre>durero conform fuzz blind --seed 1 --steps 1500</pre>") != html.npos);
  CHECK(html.find(fmt::format("<h3>{}</h3>\n<p>{} failure", first.title, first.alike)) != html.npos);
  CHECK(html.find("<svg ") != html.npos);
  CHECK(html.find("have that answer: proved.") != html.npos);
  CHECK(html.ends_with("</body>\n</html>\n"));
  CHECK(html.find("stopped") == html.npos);
  report.is_stopped = true;
  CHECK(fuzz_html(report).find("<p>stopped, so that nothing is made small: 1500 questions") != html.npos);
  CHECK(fuzz_json(report).find("\"stopped\":true") != json.npos);
}

TEST_CASE("what is over the number or the time is said") {
  const Fuzzing fuzzing = found();
  const FuzzedCauses one = fuzzed_causes(fuzzing, all, blind, {.findings = 1});
  CHECK(one.all.size() == 1);
  CHECK(one.left_out == fuzzing.failing.size() - 1);
  const FuzzedCauses none = fuzzed_causes(fuzzing, all, blind, {.time = std::chrono::duration<double>(0)});
  CHECK(none.all.empty());
  CHECK(none.left_out == fuzzing.failing.size());
  const FuzzReport report = report_of(fuzzing, none);
  for (const std::string& text : {fuzz_text(report), fuzz_html(report)})
    CHECK(text.find(fmt::format("{} kinds were not examined", fuzzing.failing.size())) != text.npos);
  CHECK(fuzz_json(report).find(fmt::format("\"left_out\":{}", fuzzing.failing.size())) != std::string::npos);
}

TEST_CASE("of a search that was stopped the causes are guessed, and nobody is asked") {
  const Fuzzing fuzzing = found();
  const FuzzedCauses causes = guessed_causes(fuzzing, all);
  CHECK(causes.left_out == 0);
  std::uint64_t alike = 0;
  for (const FuzzedCause& cause : causes.all) alike += cause.alike;
  CHECK(alike == fuzzing.failures);
}
