#include "durero/conform/report/bug_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "conform/report/report_parts.hpp"
#include "durero/conform/ask/question.hpp"
#include "durero/conform/report/explanation.hpp"
#include "durero/conform/report/least_findings.hpp"

namespace durero::conform {
namespace {

bool contains(const std::vector<std::string>& words, std::string_view word) {
  return std::ranges::find(words, word) != words.end();
}

bool has_element_of(const SuiteCase& of, const std::vector<std::string>& tipos) {
  bool has = false;
  of.the_case.scene.for_each([&]<class Shape>(scene::ElementRef e, const Shape&) {
    const AskedBody* const body = find_body(of.bodies, e);
    has = has || contains(tipos, body ? word(body->kind) : Shape::word);
  });
  return has;
}

bool is_of(const KnownCause& known, const Finding& finding) {
  return contains(known.verdicts, name(finding.judgement.verdict)) &&
         (known.tipos.empty() || has_element_of(finding.of, known.tipos)) &&
         (known.families.empty() || contains(known.families, finding.of.family->name));
}

std::string block(std::string_view kind, std::string_view text) {
  return fmt::format("```{}\n{}{}```\n", kind, text, text.empty() || text.ends_with('\n') ? "" : "\n");
}

std::string expected_and_got(const Finding& finding) {
  return fmt::format("Expected {}; got {}.", truth_words(finding), claim_words(finding));
}

std::string tried_text(const BugReport& bug) {
  if (bug.variations.empty()) return "";
  std::string text = "Tried beside it:\n\n";
  for (const Variation& variation : bug.variations)
    text += fmt::format("- {}\n", variation_text(variation, bug.least.finding.judgement.verdict));
  return text + "\n";
}

std::string data_text(const BugReport& bug) {
  if (!bug.least.data) return "";
  return "\n## Data that would explain it\n\nEvery coordinate and length may be off; ε is the unit of rounding, M the "
         "largest magnitude.\n\n" +
         block("data", explaining_text(*bug.least.data, bug.system.profile));
}

std::string reproducer_part(const BugReport& bug, bool is_beside) {
  if (bug.file.empty()) return "";
  const std::string where = is_beside ? fmt::format("[{0}]({0})", bug.file) : bug.file;
  std::string text = fmt::format("\n## Reproducer\n\n{} stands alone; its first lines say how it is run. ", where);
  const bool shows = bug.reproduction.verdict == bug.least.finding.judgement.verdict;
  text += shows ? "It was run, and wrote:\n\n"
                : fmt::format("It was run and does not show the failure ({}):\n\n", bug.reproduction.words);
  text += block("reproduced", bug.reproduction.output);
  return is_beside ? text : text + "\n" + block(bug.file.substr(bug.file.rfind('.') + 1), bug.program);
}

}  // namespace

std::string bug_title(const BugReport& bug) {
  return fmt::format("{}: {}", bug.version, verdict_words(bug.least.finding.judgement.verdict));
}

std::string known_cause(const BugReport& bug) {
  const auto known =
      std::ranges::find_if(bug.system.known, [&](const KnownCause& cause) { return is_of(cause, bug.least.finding); });
  return known == bug.system.known.end() ? "" : known->cause;
}

std::string about_bug(const BugReport& bug) {
  const std::string cause = known_cause(bug);
  return fmt::format("{}\n{}\n{}{}{}", bug_title(bug), expected_and_got(bug.least.finding), cause,
                     cause.empty() ? "" : "\n", exact_answer(bug.least.finding.of, 0));
}

std::string bug_text(const BugReport& bug, bool is_beside) {
  const Finding& finding = bug.least.finding;
  const std::string question = whole_question_of(finding, bug.system.profile), cause = known_cause(bug);
  std::string text = fmt::format("# {}\n\n{} {}\n\n", bug_title(bug), expected_and_got(finding),
                                 cause.empty() ? "The cause is not known." : cause);
  text += tried_text(bug);
  text += fmt::format("{}, asked by {}: `{}`, made smaller.\n", bug.system.title, bug.asker, bug.call);
  text += "\n## Asked\n\n" + block("question", question);
  text += "\nThe same in hexadecimal:\n\n" + block("", in_hexadecimal(question_of(finding, bug.system.profile)));
  text += "\n## Got\n\n" + block("got", claim_text(finding.claim, finding.of.the_case.scene));
  text += "\n## Exact\n\n" + block("exact", exact_answer(finding.of, 0).substr(sizeof "the exact answer:"));
  return text + data_text(bug) + reproducer_part(bug, is_beside);
}

}  // namespace durero::conform
