#include "conform/report/report_parts.hpp"
#include "durero/io/json/sarif.hpp"

namespace durero::conform {
namespace {

using io::json::Writer;

std::vector<io::SarifRule> rules() {
  std::vector<io::SarifRule> rules;
  for (const Verdict verdict : verdicts)
    if (is_failure(verdict)) rules.push_back({name(verdict), meaning(verdict)});
  return rules;
}

void write_result(Writer& out, const Report& report, const Finding& finding) {
  const Verdict verdict = finding.judgement.verdict;
  out.new_line().begin_object().member("ruleId", name(verdict));
  out.member("level", verdict == Verdict::off ? "warning" : "error");
  io::write_sarif_message(out, "message", sentence(finding));
  out.key("locations").begin_array().begin_object().key("logicalLocations").begin_array().begin_object();
  out.member("name", finding.of.name()).member("kind", "case").end_object().end_array().end_object().end_array();
  out.key("properties").begin_object().member("ray", std::uint64_t{finding.ray});
  out.member("question", question_of(finding, report.profile)).member("replay", replay(report, finding));
  if (const std::string least = least_of(report, finding); !least.empty()) out.member("least", least);
  out.end_object().end_object();
}

}  // namespace

std::string report_sarif(const Report& report) {
  std::string text;
  Writer out(text);
  io::begin_sarif(out, "durero conform", rules());
  out.key("properties").begin_object().member("system", report.title);
  out.member("system_version", report.version).end_object().new_line().key("results").begin_array();
  for (const FamilyTally* family : failures_first(report.tally)) {
    for (const Finding* finding : findings_of(*family)) write_result(out, report, *finding);
  }
  io::end_sarif(out);
  return text + "\n";
}

}  // namespace durero::conform
