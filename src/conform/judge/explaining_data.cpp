#include "durero/conform/judge/explaining_data.hpp"

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "conform/judge/allowance.hpp"
#include "conform/judge/body_space.hpp"
#include "conform/judge/draft.hpp"
#include "conform/judge/limits.hpp"
#include "conform/judge/text_space.hpp"
#include "conform/judge/trial.hpp"
#include "conform/report/report_parts.hpp"
#include "durero/io/number_text.hpp"

namespace durero::conform {
namespace {

/// The point that the claim names, by binary64; the judge decides on the data built from it.
std::optional<glm::dvec3> claimed_point(const Finding& finding, const Profile& profile) {
  const Claim& claim = finding.claim;
  if (claim.outcome != Claim::Outcome::hit || is_about_all(finding.of.question)) return std::nullopt;
  const SceneFacts facts(finding.of.the_case.scene, 1, finding.of.bodies);
  const ClaimContext trial(finding.of, 0, profile, facts);
  if (!place(trial, claim)) return std::nullopt;
  if (claim.punto) return claim.punto;
  if (finding.of.question == QuestionKind::closest) return finding.of.truths[0].hit.punto;
  const glm::dvec3 &p = trial.ray.rayo.p().xyz(), &v = trial.ray.rayo.v().xyz();
  const double unit_of_t = profile.measure == Measure::length ? std::hypot(v.x, v.y, v.z) : 1;
  return p + *claim.t / unit_of_t * v;
}

double magnitude(const SuiteCase& of, const std::optional<glm::dvec3>& claimed) {
  double M = largest(of.the_case.rays[0].rayo.p().xyz());
  const AskedElements elements(of.the_case.scene, {}, of.bodies);
  of.the_case.scene.for_each([&](scene::ElementRef e, const auto&) {
    M = std::max(M, elements.visit_plain(e, [](const auto& asked) { return largest_length(asked); }));
  });
  const scene::Hit& hit = of.truths[0].hit;
  if (hit.resultado == model::Resultado::hit) M = std::max(M, largest(hit.punto));
  return claimed ? std::max(M, largest(*claimed)) : M;
}

bool is_right(const SuiteCase& of, const Claim& claim, const Profile& profile) {
  const Verdict verdict = judge(of, 0, claim, profile).verdict;
  return verdict == Verdict::exact || verdict == Verdict::right;
}

/// Whether the claim is the answer of these data: a miss exactly, also where all hits are beyond the limits of the
/// profile; the number of a hit, which is rounded, nearly.
bool has_answer(const SuiteCase& of, const Claim& claim, const Profile& profile) {
  const bool is_miss = claim.outcome == Claim::Outcome::miss;
  if (of.question == QuestionKind::closest) return is_right(of, claim, profile);
  if (of.question == QuestionKind::cast && !is_miss) return is_right(of, claim, profile);
  if (of.question == QuestionKind::shadow || is_about_all(of.question) || (is_miss && has_numbers(of.question)))
    return judge(of, 0, claim, profile).verdict == Verdict::exact;
  if (!is_miss) return is_right(of, claim, profile);
  const SceneFacts facts(of.the_case.scene, 1, of.bodies);
  return outside(of, 0, without_limits(profile)).empty() && is_all_beyond_limits(ClaimContext(of, 0, profile, facts));
}

/// Whether the claim is right for some data off by that length besides, as far as exact arithmetic can tell.
bool may_be_explained(const Finding& finding, Profile profile, double length) {
  profile.thickness += length;
  return is_right(finding.of, finding.claim, profile);
}

/// Changed data, and the size of the change as a length.
struct ChangedData {
  Draft draft;
  double off = 0;
};

/// Sets the number and returns the size of the change.
double changed(double& number, double value) { return std::abs(value - std::exchange(number, value)); }

double along(const glm::dvec3& w, const auto& shape) { return glm::dot(w - shape.centro, shape.vector); }
double across(const glm::dvec3& w, const auto& shape) {
  return glm::length(w - shape.centro - along(w, shape) * shape.vector);
}
double across(const glm::dvec3& w, const scene::Sphere& shape) { return glm::length(w - shape.centro); }

/// Makes the surface go through the point, by its radius where it has one. Returns the size of the change.
template <class Shape>
double put_through(Shape& shape, const glm::dvec3& w) {
  if constexpr (std::is_same_v<Shape, AskedBody>) {
    return 0;  // it is only moved
  } else if constexpr (std::is_same_v<Shape, scene::Triangle>) {
    auto& [a, b, c] = shape.vertices;
    const glm::dvec3 n = glm::normalize(glm::cross(b - a, c - a));
    const double off = glm::dot(w - a, n);
    for (glm::dvec3* vertex : {&a, &b, &c}) *vertex += off * n;
    return std::abs(off);
  } else if constexpr (std::is_same_v<Shape, scene::Plane> || std::is_same_v<Shape, scene::Disc>) {
    const double off = along(w, shape);
    shape.centro += off * shape.vector;
    return std::abs(off);
  } else if constexpr (std::is_same_v<Shape, scene::Cone>) {
    return changed(shape.altura, along(w, shape) + across(w, shape) / shape.proporcion);
  } else {
    double radio = across(w, shape);
    if constexpr (std::is_same_v<Shape, scene::TruncatedCone>)
      radio -= shape.proporcion * (shape.altura - along(w, shape));
    return changed(shape.radio, radio);
  }
}

/// The changed data for each element: it goes through the claimed point, or moves so that the first point is the
/// claimed one.
std::vector<ChangedData> with_point(const Finding& finding, const glm::dvec3& claimed) {
  const scene::Hit& hit = finding.of.truths[0].hit;
  const Draft given(finding.of);
  std::vector<ChangedData> all;
  for (std::size_t i = 0; i < given.elements.size(); ++i) {
    ChangedData through{given};
    const auto put = [&](auto& shape) { return put_through(shape, claimed); };
    through.off = std::visit(put, through.draft.elements[i].shape);
    all.push_back(std::move(through));
    if (hit.resultado != model::Resultado::hit) continue;
    ChangedData moved{given, largest(claimed - hit.punto)};
    for (glm::dvec3* point : places(moved.draft.elements[i].shape).points) *point += claimed - hit.punto;
    all.push_back(std::move(moved));
  }
  return all;
}

/// The coordinates and lengths of the elements and the origin.
std::vector<double*> lengths(Draft& draft) {
  std::vector<double*> all = {&draft.p.x, &draft.p.y, &draft.p.z};
  for (Draft::Element& element : draft.elements) {
    const Places of = places(element.shape);
    for (glm::dvec3* point : of.points) all.insert(all.end(), {&point->x, &point->y, &point->z});
    all.insert(all.end(), of.lengths.begin(), of.lengths.end());
  }
  return all;
}

/// The search for data with the smallest change that explains the claim.
class DataSearch {
 public:
  DataSearch(const Finding& finding, const Profile& profile, double unit)
      : finding_(&finding), profile_(&profile), unit_(unit), given_(finding.of), count_(lengths(given_).size()) {}

