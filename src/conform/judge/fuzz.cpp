#include "durero/conform/judge/fuzz.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>

#include "conform/judge/mutation.hpp"

namespace durero::conform {
namespace {

/// The place of a question among all: the type of what it is about, whether that is met, and powers of two of its size,
/// of the way to it, of |v| and of its place, coarsely.
using Niche = std::array<int, 6>;

/// The magnitude of a ratio, in steps of 2⁸.
int magnitude_of(double x) { return x > 0 && std::isfinite(x) ? (std::ilogb(x) + 2048) / 8 : 0; }

Niche niche_of(const Finding& finding, const MeasuredQuestion& question) {
  const double place =
      std::max({std::abs(question.middle.x), std::abs(question.middle.y), std::abs(question.middle.z)});
  return {static_cast<int>(question.draft.elements[question.target].shape.index()),
          static_cast<int>(finding.of.truths[0].hit.resultado),
          magnitude_of(question.size),
          magnitude_of(question.distance / question.size),
          magnitude_of(question.length),
          magnitude_of(place / question.size)};
}

/// The number that the search makes large: failures are above all others, then the error counts in ε of the surface.
double score_of(const ClaimJudgement& is) {
  constexpr double of_failure = 1000, most = 500;
  const double error = std::isfinite(is.backward) ? std::min(most, std::log2(1 + is.backward)) : most;
  return (is_failure(is.verdict) ? of_failure : 0) + error;
}

/// A question that later ones are made from.
struct Parent {
  Finding finding;
  MeasuredQuestion question;
  double score;
};

/// The families with scenes of the options' types.
std::vector<const Family*> families_with_scenes(const SuiteOptions& options) {
  std::vector<const Family*> all = chosen_families(options);
  std::erase_if(all, [&](const Family* family) { return cases(options, *family) == 0; });
  if (all.empty())
    throw std::invalid_argument("no family has a scene of these types of elements; expected one that has");
  return all;
}

class FuzzSearch {
 public:
  FuzzSearch(const FuzzOptions& options, const Profile& profile, const Ask& ask)
      : suite_(options.suite), profile_(&profile), ask_(&ask), random_(options.suite.seed) {
    suite_.rays = numbers * rays_of_a_mesh;
    for (const Family* family : families_with_scenes(suite_))
      (is_of_meshes(*family) ? of_meshes_ : of_few_).push_back(family);
  }

  void step(const std::function<bool()>& goes_on) {
    const std::uint64_t number = result_.steps++;
    const std::optional<SuiteCase> of = next_question();
    if (!of || !outside(*of, 0, *profile_).empty()) return;
    const Claim claim = (*ask_)(*of);
    if (!goes_on()) return;
    ++result_.asked;
    add({*of, 0, claim, judge(*of, 0, claim, *profile_)}, number);
  }

  const Fuzzing& result() const { return result_; }

 private:
  static constexpr std::uint64_t numbers = 1 << 20;  // of a family's cases

  std::optional<SuiteCase> next_question() {
    constexpr std::size_t few = 64;
    if (parents_.size() < few || random_.chance(1, 16)) return fresh();
    const Parent &a = some_parent(), &b = some_parent();
    const Parent& better = (a.score > b.score) == random_.chance(3, 4) ? a : b;
    const Parent& other = some_parent();
    Draft draft = mutated(better.question, other.question.draft, random_);
    if (suite_.numbers == NumberFormat::binary32) round_to_binary32(draft);
    return draft.elements.empty() ? std::nullopt : draft.built(better.finding.of);
  }

  const Parent& some_parent() { return parents_[random_.below(parents_.size())]; }

  /// A ray of a case of a family; of meshes, which take longer, fewer.
  std::optional<SuiteCase> fresh() {
    const bool is_mesh = of_few_.empty() || (!of_meshes_.empty() && random_.chance(1, 16));
    const Family& family = *random_.any_of(is_mesh ? of_meshes_ : of_few_);
    SuiteCase of = suite_case(suite_, family, random_.below(numbers));
    const scene::Query ray = random_.any_of(of.the_case.rays);
    of.the_case.rays = {ray};
    answer(of);
    ask_question(of, suite_);
    return of;
  }

  void add(Finding finding, std::uint64_t number) {
    MeasuredQuestion question(finding, *profile_);
    const Niche niche = niche_of(finding, question);
    if (is_failure(finding.judgement.verdict)) add_failure(finding, niche, number);
    const double score = score_of(finding.judgement);
    const auto [at, is_new] = places_.emplace(niche, parents_.size());
    if (is_new)
      parents_.push_back({std::move(finding), std::move(question), score});
    else if (score >= parents_[at->second].score)
      parents_[at->second] = {std::move(finding), std::move(question), score};
  }

  void add_failure(const Finding& finding, const Niche& niche, std::uint64_t number) {
    constexpr std::size_t most_kinds = 1024;
    ++result_.failures;
    const std::pair key{finding.judgement.verdict, niche};
    if (result_.failing.size() == most_kinds && !kinds_.contains(key)) return;
    const auto [at, is_new] = kinds_.emplace(key, result_.failing.size());
    if (is_new) result_.failing.push_back({finding, number});
    FuzzedFailure& kind = result_.failing[at->second];
    ++kind.alike;
    if (is_worse(finding.judgement, finding.of.the_case.scene.size(), kind.finding))
      kind = {finding, number, kind.alike};
  }

  SuiteOptions suite_;
  const Profile* profile_;
  const Ask* ask_;
  Random random_;
  std::vector<const Family*> of_few_, of_meshes_;
  std::vector<Parent> parents_;
  std::map<Niche, std::size_t> places_;                     // of the parents
  std::map<std::pair<Verdict, Niche>, std::size_t> kinds_;  // of the failures
  Fuzzing result_;
};

}  // namespace

Fuzzing fuzz(const FuzzOptions& options, const Profile& profile, const Ask& ask, const std::function<bool()>& goes_on) {
  FuzzSearch search(options, profile, ask);
  while ((options.steps == 0 || search.result().steps < options.steps) && goes_on()) search.step(goes_on);
  return search.result();
}

}  // namespace durero::conform
