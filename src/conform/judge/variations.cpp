#include "durero/conform/judge/variations.hpp"

#include <fmt/format.h>

#include <cmath>

#include "conform/judge/draft.hpp"
#include "conform/report/report_parts.hpp"

namespace durero::conform {
namespace {

void make_unit(Draft& draft) {
  const double length = std::hypot(draft.v.x, draft.v.y, draft.v.z);
  draft.v /= length;
  scale_range(draft, length);
}

/// Moves the origin seven eighths of the way to the point at t, rounded.
void come_nearer(Draft& draft, double t) { move_along(draft, 0.875 * t); }

class Varying {
 public:
  Varying(const Finding& finding, const Profile& profile, const Ask& ask)
      : finding_(&finding), profile_(&profile), ask_(&ask) {}

  template <class Change>
  void attempt(std::string what, Change change) {
    Draft draft(finding_->of);
    const Draft given = draft;
    change(draft);
    if (draft.p == given.p && draft.v == given.v) return;
    std::optional<SuiteCase> of = draft.built(finding_->of);
    if (!of || !outside(*of, 0, *profile_).empty()) return;
    const Claim claim = (*ask_)(*of);
    const ClaimJudgement judgement = judge(*of, 0, claim, *profile_);
    all_.push_back({std::move(what), {std::move(*of), 0, claim, judgement}});
  }

  std::vector<Variation> result() && { return std::move(all_); }

 private:
  const Finding* finding_;
  const Profile* profile_;
  const Ask* ask_;
  std::vector<Variation> all_;
};

}  // namespace

std::vector<Variation> variations(const Finding& finding, const Profile& profile, const Ask& ask) {
  Varying varying(finding, profile, ask);
  varying.attempt("With v/|v| for v", make_unit);
  Draft draft(finding.of);
  const int size = std::ilogb(size_of(draft));
  varying.attempt(fmt::format("With the whole scene and the origin scaled by 2^{}", -size),
                  [&](Draft& changed) { scale(changed, -size); });
  const scene::Hit& hit = finding.of.truths[0].hit;
  if (hit.resultado == model::Resultado::hit && finding.of.question != QuestionKind::closest)
    varying.attempt("With an origin that is eight times nearer to the first point",
                    [&](Draft& changed) { come_nearer(changed, hit.t); });
  return std::move(varying).result();
}

std::string variation_text(const Variation& variation, Verdict verdict) {
  const Verdict with = variation.answered.judgement.verdict;
  if (!is_failure(with)) return fmt::format("{} it is right.", variation.what);
  return fmt::format("{} it is {}{}.", variation.what, verdict_words(with), with == verdict ? " as well" : "");
}

}  // namespace durero::conform
