#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "conform/judge/measured_question.hpp"
#include "conform/report/report_parts.hpp"

namespace durero::conform {
namespace {

std::string percent(double share) { return fmt::format("{:.2g} %", 100 * share); }

std::string share_words(const CauseShare& share) {
  return fmt::format("{} of {} are wrong by it, {} (with 95 %: {} to {})", share.failing, share.rays,
                     percent(static_cast<double>(share.failing) / static_cast<double>(share.rays)),
                     percent(share.least), percent(share.greatest));
}

std::string rays_words(std::uint64_t count) { return fmt::format("{} failing ray{}", count, count == 1 ? "" : "s"); }

/// The type of the element that a failure is about, in files' words.
std::string_view tipo_of(const Finding& finding, const Profile& profile) {
  const MeasuredQuestion question(finding, profile);
  return word_of(question.draft.elements[question.target].shape);
}

}  // namespace

std::string cause_title(Trait trait, const Finding& finding, const Profile& profile) {
  if (trait != Trait::none) return std::string(title(trait));
  return fmt::format("{}: {}", title(trait), tipo_of(finding, profile));
}

std::string causes_words(const Report& report) {
  const Causes& causes = report.causes;
  const std::size_t count = causes.all.size();
  std::string words = fmt::format("{} cause{}", count, count == 1 ? "" : "s");
  words += causes.were_asked ? fmt::format(", by what makes {} right", rays_words(causes.examined))
                             : fmt::format(", guessed from what {} have in common: no system was asked again",
                                           rays_words(causes.examined));
  if (causes.left_out > 0)
    words += fmt::format("; {} more were not asked again, as the time was over", causes.left_out);
  return words;
}

std::string severity_words(const Report& report, const Cause& cause) {
  std::optional<int> most;
  double epsilon = 0;
  for (const FindingKey& key : cause.findings) {
    const auto least = report.least.find(key);
    if (least == report.least.end() || !least->second.data || !least->second.data->excluded) continue;
    most = std::max(most.value_or(0), *least->second.data->excluded);
    epsilon = least->second.data->epsilon;
  }
  if (!most) return "";
  const double share = std::ldexp(epsilon, *most);
  return fmt::format("the worst is the answer of no data off by 2^{} ε·M or less{}", *most,
                     share < 0.001 ? ""
                     : share < 1   ? fmt::format(", {} of their largest magnitude", percent(share))
                                   : fmt::format(", {:g} times their largest magnitude", share));
}

const Finding* shown_finding(const Report& report, const Cause& cause) {
  if (cause.findings.empty()) return nullptr;
  const FindingKey& key = cause.findings.front();
  const auto& families = report.tally.families();
  const auto family = std::ranges::find(families, key.family, [](const FamilyTally& of) { return of.family->name; });
  return &*family->worst[static_cast<std::size_t>(key.verdict)];
}

const LeastFinding* shown_least(const Report& report, const Cause& cause) {
  if (cause.findings.empty()) return nullptr;
  const auto least = report.least.find(cause.findings.front());
  return least == report.least.end() ? nullptr : &least->second;
}

std::vector<CauseLine> cause_lines(const Report& report, const Cause& cause) {
  std::vector<std::string> verdicts;
  for (const Verdict verdict : cause.verdicts) verdicts.push_back(verdict_words(verdict));
  std::vector<CauseLine> lines;
  const std::string_view cure = remedy(cause.trait);
  if (report.causes.were_asked)
    lines.push_back({"right", cure.empty() ? "with no change that was tried" : cure.data()});
  lines.push_back({"rays", fmt::format("{}: {}", rays_words(cause.examined), fmt::join(verdicts, ", "))});
  lines.push_back({"families", fmt::format("{}", fmt::join(cause.families, ", "))});
  if (cause.ordinary) lines.push_back({"ordinary rays", share_words(*cause.ordinary)});
  if (std::string words = severity_words(report, cause); !words.empty())
    lines.push_back({"severity", std::move(words)});
  return lines;
}

}  // namespace durero::conform
