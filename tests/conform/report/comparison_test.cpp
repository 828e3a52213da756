#include "durero/conform/report/comparison.hpp"

#include <fmt/format.h>

#include "conform/judged.hpp"
#include "durero/conform/families/suite_file.hpp"
#include "durero/conform/report/report.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::conform;

namespace {

Report report_of(const char* system, bool is_blind, std::uint64_t seed = 1) {
  Report report{.title = system, .version = "1", .profile = test::profile_of_all()};
  report.options.seed = seed;
  report.profile.system = system;
  for (const char* family : {"generic", "tiny"}) {
    const SuiteCase of = test::answered_case(family, 0);
    report.tally.add(of, is_blind ? test::claims_blind_to_small(of) : test::right_claims(of), report.profile);
  }
  return report;
}

Summary summary(const Report& report) { return read_summary(io::Source("report.json", report_json(report))); }

}  // namespace

TEST_CASE("a summary has the numbers of its report") {
  const Report report = report_of("blind", true);
  const Summary read = summary(report);
  CHECK(read.system == "blind");
  CHECK(read.seed == 1);
  CHECK(read.numbers == "binary32");
  REQUIRE(read.families.size() == 2);
  CHECK(read.families[0].family == "tiny");
  for (int i = 0; i < verdict_count; ++i)
    CHECK(read.counts[static_cast<std::size_t>(i)] == report.tally.of(static_cast<Verdict>(i)));
}

TEST_CASE("systems stand side by side, the worst first") {
  const std::vector<Summary> systems = {summary(report_of("right", false)), summary(report_of("blind", true))};
  const std::string text = comparison_text(systems), markdown = comparison_markdown(systems);
  CHECK(text.find("blind (1)") < text.find("right (1)"));
  CHECK(text.find("right: gross in none\n") != text.npos);
  CHECK(text.find("blind: gross in tiny ") != text.npos);
  CHECK(markdown.find("| blind (1) |") < markdown.find("| right (1) |"));
}

TEST_CASE("the versions of a system stand in their order, with the families that fail less or more") {
  Summary old = summary(report_of("mine", true)), fresh = summary(report_of("mine", false));
  old.version = "1.0";
  fresh.version = "1.1";
  const std::string text = history_text({old, fresh});
  CHECK(text.find("mine (1.0) ") < text.find("mine (1.1) "));
  CHECK_THAT(text,
             Catch::Contains("mine (1.1), after mine (1.0):\n  fewer gross in tiny ") && Catch::Contains(" to 0 %\n"));
  CHECK(text.find("more gross") == text.npos);
  CHECK_THAT(history_text({fresh, old}),
             Catch::Contains("mine (1.0), after mine (1.1):\n  more gross in tiny 0 % to "));
  CHECK_THAT(history_text({old, old}), Catch::Contains("  the same share of gross failures in each family\n"));
  CHECK_THROWS_AS(history_text({old, summary(report_of("mine", false, 2))}), std::invalid_argument);
}

TEST_CASE("a report of a program that did not know a verdict has none of it") {
  std::string text = report_json(report_of("blind", true));
  for (std::size_t at = 0; (at = text.find("\"out_of_range\":0,", at)) != text.npos;) text.erase(at, 17);
  CHECK(read_summary(io::Source("report.json", text)).counts == summary(report_of("blind", true)).counts);
}

TEST_CASE("a share of all rays is written in full") {
  Summary system = summary(report_of("blind", true));
  auto& counts = system.families.front().counts;
  const auto share_of = [&](std::uint64_t right, std::uint64_t missed) {
    counts = {};
    counts[static_cast<std::size_t>(Verdict::right)] = right;
    counts[static_cast<std::size_t>(Verdict::missed)] = missed;
    return comparison_text({system});
  };
  CHECK_THAT(share_of(0, 64), Catch::Contains("gross in tiny 100 %"));
  CHECK_THAT(share_of(4, 996), Catch::Contains("gross in tiny 99.6 %"));
  CHECK_THAT(share_of(995, 5), Catch::Contains("gross in tiny 0.5 %"));
}

TEST_CASE("what is no report, or of other rays, is refused") {
  CHECK_THROWS_WITH(comparison_text({summary(report_of("a", false)), summary(report_of("b", false, 2))}),
                    "\"a\" and \"b\" were asked other rays; expected reports of one suite");
  Summary former = summary(report_of("b", false));
  CHECK(former.suite_version == suite_version);
  --former.suite_version;
  CHECK_THROWS_WITH(comparison_text({summary(report_of("a", false)), former}),
                    Catch::Contains("expected reports of one suite"));
  Summary of_shadows = summary(report_of("b", false));
  CHECK(of_shadows.question == "first");
  of_shadows.question = "shadow";
  CHECK_THROWS_WITH(comparison_text({summary(report_of("a", false)), of_shadows}),
                    Catch::Contains("expected reports of one suite"));
  std::string unversioned = report_json(report_of("a", false));
  const std::string version = fmt::format("\"version\":{},\"seed\"", suite_version);
  unversioned.replace(unversioned.find(version), version.size(), "\"seed\"");
  CHECK(read_summary(io::Source("f", unversioned)).suite_version == 1);
  CHECK_THROWS_WITH(read_summary(io::Source("f", "{}")),
                    "f:1:1: a report without format; expected what durero conform run --report writes");
  CHECK_THROWS_WITH(read_summary(io::Source("f", R"({"format":"durero-scene"})")),
                    Catch::Contains("f:1:11: ") && Catch::Contains("durero-report"));
  CHECK_THROWS_AS(read_summary(io::Source("f", R"({"verdicts":{"exact":-1}})")), io::InputError);
}
