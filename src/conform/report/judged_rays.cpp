#include "durero/conform/report/judged_rays.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "conform/report/report_parts.hpp"
#include "durero/conform/report/report.hpp"
#include "durero/io/json/json_writer.hpp"

namespace durero::conform {
namespace {

std::string counts_text(std::span<const ClaimJudgement> judgements) {
  std::array<std::size_t, verdict_count> counts{};
  for (const ClaimJudgement& is : judgements) ++counts[static_cast<std::size_t>(is.verdict)];
  std::string text;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] > 0) text += fmt::format("{} {} {}", text.empty() ? ":" : ",", counts[i], verdict_words(Verdict(i)));
  }
  return fmt::format("{} ray{}{}\n", judgements.size(), judgements.size() == 1 ? "" : "s", text);
}

}  // namespace

std::string judged_rays_text(const SuiteCase& of, std::span<const Claim> claims,
                             std::span<const ClaimJudgement> judgements) {
  std::string text = counts_text(judgements);
  for (std::size_t i = 0; i < judgements.size(); ++i) {
    const ClaimJudgement& is = judgements[i];
    if (is.verdict == Verdict::skipped) text += fmt::format("ray {} skipped: {}\n", i, is.clause);
    if (!is_failure(is.verdict)) continue;
    const scene::Scene& scene = of.the_case.scene;
    text += fmt::format("ray {} {}\n", i,
                        sentence(is.verdict, truth_words(of, i, claims[i]), claim_words(claims[i], scene)));
    if (is.backward > 0) text += fmt::format("  backward error 2^{:.1f} of its unit\n", std::log2(is.backward));
  }
  return text;
}

std::string judged_rays_json(const SuiteCase& of, std::span<const Claim> claims,
                             std::span<const ClaimJudgement> judgements) {
  std::string text;
  for (std::size_t i = 0; i < judgements.size(); ++i) {
    const ClaimJudgement& is = judgements[i];
    io::json::Writer out(text);
    out.begin_object().member("ray", i).member("verdict", name(is.verdict));
    if (is_failure(is.verdict)) {
      const scene::Scene& scene = of.the_case.scene;
      out.member("expected", truth_words(of, i, claims[i])).member("got", claim_words(claims[i], scene));
    }
    if (is.verdict == Verdict::skipped) out.member("clause", is.clause);
    if (is.ulps != 0) out.member("ulps", is.ulps);
    if (is.backward != 0) out.member("backward", is.backward);
    out.end_object();
    text += '\n';
  }
  return text;
}

}  // namespace durero::conform