  void attempt(const ChangedData& candidate) {
    const double off = candidate.off / unit_;
    if (!(off > 0) || (nearest_ && off >= nearest_->off)) return;
    std::optional<SuiteCase> of = candidate.draft.built(finding_->of);
    if (of && has_answer(*of, finding_->claim, *profile_)) nearest_ = {std::move(*of), off};
  }

  /// Tries changes of one number by 2^k units.
  void attempt_steps(int k) {
    for (std::size_t i = 0; i < count_; ++i) {
      for (const double sign : {1.0, -1.0}) {
        ChangedData candidate{given_};
        double& number = *lengths(candidate.draft)[i];
        candidate.off = changed(number, number + sign * std::ldexp(unit_, k));
        attempt(candidate);
      }
    }
  }

  bool has_nearer_than(int k) const { return nearest_ && nearest_->off <= std::ldexp(1, k); }
  std::optional<ExplainingData::Nearest> result() && { return std::move(nearest_); }

 private:
  const Finding* finding_;
  const Profile* profile_;
  double unit_;
  Draft given_;
  std::size_t count_;
  std::optional<ExplainingData::Nearest> nearest_;
};

}  // namespace

std::optional<ExplainingData> explaining_data(const Finding& finding, const Profile& profile) {
  const std::optional<glm::dvec3> claimed = claimed_point(finding, profile);
  const bool has_answer = claimed || finding.claim.outcome == Claim::Outcome::miss || is_about_all(finding.of.question);
  if (!is_failure(finding.judgement.verdict) || !has_answer) return std::nullopt;
  ExplainingData data{.epsilon = unit(profile.format), .M = magnitude(finding.of, claimed)};
  const double unit_of_data = data.epsilon * data.M;
  if (!(unit_of_data > 0) || !std::isfinite(data.M)) return std::nullopt;
  constexpr int declared = 4;                // 16 = 2⁴
  data.most = 2 - std::ilogb(data.epsilon);  // data off by 4M have little to do with those given
  int k = declared;
  while (k <= data.most && !may_be_explained(finding, profile, std::ldexp(unit_of_data, k))) data.excluded = k++;
  DataSearch search(finding, profile, unit_of_data);
  if (claimed) {
    for (const ChangedData& candidate : with_point(finding, *claimed)) search.attempt(candidate);
  }
  for (k = data.excluded.value_or(declared); k <= data.most && !search.has_nearer_than(k); ++k) search.attempt_steps(k);
  data.nearest = std::move(search).result();
  return data;
}

std::string explaining_text(const ExplainingData& data, const Profile& profile) {
  std::string text = fmt::format("ε = 2^{}, M = {}\n", std::ilogb(data.epsilon), io::number_text(data.M));
  text += data.excluded ? fmt::format("No data off by 2^{} ε·M or less, {:.3g}, have that answer: proved.\n",
                                      *data.excluded, std::ldexp(data.epsilon * data.M, *data.excluded))
                        : "No data within the declared backward error have that answer: proved.\n";
  if (!data.nearest)
    return text + fmt::format("Data that have it were looked for up to 2^{} ε·M, and none were found.\n", data.most);
  return text + fmt::format("The nearest data found that have it are off by 2^{:.1f} ε·M, {:.3g}:\n{}",
                            std::log2(data.nearest->off), data.nearest->off * data.epsilon * data.M,
                            shown_question(data.nearest->of, {}, profile.caps));
}

}  // namespace durero::conform
