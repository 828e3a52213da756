#include "durero/conform/report/least_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "conform/ask/words.hpp"
#include "conform/report/report_parts.hpp"
#include "durero/conform/judge/minimise.hpp"
#include "durero/conform/report/explanation.hpp"
#include "durero/io/number_text.hpp"

namespace durero::conform {
namespace {

using Clock = std::chrono::steady_clock;

/// The signal that the time for reductions is over.
struct OutOfTime {};

/// The findings in turns: the first of each family, then the second of each, and so on.
std::vector<const Finding*> by_turns(const Tally& tally) {
  std::vector<const Finding*> all;
  for (std::size_t turn = 0; turn < verdict_count; ++turn) {
    for (const FamilyTally* family : failures_first(tally)) {
      const std::vector<const Finding*> of_family = findings_of(*family);
      if (turn < of_family.size()) all.push_back(of_family[turn]);
    }
  }
  return all;
}

std::string hexadecimal_line(const std::string& line) {
  std::istringstream words(line);
  std::string shown;
  for (std::string word; words >> word;) {
    const auto number = io::read_finite(word);
    shown += fmt::format("{}{}", shown.empty() ? "" : " ", number ? fmt::format("{:a}", *number) : word);
  }
  return shown;
}

}  // namespace

void minimise_findings(Report& report, const Ask& ask, const LeastLimits& limits) {
  const auto end = Clock::now() + limits.time;
  const Ask within_time = [&](const SuiteCase& of) {
    if (Clock::now() >= end) throw OutOfTime();
    return ask(of);
  };
  const std::vector<const Finding*> all = by_turns(report.tally);
  for (const Finding* finding : all) {
    if (report.least.size() == limits.findings) break;
    try {
      report.least.emplace(FindingKey(*finding), least_finding(*finding, report.profile, within_time));
    } catch (const OutOfTime&) {
      break;
    }
  }
  report.not_minimised = all.size() - report.least.size();
}

std::string in_hexadecimal(const std::string& question) {
  std::string text;
  std::istringstream lines(question);
  for (std::string line; std::getline(lines, line);) {
    const bool is_head = std::ranges::find(heads_of_rays, line.substr(0, line.find(' '))) != heads_of_rays.end();
    text += (is_head ? line : hexadecimal_line(line)) + "\n";
  }
  return text;
}

LeastFinding least_finding(const Finding& finding, const Profile& profile, const Ask& ask) {
  LeastFinding least{minimised(finding, profile, ask)};
  least.data = explaining_data(least.finding, profile);
  return least;
}

std::string least_question(const LeastFinding& least, const Profile& profile) {
  return whole_question_of(least.finding, profile);
}

std::string least_text(const LeastFinding& least, const Profile& profile) {
  const std::string question = question_of(least.finding, profile);
  const std::string text = fmt::format("{}\n{}in hexadecimal:\n{}{}", sentence(least.finding), question,
                                       in_hexadecimal(question), exact_answer(least.finding.of, 0));
  return least.data ? text + explaining_text(*least.data, profile) : text;
}

}  // namespace durero::conform
