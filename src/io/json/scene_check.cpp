#include "durero/io/json/scene_check.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "durero/io/json/json_pointer.hpp"
#include "durero/io/json/sarif.hpp"
#include "durero/io/json/scene_file.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/scene/body.hpp"
#include "durero/scene/retrieve.hpp"
#include "durero/scene/stage.hpp"
#include "durero/text/shown.hpp"

namespace durero::io {
namespace {

constexpr std::string_view malformed = "malformed";
constexpr std::string_view sends_on_too_much = "conserva.def.1";

/// Puts the errors into the order of the file. Their pointers; none of a text that is no JSON.
std::vector<std::string> pointers_of(const Source& file, std::vector<InputError>& errors) {
  try {
    return json::pointers_in_order(file, errors);
  } catch (const InputError&) {
    return {};
  }
}

std::vector<SceneDefect> findings_of(const Source& file, std::vector<InputError> errors) {
  const std::vector<std::string> pointers = pointers_of(file, errors);
  std::vector<SceneDefect> findings;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    SceneDefect& finding =
        findings.emplace_back(errors[i].broken(), std::string(errors[i].message()), std::nullopt, errors[i].place());
    if (i < pointers.size()) finding.pointer = pointers[i];
  }
  return findings;
}

template <class Visit>
void for_each_count(const SceneCheck& check, Visit&& visit) {
  std::size_t written = 0;
  for (const auto& [word, count] : check.written) written += count;
  scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
    const std::size_t stand_ins = std::is_same_v<Shape, scene::Sphere> ? written : 0;
    visit(Shape::word, check.scene.shapes<Shape>().size() - stand_ins);
  });
  for (const auto& [word, count] : check.written) visit(word, count);
}

void write_finding(json::Writer& out, const SceneDefect& finding) {
  out.new_line().begin_object();
  if (finding.broken != nullptr)
    out.member("label", finding.broken->label).member("predicate", finding.broken->predicate);
  out.member("message", finding.message);
  if (finding.pointer) out.member("pointer", *finding.pointer);
  out.member("line", std::uint64_t{finding.place.line}).member("column", std::uint64_t{finding.place.column});
  out.end_object();
}

std::string_view rule_of(const SceneDefect& finding) {
  return finding.broken == nullptr ? malformed : finding.broken->label;
}

/// What is malformed, the invariants, and what else the findings refer to.
std::vector<SarifRule> rules_of(const SceneCheck& check) {
  std::vector<SarifRule> rules{{malformed, "The file is not as its format has it."}};
  const auto add = [&](const contract::clause& clause) {
    if (std::ranges::find(rules, clause.label, &SarifRule::id) == rules.end())
      rules.push_back({clause.label, clause.predicate});
  };
  for (const model::Judgement& judgement : model::inv(model::Escena{})) add(*judgement.what);
  for (const SceneDefect& finding : check.findings)
    if (finding.broken != nullptr) add(*finding.broken);
  if (!check.warnings.empty())
    rules.push_back({sends_on_too_much, "A surface sends on no more light than it receives."});
  return rules;
}

void write_result(json::Writer& out, std::string_view uri, const SceneDefect& finding) {
  out.new_line().begin_object().member("ruleId", rule_of(finding)).member("level", "error");
  write_sarif_message(out, "message", finding.message);
  out.key("locations").begin_array().begin_object().key("physicalLocation").begin_object();
  out.key("artifactLocation").begin_object().member("uri", uri).end_object();
  out.key("region").begin_object().member("startLine", std::uint64_t{finding.place.line});
  out.member("startColumn", std::uint64_t{finding.place.column}).end_object().end_object();
  if (finding.pointer) {
    out.key("logicalLocations").begin_array().begin_object().member("fullyQualifiedName", *finding.pointer);
    out.end_object().end_array();
  }
  out.end_object().end_array().end_object();
}

void write_warning(json::Writer& out, std::string_view uri, const Warning& warning) {
  out.new_line().begin_object().member("ruleId", sends_on_too_much).member("level", "warning");
  write_sarif_message(out, "message", warning.message);
  out.key("locations").begin_array().begin_object().key("physicalLocation").begin_object();
  out.key("artifactLocation").begin_object().member("uri", uri).end_object().end_object();
  out.key("logicalLocations").begin_array().begin_object().member("fullyQualifiedName", warning.pointer).end_object();
  out.end_array().end_object().end_array().end_object();
}

