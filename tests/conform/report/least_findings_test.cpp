#include "durero/conform/report/least_findings.hpp"

#include <fmt/format.h>

#include "conform/judged.hpp"
#include "durero/io/json/json.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::conform;

namespace {

/// Blind to what is small; of the rest, what begins at z > 0 is said to be met later.
Claims blind_and_late(const SuiteCase& of) {
  Claims claims = test::claims_blind_to_small(of);
  for (std::size_t ray = 0; ray < claims.size(); ++ray) {
    if (claims[ray].t && of.the_case.rays[ray].rayo.p().xyz().z > 0) *claims[ray].t *= 1.25;
  }
  return claims;
}

Claim blind(const SuiteCase& of) { return blind_and_late(of)[0]; }

Report blind_report() {
  Report report{.title = "Blind", .profile = test::profile_of_all()};
  for (const char* family : {"generic", "tiny", "inside"}) {
    for (std::uint64_t number = 0; number < 4; ++number) {
      const SuiteCase of = test::answered_case(family, number);
      report.tally.add(of, blind_and_late(of), report.profile);
    }
  }
  return report;
}

std::size_t findings_of(const Report& report) {
  std::size_t count = 0;
  for (const FamilyTally& family : report.tally.families())
    for (const auto& worst : family.worst) count += worst.has_value();
  return count;
}

Report minimised_report(const LeastLimits& limits) {
  Report report = blind_report();
  minimise_findings(report, blind, limits);
  return report;
}

}  // namespace

TEST_CASE("every worst finding is made small, and every format shows it") {
  const Report report = minimised_report({});
  REQUIRE(findings_of(report) >= 2);
  CHECK(report.least.size() == findings_of(report));
  CHECK(report.not_minimised == 0);
  for (const auto& [key, least] : report.least) {
    CHECK(least.finding.judgement.verdict == key.verdict);
    CHECK(least.finding.of.the_case.scene.size() == 1);
    CHECK(least.data.has_value());
    const std::string text = least_text(least, report.profile);
    for (const char* part : {"expected ", "in hexadecimal:\nscene ", "0x", "the exact answer: ", "ε·M"})
      CHECK(text.find(part) != text.npos);
  }
  const std::string json = report_json(report), sarif = report_sarif(report);
  CHECK_NOTHROW(io::json::Document(io::Source("report", json)));
  CHECK_NOTHROW(io::json::Document(io::Source("report", sarif)));
  for (const char* part : {"\"least\":{\"question\":\"scene ", "\"hexadecimal\":", "\"excluded\":", "\"off\":"})
    CHECK(json.find(part) != json.npos);
  CHECK(sarif.find("\"least\":\"missed: ") != sarif.npos);
  CHECK(report_html(report).find("As small as it fails:") != std::string::npos);
  CHECK(report_text(report).find("    in hexadecimal:\n") != std::string::npos);
  CHECK(report_json(report).find("not_minimised") == std::string::npos);
}

TEST_CASE("the same answers give the same bytes") {
  CHECK(report_json(minimised_report({})) == report_json(minimised_report({})));
}

TEST_CASE("what is over the number is left out and said, of each family the first is made small") {
  const std::size_t all = findings_of(blind_report());
  const Report report = minimised_report({.findings = 1});
  CHECK(report.least.size() == 1);
  CHECK(report.least.begin()->first.family == failures_first(report.tally)[0]->family->name);
  CHECK(report.not_minimised == all - 1);
  CHECK(report_text(report).find(fmt::format("{} worst findings were not made small", all - 1)) != std::string::npos);
  CHECK(report_html(report).find("were not made small") != std::string::npos);
  CHECK(report_json(report).find(fmt::format("\"not_minimised\":{}", all - 1)) != std::string::npos);
}

TEST_CASE("where the time is over nothing is left half done") {
  const Report report = minimised_report({.time = std::chrono::duration<double>(0)});
  CHECK(report.least.empty());
  CHECK(report.not_minimised == findings_of(report));
}

TEST_CASE("a question in hexadecimal keeps the number of its rays, whatever is asked about them") {
  for (const char* head : {"rays", "shadows", "ranges", "crossings", "counts", "points"}) {
    const std::string text = fmt::format("scene a\nesfera e0 0 0 5 1\n{} 2\n0.5 1 -2\n", head);
    CHECK(in_hexadecimal(text) == fmt::format("scene a\nesfera e0 0x0p+0 0x0p+0 0x1.4p+2 0x1p+0\n{} 2\n0x1p-1 0x1p+0 "
                                              "-0x1p+1\n",
                                              head));
  }
}
