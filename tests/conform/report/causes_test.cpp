#include "durero/conform/report/causes.hpp"

#include "conform/judged.hpp"
#include "durero/conform/report/least_findings.hpp"
#include "durero/io/json/json.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::conform;

namespace {

double length_of(const SuiteCase& of, std::size_t ray) {
  const glm::dvec3 v = of.the_case.rays[ray].rayo.v().xyz();
  return std::hypot(v.x, v.y, v.z);
}

/// Misses rays whose v is long; says of small elements that they are met later.
Claims long_and_small(const SuiteCase& of) {
  Claims claims = test::claims_blind_to_small(of);
  for (std::size_t ray = 0; ray < claims.size(); ++ray) {
    if (length_of(of, ray) > 1.5) claims[ray] = {Claim::Outcome::miss};
  }
  return claims;
}

Report failing_report() {
  Report report{.title = "Long", .asked = "long", .profile = test::profile_of_all()};
  for (const char* family : {"generic", "tiny", "scale"}) {
    for (std::uint64_t number = 0; number < 6; ++number) {
      const SuiteCase of = test::answered_case(family, number);
      report.tally.add(of, long_and_small(of), report.profile);
    }
  }
  return report;
}

Report explained_report() {
  Report report = failing_report();
  const Ask ask = [](const SuiteCase& of) { return long_and_small(of)[0]; };
  minimise_findings(report, ask, {});
  find_causes(report, ask, {});
  return report;
}

const Cause* with(const Report& report, Trait trait) {
  const auto found = std::ranges::find(report.causes.all, trait, &Cause::trait);
  return found == report.causes.all.end() ? nullptr : &*found;
}

}  // namespace

TEST_CASE("failures of several families that one change heals are one cause, in every format") {
  const Report report = explained_report();
  CHECK(report.causes.were_asked);
  CHECK(report.causes.left_out == 0);
  const Cause* const of_length = with(report, Trait::not_unit);
  REQUIRE(of_length != nullptr);
  CHECK(of_length->families.size() > 1);
  REQUIRE(of_length->ordinary);
  CHECK(of_length->ordinary->failing > 0);
  CHECK(of_length->ordinary->rays <= 6 * rays_of_a_case);
  std::uint64_t examined = 0, ordinary = 0;
  for (const Cause& cause : report.causes.all) examined += cause.examined, ordinary += cause.ordinary->failing;
  CHECK(examined == report.causes.examined);
  CHECK(ordinary == report.tally.families()[0].sample.size());
  const std::string text = report_text(report), html = report_html(report), json = report_json(report);
  CHECK(text.find("  The direction is not of length 1\n    right: with v/|v| for v\n") != text.npos);
  CHECK(text.find("    ordinary rays: ") != text.npos);
  CHECK(text.find("    severity: the worst is the answer of no data off by 2^") != text.npos);
  CHECK(text.find("    durero conform bug long ") != text.npos);
  CHECK(html.find("<h3>The direction is not of length 1</h3>") != html.npos);
  CHECK(html.find("<dt>ordinary rays</dt>") != html.npos);
  CHECK_NOTHROW(io::json::Document(io::Source("report", json)));
  CHECK(json.find("{\"cause\":\"not_unit\",\"title\":\"The direction is not of length 1\"") != json.npos);
  CHECK(json.find("\"ordinary\":{\"failing\":") != json.npos);
}

TEST_CASE("the finding that a cause shows has the fewest elements, and is reduced") {
  Report report = explained_report();
  REQUIRE(report.least.size() >= 2);
  // The first is as it was found, of several elements, and the second was not reduced.
  const FindingKey as_found = report.least.begin()->first, unreduced = std::next(report.least.begin())->first;
  for (const FamilyTally& family : report.tally.families()) {
    if (family.family->name == as_found.family)
      report.least.at(as_found).finding = *family.worst[static_cast<std::size_t>(as_found.verdict)];
  }
  report.least.erase(unreduced);
  REQUIRE(report.least.at(as_found).finding.of.the_case.scene.size() > 1);
  find_causes(report, [](const SuiteCase& of) { return long_and_small(of)[0]; }, {});
  std::size_t compared = 0;
  for (const Cause& cause : report.causes.all) {
    if (cause.findings.size() < 2) continue;
    ++compared;
    CHECK(cause.findings.front() != as_found);
    CHECK(cause.findings.front() != unreduced);
  }
  CHECK(compared > 0);
}

TEST_CASE("the same answers give the same causes") {
  CHECK(report_json(explained_report()) == report_json(explained_report()));
}

TEST_CASE("what nothing heals stands by its type") {
  Report report{.title = "None", .profile = test::profile_of_all()};
  const SuiteCase of = test::answered_case("generic", 0);
  report.tally.add(of, Claims(of.truths.size(), {Claim::Outcome::miss}), report.profile);
  find_causes(report, [](const SuiteCase&) { return Claim{Claim::Outcome::miss}; }, {});
  REQUIRE_FALSE(report.causes.all.empty());
  for (const Cause& cause : report.causes.all) {
    CHECK(cause.trait == Trait::none);
    CHECK(cause.title.starts_with("The cause is not known: "));
  }
  CHECK(report_text(report).find("right: with no change that was tried") != std::string::npos);
}

TEST_CASE("without a system causes are guessed, and the report says so") {
  Report report = failing_report();
  guess_causes(report);
  CHECK_FALSE(report.causes.were_asked);
  CHECK_FALSE(report.causes.all.empty());
  const std::string text = report_text(report), html = report_html(report);
  for (const std::string& said : {text, html}) CHECK(said.find("in common: no system was asked again") != said.npos);
  CHECK(text.find("    right: ") == text.npos);
  CHECK(report_json(report).find("\"causes\":{\"asked\":false,") != std::string::npos);
}

TEST_CASE("where the time is over nothing is said of ordinary rays, and the number left out is") {
  Report report = failing_report();
  const Ask never = [](const SuiteCase&) -> Claim { throw std::logic_error("asked"); };
  find_causes(report, never, {.time = std::chrono::duration<double>(0)});
  CHECK(report.causes.all.empty());
  CHECK(report.causes.left_out > 0);
}

TEST_CASE("the share of rays has the interval of Clopper and Pearson") {
  // Of k = 0 and of k = n the bounds have closed forms: 1 − 0.025^(1/n), and 0.025^(1/n).
  const CauseShare none = cause_share(0, 100), every = cause_share(100, 100), some = cause_share(5, 100);
  CHECK(none.least == 0);
  CHECK(std::abs(none.greatest - (1 - std::pow(0.025, 0.01))) < 1e-12);
  CHECK(every.greatest == 1);
  CHECK(std::abs(every.least - std::pow(0.025, 0.01)) < 1e-12);
  // Brown, Cai, DasGupta: 5 of 100 are within 1.64 % to 11.28 %.
  CHECK(std::abs(some.least - 0.0164) < 1e-4);
  CHECK(std::abs(some.greatest - 0.1128) < 1e-4);
}
