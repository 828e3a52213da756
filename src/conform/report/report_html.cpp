#include <fmt/format.h>

#include <cmath>

#include "conform/report/picture.hpp"
#include "conform/report/report_parts.hpp"

namespace durero::conform {

std::string_view colour(Verdict verdict) {
  if (is_gross(verdict)) return "#c62828";
  if (verdict == Verdict::off) return "#ef6c00";
  return verdict == Verdict::skipped ? "#9e9e9e" : "#2e7d32";
}

namespace {

constexpr std::string_view style = R"(
:root { color-scheme: light dark; font: 15px/1.5 system-ui, sans-serif; }
body { max-width: 70rem; margin: 2rem auto; padding: 0 1rem; overflow-wrap: anywhere; }
.wide { overflow-x: auto; } .wide th, .wide td { overflow-wrap: normal; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
th, td { padding: .15rem .6rem; text-align: right; border-bottom: 1px solid #8884; }
th:first-child, td:first-child { text-align: left; }
td.bad { color: #c62828; font-weight: 600; } td.off { color: #ef6c00; } td.zero { color: #8888; }
pre { background: #8881; padding: .6rem; overflow-x: auto; font-size: 13px; }
figure { display: inline-block; margin: 0 1rem 1rem 0; vertical-align: top; width: 30rem; max-width: 100%; }
figcaption { font-size: 13px; opacity: .75; }
svg { width: 100%; background: #8881; } svg text { font-size: 11px; fill: currentColor; }
.grid { stroke: #8884; } .element { fill: none; stroke: currentColor; stroke-opacity: .3; stroke-width: .7; }
.ray { stroke-width: 1; }
.cause { border-left: .25rem solid #c62828; padding-left: 1rem; margin: 2rem 0; } .cause h3 { margin: 0; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: .1rem 1rem; margin: .5rem 0; } dd { margin: 0; }
@media (max-width: 40rem) { dl { display: block; } dt { font-weight: 600; } h1 { font-size: 1.4rem; } }
summary { font-weight: 600; cursor: pointer; margin: .3rem 0; } .less { font-size: 13px; opacity: .8; }
)";

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

std::string figure(const std::string& svg, const std::string& caption) {
  return fmt::format("<figure>\n{}<figcaption>{}</figcaption></figure>\n", svg, as_markup(caption));
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

std::string profile_html(const Profile& profile) {
  std::string html = "<h2>The profile that was judged by</h2>\n<div class=\"wide\"><table>\n";
  for (const ProfileLine& line : profile_lines(profile)) {
    std::string why;
    for (const Citation& source : profile.sources) {
      if (source.claim != line.claim) continue;
      why += fmt::format("<q>{}</q> ({}) ", as_markup(source.sentence), as_markup(source.place));
    }
    html += fmt::format("<tr><td>{}</td><td>{}</td><td style=\"text-align:left\">{}</td></tr>\n", line.claim,
                        as_markup(line.value), why);
  }
  return html + "</table></div>\n";
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
  const std::string title = as_markup(report.title);
  std::string html = fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\"><title>{0}: hits against the exact "
      "answer</title>\n<meta name=\"viewport\" "
      "content=\"width=device-width\"><style>{1}</style></head>\n<body>\n<h1>{0}</h1>\n<p>{2} rays: {3} gross, {4} "
      "off, {5} skipped. "
      "{6}</p>\n",
      title, style, report.tally.rays(), report.tally.gross(), report.tally.of(Verdict::off),
      report.tally.of(Verdict::skipped), as_markup(report.version));
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
  return html + profile_html(report.profile) + skipped_html(report.tally) + "</body>\n</html>\n";
}

}  // namespace durero::conform
