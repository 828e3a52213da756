#include "conform/families/suite_text.hpp"

#include <algorithm>
#include <span>

#include "conform/families/family_table.hpp"
#include "conform/judge/scene_tree.hpp"
#include "durero/conform/ask/claims_file.hpp"
#include "durero/conform/ask/ranges_file.hpp"
#include "durero/conform/format_versions.hpp"
#include "durero/io/json/json_writer.hpp"
#include "durero/io/json/scene_file.hpp"
#include "durero/io/rays/hits_file.hpp"
#include "durero/io/rays/rays_file.hpp"

namespace durero::conform {
namespace {

using io::json::Writer;

void write_solids(Writer& out, const SuiteCase& of) {
  const scene::Scene& scene = of.the_case.scene;
  out.key("solids").begin_array();
  for (const Solid& solid : of.solids) {
    out.begin_object().member("wall", scene.name(solid.wall).name()).key("discs").begin_array();
    for (const scene::ElementRef disc : solid.discs) out.value(scene.name(disc).name());
    out.end_array().end_object();
  }
  out.end_array();
}

/// A case without bodies says nothing of them.
void write_bodies(Writer& out, const SuiteCase& of) {
  if (of.bodies.empty()) return;
  out.new_line().key("bodies").begin_array();
  for (const auto& [element, body] : of.bodies) {
    out.begin_object().member("id", of.the_case.scene.name(element).name()).member("tipo", word(body.kind));
    out.member("centro", body.centro).member("x", body.sides[0]).member("y", body.sides[1]);
    out.member("z", body.sides[2]);
    if (has_radius(body.kind)) out.member("radio", body.radio);
    out.end_object();
  }
  out.end_array();
}

void write_truths(Writer& out, const SuiteCase& of) {
  out.key("truths").begin_array();
  for (std::size_t i = 0; i < of.truths.size(); ++i) {
    const ExactAnswer& truth = of.truths[i];
    out.new_line().begin_object().member("ray", std::uint64_t{i}).member("ambiguity", name(truth.ambiguity));
    out.key("permissible").begin_array();
    for (const scene::Hit& hit : truth.permissible) {
      io::write_hit(out.begin_object(), hit, of.the_case.scene);
      out.end_object();
    }
    out.end_array().end_object();
  }
  out.end_array();
}

void write_family(Writer& out, const Family& family) {
  out.member("family", family.name).member("kind", family.kind).member("reason", family.reason);
}

void write_count(Writer& out, const Count& count) {
  out.member("rays", std::uint64_t{count.rays}).member("members", std::uint64_t{count.members});
  out.member("exact", std::uint64_t{count.exact});
}

double number(int x) { return x; }

std::string sidecar_text(const SuiteCase& of, const Count& counted) {
  std::string text;
  Writer out(text);
  write_version(out.begin_object(), case_format);
  write_family(out, *of.family);
  out.new_line().member("number", of.number).key("parameter").begin_object();
  out.member("name", of.family->parameter.name).member("value", number(of.parameter)).end_object();
  write_count(out, counted);
  write_solids(out.new_line(), of);
  write_bodies(out, of);
  write_truths(out.new_line(), of);
  out.end_object();
  return text + '\n';
}

std::string hits_text(const std::vector<scene::Hit>& hits, const scene::Scene& scene) {
  std::string text;
  for (std::size_t i = 0; i < hits.size(); ++i) text += io::hit_text(i, hits[i], scene) + '\n';
  return text;
}

/// The exact answer to a question that is not the first hit, as a program claims it. A stretch inside a surface from
/// the start begins at t = 0.
Claim exact_claim(const SuiteCase& of, std::size_t ray) {
  using Outcome = Claim::Outcome;
  const auto& [hit, ambiguity, permissible, all] = of.truths[ray];
  const auto claim_of = [](const scene::Hit& at) {
    return Claim{.outcome = Outcome::hit, .element = at.elementos.front(), .t = at.t, .punto = at.punto};
  };
  if (of.question == QuestionKind::count)
    return {.outcome = all.empty() ? Outcome::miss : Outcome::hit, .count = all.size()};
  if (hit.resultado == model::Resultado::miss) return {.outcome = Outcome::miss};
  const bool is_from_start = hit.resultado == model::Resultado::no_minimum;
  if (of.question == QuestionKind::shadow)
    return {.outcome = is_from_start || hit.t <= of.ranges[ray].end ? Outcome::hit : Outcome::miss};
  if (of.question == QuestionKind::cast)  // the hit has the middle of the ball, and no place of contact
    return {.outcome = Outcome::hit, .element = hit.elementos.front(), .t = hit.t};
  if (of.question != QuestionKind::all) return claim_of(is_from_start ? permissible.front() : hit);
  Claim first = claim_of(all.front());
  for (const scene::Hit& behind : std::span(all).subspan(1)) first.behind.push_back(claim_of(behind));
  return first;
}

std::string claims_text(const SuiteCase& of) {
  std::string text;
  for (std::size_t ray = 0; ray < of.truths.size(); ++ray) text += claim_json(of, ray, exact_claim(of, ray)) + '\n';
  return text;
}

void write_summary(Writer& out, const FamilySummary& of, NumberFormat numbers) {
  const Range range = parameter(*of.family, numbers);
  out.new_line().begin_object();
  write_family(out, *of.family);
  out.key("parameter").begin_object().member("name", range.name).member("least", number(range.least));
  out.member("greatest", number(range.greatest)).end_object();
  out.new_line().member("cases", std::uint64_t{of.cases});
  write_count(out, of.count);
  out.key("ambiguity").begin_object();
  for (std::size_t i = 0; i < ambiguity_count; ++i)
    out.member(name(static_cast<Ambiguity>(i)), std::uint64_t{of.ambiguities[i]});
  out.end_object().end_object();
}

}  // namespace

std::vector<File> case_files(const SuiteCase& of, const Count& counted) {
  const auto& [scene, rays] = of.the_case;
  std::vector<scene::Hit> hits;
  for (const ExactAnswer& truth : of.truths) hits.push_back(truth.hit);
  std::vector<File> files = {{scene_ending, io::scene_text(scene)},    {rays_ending, io::rays_text(rays, scene)},
                             {".rays.npy", io::rays_npy(rays)},        {".hits.jsonl", hits_text(hits, scene)},
                             {".hits.npy", io::hits_npy(hits, scene)}, {sidecar_ending, sidecar_text(of, counted)}};
  if (has_numbers(of.question)) files.push_back({ranges_ending, ranges_text(of.question, of.ranges)});
  if (of.question != QuestionKind::first) files.push_back({".claims.jsonl", claims_text(of)});
  return files;
}

std::string suite_text(const SuiteOptions& options, const std::vector<FamilySummary>& families) {
  std::string text;
  Writer out(text);
  write_version(out.begin_object(), suite_format);
  out.member("seed", options.seed).member("rays", std::uint64_t{options.rays});
  out.member("numbers", word(options.numbers)).member("caps", word(options.caps)).key("tipos").begin_array();
  const bool are_all = options.tipos.empty() && options.bodies.empty();
  scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
    const auto& asked = options.tipos;
    if (are_all || std::find(asked.begin(), asked.end(), Shape::tipo) != asked.end()) out.value(Shape::word);
  });
  for (std::size_t i = 0; i < kind_count; ++i) {
    const auto kind = static_cast<BodyKind>(i);
    if ((are_all && i < body_count) || std::ranges::find(options.bodies, kind) != options.bodies.end())
      out.value(word(kind));
  }
  out.end_array();
  if (options.faces != usual_faces) out.member("faces", std::uint64_t{options.faces});
  if (options.question != QuestionKind::first) out.member("question", word(options.question));
  out.new_line().key("families").begin_array();
  for (const FamilySummary& of : families) write_summary(out, of, options.numbers);
  out.end_array().end_object();
  return text + '\n';
}

FamilySummary summary(const SuiteCase& of) {
  FamilySummary counted{.family = of.family, .cases = 1};
  const Questions& questions = row_of(*of.family).questions;
  std::optional<SceneTree> tree;
  if (!of.bodies.empty()) tree.emplace(of.the_case.scene, of.truths.size(), of.bodies);
  for (std::size_t i = 0; i < of.truths.size(); ++i) {
    const AnsweredQuery answered{of.the_case.scene, of.the_case.rays[i], of.truths[i].hit, tree ? &*tree : nullptr};
    const bool is_member = questions.is_member(answered);
    counted.count += {1, is_member, is_member && questions.is_exact(answered)};
    ++counted.ambiguities[static_cast<std::size_t>(of.truths[i].ambiguity)];
  }
  return counted;
}

FamilySummary& FamilySummary::operator+=(const FamilySummary& other) {
  cases += other.cases;
  count += other.count;
  for (std::size_t i = 0; i < ambiguity_count; ++i) ambiguities[i] += other.ambiguities[i];
  return *this;
}

}  // namespace durero::conform