/// Judges what was read, or sets out the errors.
void judge_scene(const Source& file, SceneCheck& check) {
  if (!check.errors.empty()) {
    check.findings = findings_of(file, check.errors);
    return;
  }
  const model::Mallas state = scene::retrieve_mallas(check.scene);
  check.invariants = state.mallas.empty() ? model::inv(state.escena) : model::inv(state);
  if (!model::all_hold(check.invariants)) check.findings = broken_invariants(file, state.escena);
  const model::Judgements of_stage = stage_invariants(check.scene.stage());
  model::check(of_stage, contract::cost::normal);  // the reader has refused what would break them
  check.invariants.insert(check.invariants.end(), of_stage.begin(), of_stage.end());
  check.warnings = stage_warnings(check.scene.stage());
}

void count_bodies(SceneCheck& check) {
  check.scene.for_each([&](scene::ElementRef element, const auto&) {
    if (const scene::Body* body = check.scene.body(element)) ++check.written[std::string(scene::word_of(*body))];
  });
}

}  // namespace

SceneCheck check_scene(const Source& file) {
  SceneCheck check{.file = file.name()};
  check.scene = read_scene(file, check.errors, Bodies::read);
  count_bodies(check);
  judge_scene(file, check);
  return check;
}

SceneCheck check_scene(const Source& file, std::span<const WrittenType> types, Bodies bodies,
                       const std::function<void()>& judge) {
  SceneCheck check{.file = file.name()};
  std::vector<WrittenElement> written;
  check.scene = read_scene(file, types, written, check.errors, bodies);
  if (check.errors.empty()) {
    for (const WrittenElement& element : written) ++check.written[types[element.type].word];
    count_bodies(check);
    try {
      judge();
    } catch (const InputError& error) {
      if (!std::string_view(error.what()).starts_with(text::escaped(file.name()) + ":")) throw;
      check.errors.push_back(error);
    }
  }
  judge_scene(file, check);
  return check;
}

std::vector<SceneDefect> broken_invariants(const Source& file, const model::Escena& escena) {
  std::vector<SceneDefect> findings;
  for (const model::Elemento& e : escena.elementos) {
    for (const model::Judgement& judgement : model::inv_at(escena, e)) {
      if (judgement.holds) continue;
      const ElementPlace at = element_place(file, e.name());
      findings.push_back(
          {judgement.what, fmt::format("element {} breaks {}", e.name(), judgement.what->label), at.pointer, at.place});
    }
  }
  return findings;
}

std::string check_text(const SceneCheck& check, std::string_view fails) {
  std::string counts;
  for_each_count(check, [&](std::string_view word, std::size_t count) {
    counts += fmt::format("{}{} {}", counts.empty() ? "" : ", ", count, word);
  });
  std::string text = fmt::format("{}: {} elementos: {}\n", text::escaped(check.file), check.scene.size(), counts);
  for (const auto& [what, holds] : check.invariants)
    text += fmt::format("{} {}: {}\n", what->label, holds ? "ok" : fails, what->predicate);
  for (const Warning& warning : check.warnings) text += fmt::format("warning: {}\n", warning.message);
  return text;
}

std::string check_json(const SceneCheck& check) {
  std::string text;
  json::Writer out(text);
  write_version(out.begin_object(), check_format);
  out.member("file", text::escaped(check.file)).member("ok", check.findings.empty());
  if (check.errors.empty()) {
    out.new_line().key("elementos").begin_object();
    for_each_count(check, [&](std::string_view word, std::size_t n) { out.member(word, std::uint64_t{n}); });
    out.end_object().new_line().key("invariants").begin_array();
    for (const auto& [what, holds] : check.invariants) {
      out.new_line().begin_object().member("label", what->label).member("predicate", what->predicate);
      out.member("holds", holds).end_object();
    }
    out.end_array();
  }
  out.new_line().key("findings").begin_array();
  for (const SceneDefect& finding : check.findings) write_finding(out, finding);
  out.end_array();
  if (!check.warnings.empty()) {
    out.new_line().key("warnings").begin_array();
    for (const Warning& warning : check.warnings)
      out.new_line().begin_object().member("message", warning.message).member("pointer", warning.pointer).end_object();
    out.end_array();
  }
  out.end_object();
  return text + "\n";
}

std::string check_sarif(const SceneCheck& check) {
  std::string text;
  json::Writer out(text);
  begin_sarif(out, "durero check", rules_of(check));
  out.member("columnKind", "unicodeCodePoints").key("results").begin_array();
  const std::string uri = sarif_uri(check.file);
  for (const SceneDefect& finding : check.findings) write_result(out, uri, finding);
  for (const Warning& warning : check.warnings) write_warning(out, uri, warning);
  end_sarif(out);
  return text + "\n";
}

}  // namespace durero::io
