#include <fmt/format.h>

#include "conform/report/report_parts.hpp"

namespace durero::conform {
namespace {

std::string test_case(const Report& report, const FamilyTally& family) {
  std::string text = fmt::format(R"(  <testcase classname="{}" name="{}" assertions="{}">)",
                                 as_markup(report.profile.system), family.family->name, family.rays());
  text += "\n";
  if (family.failures() > 0) {
    std::string body;
    for (const Finding* finding : findings_of(family))
      body += fmt::format("{}\n{}\n{}", sentence(*finding), replay(report, *finding),
                          question_of(*finding, report.profile));
    text += fmt::format("    <failure type=\"{}\" message=\"{} of {} rays fail, {} gross\">{}</failure>\n",
                        family.gross() > 0 ? "gross" : "off", family.failures(), family.rays(), family.gross(),
                        as_markup(body));
  } else if (family.of(Verdict::skipped) == family.rays()) {
    text += fmt::format("    <skipped message=\"{}\"/>\n",
                        as_markup(family.clauses.empty() ? "no rays" : family.clauses.begin()->first));
  }
  return text + "  </testcase>\n";
}

}  // namespace

std::string report_junit(const Report& report) {
  const std::vector<const FamilyTally*> families = failures_first(report.tally);
  std::size_t failures = 0, skipped = 0;
  std::string cases;
  for (const FamilyTally* family : families) {
    failures += family->failures() > 0;
    skipped += family->failures() == 0 && family->of(Verdict::skipped) == family->rays();
    cases += test_case(report, *family);
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"{}\">\n{}</testsuite>\n",
      as_markup(report.title), families.size(), failures, skipped, cases);
}

}  // namespace durero::conform
