#include <fmt/format.h>

#include <cmath>
#include <sstream>

#include "conform/report/report_parts.hpp"

namespace durero::conform {
namespace {

constexpr int family_width = 20, column_width = 15;

template <class Count>
std::string row(std::string_view title, std::span<const Verdict> columns, Count count) {
  std::string line = fmt::format("{:<{}}", title, family_width);
  for (const Verdict verdict : columns) line += fmt::format("{:>{}}", count(verdict), column_width);
  return line + "\n";
}

std::string findings_text(const Report& report, const FamilyTally& family) {
  std::string text;
  for (const Finding* finding : findings_of(family)) {
    text += fmt::format("\n{} {}\n", family.family->name, sentence(*finding));
    if (finding->judgement.backward > 0)
      text += fmt::format("  backward error 2^{:.1f} of its unit\n", std::log2(finding->judgement.backward));
    text += fmt::format("  {}\n", replay(report, *finding));
    if (!report.asked.empty()) text += fmt::format("  {}\n", minimising(report, *finding));
    text += indented(least_of(report, *finding), "    ");
  }
  return text;
}

std::string cause_text(const Report& report, const Cause& cause) {
  std::string text = fmt::format("  {}\n", cause.title);
  for (const auto& [label, value] : cause_lines(report, cause)) text += fmt::format("    {}: {}\n", label, value);
  const Finding* const shown = shown_finding(report, cause);
  if (shown == nullptr) return text;
  if (const std::string call = writing_up(report, *shown); !call.empty()) text += fmt::format("    {}\n", call);
  const LeastFinding* const least = shown_least(report, cause);
  const Finding& finding = least == nullptr ? *shown : least->finding;
  return text + indented(sentence(finding) + "\n" + question_of(finding, report.profile), "      ");
}

std::string causes_text(const Report& report) {
  if (report.causes.all.empty()) return "";
  std::string text = "\n" + causes_words(report) + "\n";
  for (const Cause& cause : report.causes.all) text += cause_text(report, cause);
  return text;
}

std::string skipped_text(const Tally& tally) {
  std::map<std::string, std::uint64_t> clauses;
  for (const FamilyTally& family : tally.families()) {
    for (const auto& [clause, count] : family.clauses) clauses[clause] += count;
  }
  std::string text;
  for (const auto& [clause, count] : clauses) text += fmt::format("skipped {}: {}\n", count, clause);
  return text;
}

}  // namespace

std::string report_text(const Report& report) {
  const Tally& tally = report.tally;
  std::string text = report.title;
  if (!report.version.empty()) text += " (" + report.version + ")";
  text += "\n";
  const std::vector<Verdict> columns = columns_of(tally);
  text += row("family", columns, [](Verdict verdict) { return name(verdict); });
  for (const FamilyTally* family : failures_first(tally))
    text += row(family->family->name, columns, [&](Verdict verdict) { return family->of(verdict); });
  text += row("all", columns, [&](Verdict verdict) { return tally.of(verdict); });
  text += fmt::format("{} rays: {} gross, {} off, {} skipped\n", tally.rays(), tally.gross(), tally.of(Verdict::off),
                      tally.of(Verdict::skipped));
  text += skipped_text(tally);
  if (const std::string unasked = unasked_words(report); !unasked.empty()) text += unasked + "\n";
  if (report.profile.directions == Directions::unchecked)
    text += "warning: v must be a unit vector and nobody checks it: other rays get wrong answers without a word\n";
  text += causes_text(report);
  for (const FamilyTally* family : failures_first(tally)) text += findings_text(report, *family);
  if (const std::string left_out = left_out_words(report); !left_out.empty()) text += "\n" + left_out + "\n";
  return text;
}

}  // namespace durero::conform
