#include "durero/conform/report/report.hpp"

#include <filesystem>

#include "conform/judged.hpp"
#include "durero/io/json/json.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::conform;

namespace {

Report blind_report() {
  Report report{.title = "A <blind> system", .version = "1.0 & more", .profile = test::profile_of_all()};
  report.profile.sources.push_back({"directions", "v need \"not\" be a unit vector", "manual.html"});
  for (const char* family : {"generic", "tiny"}) {
    for (std::uint64_t number = 0; number < 3; ++number) {
      const SuiteCase of = test::answered_case(family, number);
      report.tally.add(of, test::claims_blind_to_small(of), report.profile);
    }
  }
  return report;
}

std::size_t count_of(const std::string& text, std::string_view part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// Throws where it is no JSON.
void read_json(const std::string& text) { io::json::Document(io::Source("report", text)); }

}  // namespace

TEST_CASE("the table has a row a family, failing ones first, and the call that replays the worst") {
  const Report report = blind_report();
  const std::string text = report_text(report);
  CHECK(text.find("tiny ") < text.find("generic "));
  CHECK(text.find("missed") != text.npos);
  CHECK(text.find("crashed") == text.npos);  // no ray has that verdict
  CHECK(text.find("durero conform show --case tiny/") != text.npos);
  CHECK(text.find("expected e") != text.npos);
  CHECK(text.find("; got a miss") != text.npos);
  CHECK(text.find("minimise") == text.npos);
  Report asked = report;
  asked.asked = "blind";
  asked.options.seed = 7;
  CHECK(report_text(asked).find("  durero conform minimise blind --case tiny/") != text.npos);
  CHECK(report_text(asked).find(" --seed 7\n") != text.npos);
  CHECK(report_html(asked).find("durero conform minimise blind --case") != text.npos);
}

TEST_CASE("replay options name what is not usual, so that the same case is made") {
  const Report report = blind_report();
  const Finding finding = *report.tally.families()[1].worst[static_cast<std::size_t>(Verdict::missed)];
  CHECK(replay_options({}, finding) == "--case " + finding.of.name() + " --ray " + std::to_string(finding.ray));
  const SuiteOptions unusual{.seed = 9,
                             .tipos = {model::Tipo::soy_cono, model::Tipo::soy_plano},
                             .caps = Caps::solid,
                             .numbers = NumberFormat::binary64};
  CHECK(replay_options(unusual, finding).ends_with(" --seed 9 --types cono,plano --solids --numbers binary64"));
}

TEST_CASE("JSON and SARIF are JSON, and say the same") {
  const Report report = blind_report();
  const std::string json = report_json(report), sarif = report_sarif(report);
  CHECK_NOTHROW(read_json(json));
  CHECK_NOTHROW(read_json(sarif));
  CHECK(json.find(R"("format":"durero-report","version":1)") != json.npos);
  CHECK(json.find("\"missed\":" + std::to_string(report.tally.of(Verdict::missed))) != json.npos);
  std::size_t findings = 0;
  for (const FamilyTally& family : report.tally.families())
    for (const auto& worst : family.worst) findings += worst.has_value();
  CHECK(findings > 0);
  CHECK(count_of(sarif, "\"ruleId\"") == findings);
  CHECK(count_of(json, "\"replay\"") == findings);
}

TEST_CASE("JUnit has a test a family, and HTML a row; both quote what markup would obey") {
  const Report report = blind_report();
  const std::string junit = report_junit(report), html = report_html(report);
  CHECK(count_of(junit, "<testcase ") == 2);
  CHECK(count_of(junit, "<failure ") >= 1);
  CHECK(junit.find("A &lt;blind&gt; system") != junit.npos);
  CHECK(html.find("<blind>") == html.npos);
  CHECK(html.find("1.0 &amp; more") != html.npos);
  CHECK(html.find("v need &quot;not&quot; be") != html.npos);
  CHECK(html.find("<svg") != html.npos);
  CHECK(html.find("http") == html.npos);  // the page stands alone
  CHECK(html.find("nan") == html.npos);
}

TEST_CASE("the same report is the same bytes, in four files") {
  const std::string folder = std::filesystem::temp_directory_path() / "durero_report_test";
  std::filesystem::remove_all(folder);
  write_reports(folder, blind_report());
  for (const char* name : {"report.json", "report.xml", "report.sarif", "report.html"})
    CHECK(std::filesystem::file_size(folder + "/" + name) > 100);
  CHECK(io::read_source(folder + "/report.html").text() == report_html(blind_report()));
  std::filesystem::remove_all(folder);
  CHECK_THROWS_AS(write_reports("/dev/null/x", blind_report()), io::FileError);
}

TEST_CASE("of a mesh a report shows the faces that the ray meets, and JSON has all") {
  Report report{.title = "Blind", .profile = test::profile_of_all()};
  const SuiteCase of = test::answered_case("mesh_solid", 0);
  report.tally.add(of, Claims(of.truths.size(), {Claim::Outcome::miss}), report.profile);
  const std::string html = report_html(report);
  CHECK(count_of(html, "triangulo m:") <= 4);
  CHECK(html.find(" more elements)\nrays 1\n") != html.npos);
  CHECK(report_junit(report).find(" more elements)") != std::string::npos);
  CHECK(report_json(report).find(" more elements)") == std::string::npos);
}
