#include "conform/report_parts.hpp"
#include "durero/io/json_writer.hpp"

namespace durero::conform {
namespace {

using io::json::Writer;

void write_message(Writer& out, std::string_view key, std::string_view text) {
  out.key(key).begin_object().member("text", text).end_object();
}

void write_rules(Writer& out) {
  out.key("rules").begin_array();
  for (const Verdict verdict : verdicts) {
    if (!is_failure(verdict)) continue;
    out.new_line().begin_object().member("id", name(verdict));
    write_message(out, "shortDescription", meaning(verdict));
    out.end_object();
  }
  out.end_array();
}

void write_result(Writer& out, const Report& report, const Finding& finding) {
  const Verdict verdict = finding.judgement.verdict;
  out.new_line().begin_object().member("ruleId", name(verdict));
  out.member("level", verdict == Verdict::off ? "warning" : "error");
  write_message(out, "message", sentence(finding));
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
  out.begin_object().member("$schema", "https://json.schemastore.org/sarif-2.1.0.json").member("version", "2.1.0");
  out.new_line().key("runs").begin_array().begin_object().key("tool").begin_object().key("driver").begin_object();
  out.member("name", "durero conform");
  write_rules(out);
  out.end_object().end_object().new_line().key("properties").begin_object().member("system", report.title);
  out.member("system_version", report.version).end_object().new_line().key("results").begin_array();
  for (const FamilyTally* family : failures_first(report.tally)) {
    for (const Finding* finding : findings_of(*family)) write_result(out, report, *finding);
  }
  out.end_array().end_object().end_array().end_object();
  return text + "\n";
}

}  // namespace durero::conform
