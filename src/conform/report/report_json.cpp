#include "conform/report/json_parts.hpp"
#include "conform/report/report_parts.hpp"
#include "durero/conform/format_versions.hpp"

namespace durero::conform {
namespace {

void write_suite(Writer& out, const SuiteOptions& options) {
  out.key("suite").begin_object().member("version", suite_version).member("seed", options.seed);
  out.member("rays", std::uint64_t{options.rays});
  out.member("numbers", word(options.numbers)).member("caps", word(options.caps));
  out.member("tipos", type_words(options.tipos, options.bodies));
  if (options.faces != usual_faces) out.member("faces", std::uint64_t{options.faces});
  if (options.question != QuestionKind::first) out.member("question", word(options.question));
  out.end_object();
}

template <class Count>
void write_verdicts(Writer& out, Count count) {
  out.key("verdicts").begin_object();
  for (const Verdict verdict : verdicts) out.member(name(verdict), std::uint64_t{count(verdict)});
  out.end_object();
}

void write_finding(Writer& out, const Report& report, const Finding& finding) {
  out.new_line().begin_object().member("verdict", name(finding.judgement.verdict));
  out.member("case", finding.of.name()).member("ray", std::uint64_t{finding.ray});
  out.member("expected", truth_words(finding)).member("got", claim_words(finding));
  out.member("ulps", finding.judgement.ulps).member("backward", finding.judgement.backward);
  out.member("question", whole_question_of(finding, report.profile)).member("replay", replay(report, finding));
  if (!report.asked.empty()) out.member("minimise", minimising(report, finding));
  const auto least = report.least.find(FindingKey(finding));
  if (least != report.least.end()) write_least(out, report.profile, least->second);
  out.end_object();
}

void write_share(Writer& out, const CauseShare& share) {
  out.key("ordinary").begin_object().member("failing", share.failing).member("rays", share.rays);
  out.member("at_least", share.least).member("at_most", share.greatest).end_object();
}

void write_cause(Writer& out, const Report& report, const Cause& cause) {
  out.new_line().begin_object().member("cause", name(cause.trait)).member("title", cause.title);
  out.member("remedy", remedy(cause.trait)).member("rays", cause.examined);
  std::vector<std::string_view> verdicts;
  for (const Verdict verdict : cause.verdicts) verdicts.push_back(name(verdict));
  write_names(out, "verdicts", verdicts);
  write_names(out, "families", cause.families);
  if (cause.ordinary) write_share(out, *cause.ordinary);
  if (const std::string severity = severity_words(report, cause); !severity.empty()) out.member("severity", severity);
  if (const Finding* const shown = shown_finding(report, cause)) {
    out.member("case", shown->of.name()).member("ray", std::uint64_t{shown->ray});
    out.member("verdict", name(shown->judgement.verdict));
    if (const std::string call = writing_up(report, *shown); !call.empty()) out.member("bug", call);
  }
  out.end_object();
}

void write_causes(Writer& out, const Report& report) {
  const Causes& causes = report.causes;
  if (causes.all.empty()) return;
  out.new_line().key("causes").begin_object().member("asked", causes.were_asked);
  out.member("rays", causes.examined).member("left_out", causes.left_out).key("all").begin_array();
  for (const Cause& cause : causes.all) write_cause(out, report, cause);
  out.end_array().end_object();
}

void write_family(Writer& out, const Report& report, const FamilyTally& family) {
  out.new_line().begin_object().member("family", family.family->name);
  write_verdicts(out, [&](Verdict verdict) { return family.of(verdict); });
  out.key("skipped").begin_object();
  for (const auto& [clause, count] : family.clauses) out.member(clause, count);
  out.end_object().key("ulps").begin_array();
  for (const std::uint64_t count : family.ulps) out.value(count);
  out.end_array().key("cases").begin_array();
  for (const Spread& spread : family.spreads) {
    out.begin_array().value(double(spread.parameter)).value(spread.backward).value(name(spread.worst)).end_array();
  }
  out.end_array().key("findings").begin_array();
  for (const Finding* finding : findings_of(family)) write_finding(out, report, *finding);
  out.end_array().end_object();
}

}  // namespace

std::string report_json(const Report& report) {
  std::string text;
  Writer out(text);
  write_version(out.begin_object(), report_format);
  out.new_line().member("system", report.profile.system).member("title", report.title);
  out.member("system_version", report.version).new_line();
  write_suite(out, report.options);
  out.new_line();
  write_profile(out, report.profile);
  out.new_line();
  write_verdicts(out, [&](Verdict verdict) { return report.tally.of(verdict); });
  if (report.not_minimised > 0) out.member("not_minimised", std::uint64_t{report.not_minimised});
  write_causes(out, report);
  out.new_line().key("families").begin_array();
  for (const FamilyTally* family : failures_first(report.tally)) write_family(out, report, *family);
  out.end_array().end_object();
  return text + "\n";
}

}  // namespace durero::conform
