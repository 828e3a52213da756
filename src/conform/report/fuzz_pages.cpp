#include <fmt/format.h>
#include <fmt/ranges.h>

#include "conform/report/html_parts.hpp"
#include "conform/report/json_parts.hpp"
#include "conform/report/picture.hpp"
#include "conform/report/report_parts.hpp"
#include "durero/conform/format_versions.hpp"
#include "durero/conform/report/fuzz_report.hpp"
#include "durero/io/output_file.hpp"

namespace durero::conform {
namespace {

std::string counts_words(const FuzzReport& report) {
  const Fuzzing& fuzzing = report.fuzzing;
  const std::size_t causes = report.causes.all.size();
  std::string words = report.is_stopped ? "stopped, so that nothing is made small: " : "";
  words += fmt::format("{} questions, {} of them asked: {} wrong", fuzzing.steps, fuzzing.asked, fuzzing.failures);
  if (fuzzing.failures > 0)
    words += fmt::format(" in {} kinds, {} cause{}", fuzzing.failing.size(), causes, causes == 1 ? "" : "s");
  return words;
}

/// "3 kinds were not examined: …"; empty where each was.
std::string unexamined_words(const FuzzReport& report) {
  if (report.causes.left_out == 0) return "";
  return fmt::format("{} kinds were not examined: their number or the time was over", report.causes.left_out);
}

/// "3 failures: missed, off; here question 17; right with …"
std::string cause_words(const FuzzedCause& cause) {
  std::vector<std::string> verdicts;
  for (const Verdict verdict : cause.verdicts) verdicts.push_back(verdict_words(verdict));
  std::string words = fmt::format("{} failure{}: {}; here question {}", cause.alike, cause.alike == 1 ? "" : "s",
                                  fmt::join(verdicts, ", "), cause.step);
  const std::string_view cure = remedy(cause.trait);
  if (!cure.empty()) words += fmt::format("; right {}", cure);
  return words;
}

std::string fuzzed_cause_html(const FuzzReport& report, const FuzzedCause& cause) {
  const Finding& finding = cause.least.finding;
  const JudgedCase judged{finding.of, {finding.claim}, {finding.judgement}};
  return fmt::format(
      "<div class=\"cause\">\n<h3>{}</h3>\n<p>{}.</p>\n{}<p><b>{}</b>: expected {}; got {}.</p>\n<pre>{}</pre>\n"
      "<details><summary>In full:</summary>\n<pre>{}</pre></details>\n</div>\n",
      as_markup(cause.title), as_markup(cause_words(cause)),
      figure(scene_svg(judged), "Where the ray should hit, or passes"), verdict_words(finding.judgement.verdict),
      as_markup(truth_words(finding)), as_markup(claim_words(finding)), as_markup(question_of(finding, report.profile)),
      as_markup(least_text(cause.least, report.profile)));
}

void write_fuzzed_cause(Writer& out, const Profile& profile, const FuzzedCause& cause) {
  out.new_line().begin_object().member("cause", name(cause.trait)).member("title", cause.title);
  out.member("remedy", remedy(cause.trait)).member("failures", cause.alike).member("step", cause.step);
  std::vector<std::string_view> verdicts;
  for (const Verdict verdict : cause.verdicts) verdicts.push_back(name(verdict));
  write_names(out, "verdicts", verdicts);
  out.member("verdict", name(cause.least.finding.judgement.verdict));
  write_least(out, profile, cause.least);
  out.end_object();
}

}  // namespace

std::string fuzz_text(const FuzzReport& report) {
  std::string text = fmt::format("{}\nthe same again: {}\n", counts_words(report), report.call);
  for (const FuzzedCause& cause : report.causes.all)
    text += fmt::format("\n{}\n  {}\n{}", cause.title, cause_words(cause),
                        indented(least_text(cause.least, report.profile), "    "));
  if (const std::string words = unexamined_words(report); !words.empty()) text += fmt::format("\n{}\n", words);
  return text;
}

std::string fuzz_json(const FuzzReport& report) {
  const Fuzzing& fuzzing = report.fuzzing;
  std::string text;
  Writer out(text);
  write_version(out.begin_object(), search_format);
  out.new_line().member("system", report.profile.system).member("title", report.title);
  out.member("system_version", report.version).new_line().member("call", report.call).member("seed", report.seed);
  out.new_line().member("steps", fuzzing.steps).member("asked", fuzzing.asked).member("failures", fuzzing.failures);
  out.member("kinds", std::uint64_t{fuzzing.failing.size()}).member("left_out", std::uint64_t{report.causes.left_out});
  out.member("stopped", report.is_stopped).new_line();
  write_profile(out, report.profile);
  out.new_line().key("causes").begin_array();
  for (const FuzzedCause& cause : report.causes.all) write_fuzzed_cause(out, report.profile, cause);
  out.end_array().end_object();
  return text + "\n";
}

std::string fuzz_html(const FuzzReport& report) {
  std::string html = page_head(report.title, "a search for failures") +
                     fmt::format("<p>{}. {}</p>\n<p>The same again:</p>\n<pre>{}</pre>\n", counts_words(report),
                                 as_markup(report.version), as_markup(report.call));
  if (!report.causes.all.empty()) html += "<h2>Causes</h2>\n";
  for (const FuzzedCause& cause : report.causes.all) html += fuzzed_cause_html(report, cause);
  if (const std::string words = unexamined_words(report); !words.empty()) html += fmt::format("<p>{}.</p>\n", words);
  return html + profile_html(report.profile) + std::string(page_foot);
}

void write_fuzz_report(const std::string& folder, const FuzzReport& report) {
  require_room_for_reports(folder);
  io::write_file(folder + "/search.json", fuzz_json(report));
  io::write_file(folder + "/search.html", fuzz_html(report));
}

}  // namespace durero::conform
