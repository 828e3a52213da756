#include "durero/conform/judge/trait.hpp"

#include <algorithm>

#include "conform/judge/remedy.hpp"
#include "durero/conform/judge/minimise.hpp"

namespace durero::conform {
namespace {

struct TraitRow {
  Trait trait;
  std::string_view name, title, remedy;
};

constexpr TraitRow rows[trait_count] = {
    {Trait::minus_zero, "minus_zero", "A zero has a minus sign", "with 0 for −0"},
    {Trait::not_unit, "not_unit", "The direction is not of length 1", "with v/|v| for v"},
    {Trait::small, "small", "The element is small", "with the whole scene scaled to a size near 1"},
    {Trait::large, "large", "The element is large", "with the whole scene scaled to a size near 1"},
    {Trait::far_from_zero, "far_from_zero", "The scene is far from (0, 0, 0)", "with the element moved to (0, 0, 0)"},
    {Trait::far_origin, "far_origin", "The origin is far from the element", "with an origin two sizes before it"},
    {Trait::inside, "inside", "The ray starts inside an element", "with an origin before the element"},
    {Trait::near_surface, "near_surface", "The ray starts at the surface", "with an origin farther back"},
    {Trait::several, "several", "There are several elements", "with the element alone that is met first"},
    {Trait::one_sided, "one_sided", "A triangle is seen from one side", "with its corners in the other order"},
    {Trait::coincidence, "coincidence", "The exact answer hangs on a rounding: a tangent, an end, an edge or a tie",
     "with p and v off by six roundings"},
    {Trait::parallel, "parallel", "A direction is parallel to an axis or a plane of coordinates",
     "with scene and ray turned askew"},
    {Trait::one_axis, "one_axis", "The axes of coordinates are not alike", "with x, y and z in another order"},
    {Trait::grazing, "grazing", "The ray goes by an end, an edge or a limb",
     "with a ray from the same origin to the middle of the element"},
    {Trait::none, "none", "The cause is not known", ""},
};

const TraitRow& row(Trait trait) { return rows[static_cast<std::size_t>(trait)]; }

/// The asker of what cures a failure.
class Curing {
 public:
  Curing(const Finding& finding, const Profile& profile, const Ask& ask)
      : finding_(&finding), profile_(&profile), ask_(&ask), question_(finding, profile) {}

  bool cures(Trait trait) const {
    const Remedy remedy = remedy_of(trait, question_, finding_->of, *profile_);
    if (remedy.cures.empty()) return false;
    const auto is_cured = [&](const Draft& draft) { return is_right(trait, draft).value_or(false); };
    return std::ranges::all_of(remedy.cures, is_cured) && !(remedy.control && is_cured(*remedy.control)) &&
           std::ranges::all_of(remedy.cures, [&](const Draft& cure) { return is_lasting(trait, cure); });
  }

 private:
  /// Whether no rounding of the cured question brings the failure back: a system that is right or wrong by chance is
  /// cured by nothing.
  bool is_lasting(Trait trait, const Draft& cure) const {
    return std::ranges::all_of(shaken(cure, *profile_),
                               [&](const Draft& draft) { return is_right(trait, draft).value_or(true); });
  }

  /// Whether the system is right about the question; nothing where it shows nothing.
  std::optional<bool> is_right(Trait trait, const Draft& draft) const {
    const std::optional<SuiteCase> of = draft.built(finding_->of);
    if (!of || !outside(*of, 0, *profile_).empty() || !corresponds(trait, question_, finding_->of, *of))
      return std::nullopt;
    const Verdict verdict = judge(*of, 0, (*ask_)(*of), *profile_).verdict;
    return verdict == Verdict::exact || verdict == Verdict::right;
  }

  const Finding* finding_;
  const Profile* profile_;
  const Ask* ask_;
  MeasuredQuestion question_;
};

/// The traits that a question is seen to have, the rarest first.
constexpr Trait visible[] = {Trait::minus_zero, Trait::coincidence, Trait::inside,  Trait::near_surface,
                             Trait::far_origin, Trait::small,       Trait::large,   Trait::far_from_zero,
                             Trait::parallel,   Trait::not_unit,    Trait::several, Trait::none};

}  // namespace

std::string_view name(Trait trait) { return row(trait).name; }
std::string_view title(Trait trait) { return row(trait).title; }
std::string_view remedy(Trait trait) { return row(trait).remedy; }

Trait cause_of(const Finding& finding, const Profile& profile, const Ask& ask) {
  if (finding.judgement.verdict == Verdict::hung) return Trait::none;
  const Finding tidy = tidied(finding, profile, ask);
  const Curing curing(tidy, profile, ask);
  const auto* const found = std::ranges::find_if(rows, [&](const TraitRow& each) { return curing.cures(each.trait); });
  return found == std::end(rows) ? Trait::none : found->trait;
}

Trait likely_cause(const Finding& finding, const Profile& profile) {
  const MeasuredQuestion question(finding, profile);
  const auto* const found = std::ranges::find_if(visible, [&](Trait trait) {
    const std::vector<Draft> cures = remedy_of(trait, question, finding.of, profile).cures;
    if (cures.empty() || (trait != Trait::inside && trait != Trait::near_surface)) return !cures.empty();
    const std::optional<SuiteCase> of = cures[0].built(finding.of);
    return of && corresponds(trait, question, finding.of, *of);
  });
  return found == std::end(visible) ? Trait::none : *found;
}

}  // namespace durero::conform
