// durero conform answer [--engine E]: this program as a system, which is asked as any other is.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>

#include "answer_besides.hpp"
#include "commands.hpp"
#include "conform.hpp"
#include "description.hpp"
#include "durero/composed/engine.hpp"
#include "durero/conform/ask/question.hpp"
#include "durero/conform/judge/cast_truth.hpp"
#include "durero/conform/judge/truth.hpp"
#include "durero/distance/distances.hpp"
#include "durero/io/standard_output.hpp"
#include "durero/surface/exact.hpp"
#include "engines.hpp"

namespace durero::cli {
namespace {

conform::Claim claim_of(const scene::Hit& hit) {
  using Outcome = conform::Claim::Outcome;
  switch (hit.resultado) {
    case model::Resultado::hit:
      return {.outcome = Outcome::hit, .element = hit.elementos.front(), .t = hit.t, .punto = hit.punto};
    case model::Resultado::miss:
      return {.outcome = Outcome::miss};
    case model::Resultado::no_minimum:
      return {.why = "no point of the elements is the nearest"};
  }
  __builtin_unreachable();  // a Resultado is one of its enumerators
}

/// The answer to a shadow ray: whether the first hit is not behind its end. A stretch inside a surface begins before.
conform::Claim shadow_of(const scene::Hit& hit, double end) {
  using Outcome = conform::Claim::Outcome;
  const bool is_hit =
      hit.resultado == model::Resultado::no_minimum || (hit.resultado == model::Resultado::hit && hit.t <= end);
  return {.outcome = is_hit ? Outcome::hit : Outcome::miss};
}

/// The line that a system writes for the claim; a ray without an answer is refused.
std::string answer_line(const conform::Claim& claim, const scene::Scene& scene) {
  return claim.outcome == conform::Claim::Outcome::unanswered ? "refused " + claim.why
                                                              : conform::claim_text(claim, scene);
}

using surface::exact::Parameter;

/// Whether a crossing has a point within a range.
bool is_within(const surface::exact::Segment& segment, const conform::AskedRange& range) {
  const bool begins_before_end =
      segment.begin ? surface::exact::order(*segment.begin, {.x = range.end}) <= 0 : range.end > 0;
  return range.begin <= range.end && begins_before_end &&
         !(segment.end && surface::exact::order(*segment.end, {.x = range.begin}) < 0);
}

/// The first parameter of a crossing that is within a range; without a value it is t → 0⁺.
std::optional<Parameter> first_within(const surface::exact::Segment& segment, const conform::AskedRange& range) {
  const Parameter begin{.x = range.begin};
  const bool begins_before = !segment.begin || surface::exact::order(*segment.begin, begin) < 0;
  return begins_before && range.begin > 0 ? begin : segment.begin;
}

/// The first hit within a range, from all crossings by exact arithmetic, whatever the engine.
scene::Hit hit_within(const conform::Question& question, std::size_t number) {
  const scene::Query& ray = question.rays[number];
  const conform::AskedRange& range = question.ranges[number];
  std::optional<Parameter> first;
  scene::ElementSet elements, without_minimum;
  for (const auto& [element, segment] : conform::all_crossings(question.scene, ray, question.bodies)) {
    if (!is_within(segment, range)) continue;
    const std::optional<Parameter> at = first_within(segment, range);
    if (!at) without_minimum.push_back(element);
    if (!at || (first && surface::exact::order(*at, *first) > 0)) continue;
    if (first && surface::exact::order(*at, *first) < 0) elements.clear();
    first = at;
    elements.push_back(element);
  }
  if (!without_minimum.empty()) return {.resultado = model::Resultado::no_minimum, .elementos = without_minimum};
  if (!first) return {};
  std::sort(elements.begin(), elements.end());
  return surface::exact::rounded_hit(ray.rayo, *first, elements);
}

/// All hits of a ray, from all crossings by exact arithmetic, whatever the engine. A stretch inside a surface is hit at
/// both its ends.
conform::Claim all_hits_of(const conform::Question& question, std::size_t number) {
  const scene::Query& ray = question.rays[number];
  struct End {
    Parameter t;
    scene::ElementRef element;
  };
  std::vector<End> ends;
  for (const auto& [element, segment] : conform::all_crossings(question.scene, ray, question.bodies)) {
    if (!segment.begin) return {.why = "no point of the elements is the nearest"};
    ends.push_back({*segment.begin, element});
    if (segment.end && *segment.end != *segment.begin) ends.push_back({*segment.end, element});
  }
  std::ranges::stable_sort(ends, [](const End& a, const End& b) { return surface::exact::order(a.t, b.t) < 0; });
  if (ends.empty()) return {.outcome = conform::Claim::Outcome::miss};
  std::vector<conform::Claim> all;
  for (const auto& [t, element] : ends) all.push_back(claim_of(surface::exact::rounded_hit(ray.rayo, t, {element})));
  conform::Claim first = all.front();
  first.behind.assign(all.begin() + 1, all.end());
  return first;
}

/// The number of a list of hits; without one, the reason.
conform::Claim counted(const conform::Claim& all) {
  if (all.outcome == conform::Claim::Outcome::unanswered) return all;
  const bool is_hit = all.outcome == conform::Claim::Outcome::hit;
  return {.outcome = all.outcome, .count = is_hit ? 1 + all.behind.size() : 0};
}

/// The first hits of rays: where there is a torus, which engines have not, by exact arithmetic.
std::vector<scene::Hit> first_hits_of(const conform::Question& question, const engine::Engine& engine) {
  const bool has_torus = std::ranges::any_of(
      question.bodies, [](const conform::NamedBody& named) { return named.body.kind == conform::BodyKind::toro; });
  if (!has_torus) return engine::first_hits(engine, question.rays);
  std::vector<scene::Hit> hits;
  for (const conform::ExactAnswer& truth : conform::truths(question.scene, question.rays, question.bodies))
    hits.push_back(truth.hit);
  return hits;
}

/// The claims on the first hits of rays, or on what is before the ends of shadow rays.
std::vector<conform::Claim> claims_on_first(const conform::Question& question, const engine::Engine& engine) {
  std::vector<conform::Claim> claims;
  const std::vector<scene::Hit> hits = first_hits_of(question, engine);
  for (std::size_t i = 0; i < hits.size(); ++i)
    claims.push_back(question.ranges.empty() ? claim_of(hits[i]) : shadow_of(hits[i], question.ranges[i].end));
  return claims;
}

/// The nearest point of the scene as a hit, with its distance for t.
conform::Claim nearest_to(const distance::Distances& distances, const glm::dvec3& p) {
  distance::DistanceWork work;
  const scene::Proximity is = distances.nearest(p, work);
  if (is.count == scene::NearestCount::none) return {.outcome = conform::Claim::Outcome::miss};
  return {
      .outcome = conform::Claim::Outcome::hit, .element = is.elementos.front(), .t = is.distance, .punto = is.point};
}

/// The first touches of balls, with the place of contact.
std::vector<conform::Claim> claims_on_casts(const conform::Question& question) {
  std::vector<conform::Claim> claims;
  for (const conform::ExactAnswer& truth : conform::truths_of_casts(question.scene, question.rays, question.ranges)) {
    claims.push_back(claim_of(truth.hit));
    if (claims.back().punto)
      claims.back().punto = conform::contact_of(question.scene, truth.hit.elementos.front(), truth.hit.punto);
  }
  return claims;
}

/// The claims on the rays of a question.
std::vector<conform::Claim> claims_of(const conform::Question& question, const engine::Engine& engine) {
  using Kind = conform::QuestionKind;
  const auto each = [&](const auto& claim_on) {
    std::vector<conform::Claim> claims;
    for (std::size_t i = 0; i < question.rays.size(); ++i) claims.push_back(claim_on(i));
    return claims;
  };
  switch (question.kind) {
    case Kind::first:
    case Kind::shadow:
      return claims_on_first(question, engine);
    case Kind::range:
      return each([&](std::size_t i) { return claim_of(hit_within(question, i)); });
    case Kind::all:
      return each([&](std::size_t i) { return all_hits_of(question, i); });
    case Kind::closest: {
      const distance::Distances distances(question.scene);
      return each([&](std::size_t i) { return nearest_to(distances, question.rays[i].rayo.p().xyz()); });
    }
    case Kind::cast:
      return claims_on_casts(question);
    case Kind::count:
      return each([&](std::size_t i) { return counted(all_hits_of(question, i)); });
  }
  __builtin_unreachable();  // a QuestionKind is one of its enumerators
}

/// Adds what may be said besides to a hit that has a point, and to those behind it.
void add_besides_of_all(conform::Claim& claim, const scene::Scene& scene, const scene::Query& ray) {
  const auto add = [&](conform::Claim& hit) {
    if (hit.punto && scene.body(*hit.element) == nullptr) add_besides(hit, scene, ray);
  };
  add(claim);
  for (conform::Claim& behind : claim.behind) add(behind);
}

int answer(const std::string& engine_name, bool says_more) {
  io::print(fmt::format("system durero {} {}\n", DURERO_VERSION, engine_name));
  conform::QuestionReader questions(*stdin);
  while (const auto question = questions.next()) {
    const auto engine = composed::prepared(*engine::find(engine_name), question->scene);
    std::string answers;
    std::vector<conform::Claim> claims = claims_of(*question, *engine);
    for (std::size_t i = 0; i < claims.size(); ++i) {
      const bool has_besides =
          question->kind != conform::QuestionKind::closest && question->kind != conform::QuestionKind::cast;
      if (says_more && has_besides) add_besides_of_all(claims[i], question->scene, question->rays[i]);
      answers += answer_line(claims[i], question->scene) + "\n";
    }
    io::print(answers);
  }
  return 0;
}

}  // namespace

void add_conform_answer(CLI::App& conform, int& status) {
  auto* command = conform.add_subcommand("answer", "Answer questions on the standard input, as a system does");
  const auto engine = std::make_shared<std::string>(engine::default_engine);
  add_engine(*command, *engine);
  const auto says_more = std::make_shared<bool>();
  command->add_flag("--besides", *says_more, "Say the outward normal, the side and u and v of hits besides");
  command->footer(exit_status("the questions are at an end", "the call or a question is bad") +
                  examples({"conform answer --engine exact"}));
  command->callback([engine, says_more, &status] { status = answer(*engine, *says_more); });
}

}  // namespace durero::cli
