#include <fmt/format.h>

#include <cmath>

#include "conform/report/html_parts.hpp"
#include "conform/report/picture.hpp"
#include "conform/report/report_parts.hpp"

namespace durero::conform {
namespace {

std::string cell(const FamilyTally& family, Verdict verdict) {
  const std::uint64_t count = family.of(verdict);
  const char* kind = count == 0 ? "zero" : verdict == Verdict::off ? "off" : is_failure(verdict) ? "bad" : "";
  return fmt::format("<td class=\"{}\">{}</td>", kind, count);
}

std::string table_html(const Tally& tally) {
  const std::vector<Verdict> columns = columns_of(tally);
  std::string html = "<div class=\"wide\"><table>\n<tr><th>family</th>";
  for (const Verdict verdict : columns)
    html += fmt::format("<th title=\"{}\">{}</th>", as_markup(meaning(verdict)), verdict_words(verdict));
  html += "</tr>\n";
  for (const FamilyTally* family : failures_first(tally)) {
    const std::string_view title = family->family->name;
    html += family->failures() > 0 ? fmt::format("<tr><td><a href=\"#{0}\">{0}</a></td>", title)
                                   : fmt::format("<tr><td>{}</td>", title);
    for (const Verdict verdict : columns) html += cell(*family, verdict);
    html += "</tr>\n";
  }
  return html + "</table></div>\n";
}

std::string cause_html(const Report& report, const Cause& cause) {
  std::string html = fmt::format("<div class=\"cause\">\n<h3>{}</h3>\n<dl>\n", as_markup(cause.title));
  for (const auto& [label, value] : cause_lines(report, cause))
    html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", label, as_markup(value));
  html += "</dl>\n";
  const Finding* const shown = shown_finding(report, cause);
  if (shown == nullptr) return html + "</div>\n";
  const LeastFinding* const least = shown_least(report, cause);
  const Finding& finding = least == nullptr ? *shown : least->finding;
  html += fmt::format("<p><b>{}</b>: expected {}; got {}.</p>\n<pre>{}</pre>\n",
                      verdict_words(finding.judgement.verdict), as_markup(truth_words(finding)),
                      as_markup(claim_words(finding)), as_markup(question_of(finding, report.profile)));
  const std::string call = writing_up(report, *shown);
  if (!call.empty())
    html += fmt::format("<p class=\"less\">The report to file{}:</p>\n<pre>{}</pre>\n",
                        report.options.question != QuestionKind::first ? "" : ", with a program that shows it",
                        as_markup(call));
  return html + "</div>\n";
}

std::string causes_html(const Report& report) {
  if (report.causes.all.empty()) return "";
  std::string html = fmt::format("<h2>Causes</h2>\n<p>{}.</p>\n", as_markup(causes_words(report)));
  for (const Cause& cause : report.causes.all) html += cause_html(report, cause);
  return html;
}

std::string finding_html(const Report& report, const Finding& finding) {
  const ClaimJudgement& is = finding.judgement;
  std::string html =
      fmt::format("<p><b>{}</b>: {}. Expected {}; got {}.", name(is.verdict), as_markup(meaning(is.verdict)),
                  as_markup(truth_words(finding)), as_markup(claim_words(finding)));
  if (is.backward > 0 && std::isfinite(is.backward))
    html += fmt::format(" Its point is 2<sup>{:.1f}</sup> ε off the surface.", std::log2(is.backward));
  html += fmt::format("</p>\n<pre>{}\n{}</pre>\n", as_markup(question_of(finding, report.profile)),
                      as_markup(replay(report, finding) + "\n" + minimising(report, finding)));
  const std::string least = least_of(report, finding);
  if (least.empty()) return html;
  return html +
         fmt::format("<details><summary>As small as it fails:</summary>\n<pre>{}</pre></details>\n", as_markup(least));
}

std::string family_html(const Report& report, const FamilyTally& family) {
  std::string html =
      fmt::format("<h3 id=\"{0}\">{0}</h3>\n<p>{1}. Why: {2}. {3} of {4} rays fail, {5} of them gross.</p>\n",
                  family.family->name, as_markup(family.family->kind), as_markup(family.family->reason),
                  family.failures(), family.rays(), family.gross());
  if (!family.spreads.empty())
    html +=
        figure(spread_svg(family), fmt::format("A dot a case: log₂ of its greatest backward error, in ε, against {}",
                                               family.family->parameter.name));
  if (family.most_failures)
    html += figure(scene_svg(*family.most_failures),
                   fmt::format("{}: where its rays should hit", family.most_failures->of.name()));
  for (const Finding* finding : findings_of(family)) html += finding_html(report, *finding);
  return html;
}

std::string skipped_html(const Tally& tally) {
  std::string html;
  for (const FamilyTally& family : tally.families()) {
    for (const auto& [clause, count] : family.clauses)
      html += fmt::format("<tr><td>{}</td><td>{}</td><td style=\"text-align:left\">{}</td></tr>\n", family.family->name,
                          count, as_markup(clause));
  }
  return html.empty() ? "" : "<h2>Skipped, and why</h2>\n<div class=\"wide\"><table>\n" + html + "</table></div>\n";
}

}  // namespace

std::string report_html(const Report& report) {
  std::string html =
      page_head(report.title, "hits against the exact answer") +
      fmt::format("<p>{} rays: {} gross, {} off, {} skipped. {}</p>\n", report.tally.rays(), report.tally.gross(),
                  report.tally.of(Verdict::off), report.tally.of(Verdict::skipped), as_markup(report.version));
  html += causes_html(report) + "<h2>Verdicts</h2>\n" + table_html(report.tally);
  if (const std::string unasked = unasked_words(report); !unasked.empty())
    html += fmt::format("<p>{}.</p>\n", as_markup(unasked));
  if (report.profile.directions == Directions::unchecked)
    html +=
        "<p><b>Warning</b>: v must be a unit vector, and nobody checks it: other rays get wrong answers without a "
        "word.</p>\n";
  if (report.tally.failures() > 0) html += "<h2>Families that fail</h2>\n";
  for (const FamilyTally* family : failures_first(report.tally)) {
    if (family->failures() > 0) html += family_html(report, *family);
  }
  if (const std::string left_out = left_out_words(report); !left_out.empty())
    html += fmt::format("<p>{}.</p>\n", as_markup(left_out));
  return html + profile_html(report.profile) + skipped_html(report.tally) + std::string(page_foot);
}

}  // namespace durero::conform
