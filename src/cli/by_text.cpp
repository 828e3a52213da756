#include "by_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <variant>

#include "durero/io/json/scene_file.hpp"
#include "durero/io/pov/algebraic.hpp"
#include "durero/model/malla.hpp"
#include "durero/model/operaciones_clauses.hpp"
#include "durero/model/vista.hpp"
#include "durero/scene/retrieve.hpp"
#include "durero/spec/calculator.hpp"
#include "durero/spec/spec.hpp"
#include "durero/written/edited.hpp"

namespace durero::cli {
namespace {

/// Checks that the samples can judge the scene: they know the program's shapes, and no types of a text.
void require_samples(const io::Source& scene, const written::Text& text, const io::WrittenByName& elements) {
  if (elements.empty()) return;
  const auto& [name, element] = *elements.begin();
  const std::string& type = text.types()[element.type].word;
  throw io::InputError(scene.name(), io::element_place(scene, name).place,
                       fmt::format("{} is of the type {}", name, type),
                       "expected one that the program has samples of: no text says where points of a surface are");
}

const auto& of_text(const scene::Edit& edit) { return edit.operation; }
const auto& of_text(const auto& change) { return change; }

/// @{ The state that an edit speaks of.
model::Escena state_of(const scene::GroupedScene& of, const auto&) { return scene::retrieve(of.scene); }
model::Vista state_of(const scene::GroupedScene& of, const model::LookChange&) { return retrieve_looks(of); }
/// @}

/// The text on what the contracts answered: of a face alone, which they refuse, whether it is one.
template <class State, class OfText>
std::optional<std::string> difference(const spec::Judge& judge, const State& before, const OfText& edit,
                                      const model::Answer& answer, const scene::GroupedScene& after) {
  if (answer.r == model::Respuesta::es_de_malla) {
    const model::Elemento e = std::visit([](const auto& in) { return in.e; }, edit);
    if (spec::in_de_malla(e, scene::retrieve_mallas(after.scene))) return std::nullopt;
    return "the contracts refuse " + e.name() + " as a face, and the text knows it as none";
  }
  if constexpr (std::is_same_v<OfText, model::Operation>)
    return judge.difference(before, edit, answer, state_of(after, edit));
  else
    return judge.change_difference(before, edit, answer, state_of(after, edit));
}

io::EditAnswer carry_out(io::EditedScene& edited, const io::ScriptStep& step, const spec::Judge& judge) {
  const auto judged = [&](const auto& edit) {
    const auto before = state_of(edited.of(), edit);
    const auto [answer, told] = edited.apply_own(edit);
    if (const auto found = difference(judge, before, of_text(edit), answer, edited.of()))
      throw std::logic_error(fmt::format(
          "a defect of the program: at line {}, {}; expected that contracts and text agree", step.line, *found));
    return told;
  };
  if (const auto* const edit = std::get_if<scene::Edit>(&step.edit)) return judged(*edit);
  if (const auto* const change = std::get_if<model::AttributeChange>(&step.edit)) return judged(*change);
  if (const auto* const change = std::get_if<model::LookChange>(&step.edit)) return judged(*change);
  return edited.apply_total(step);
}

}  // namespace

written::Written read_by_text(const io::Source& scene, const std::string& text) {
  return written::read(scene, written::Text(text));
}

written::Written read_shapes_by_text(const io::Source& scene, const std::string& text) {
  const written::Text read_text(text);
  written::Written read = written::read(scene, read_text);
  require_samples(scene, read_text, read.elements);
  return read;
}

void require_surfaces(const std::string& scene, const std::string& text, const io::WrittenByName& surfaces) {
  const written::Text read(text);
  for (const auto& [name, element] : surfaces) {
    const io::WrittenType& type = io::algebraic_types()[element.type];
    const auto declared = std::ranges::find(read.types(), type);
    if (declared == read.types().end())
      throw std::invalid_argument(
          fmt::format("{} declares no {} as POV-Ray's surfaces need it; expected a text such as "
                      "demo/surfaces/algebraic.tex",
                      text, type.word));
    try {
      read.surface(type.word, element.values);
    } catch (const written::NotInDomain& refused) {
      throw std::invalid_argument(fmt::format("{}: {} is not in the domain of puntos_{}; expected {}", scene, name,
                                              refused.type, refused.expected));
    }
  }
}

io::SceneCheck check_by_text(const io::Source& scene, const std::string& text) {
  const written::Text read_text(text);
  return io::check_scene(scene, read_text.types(), written::bodies_beside(read_text),
                         [&] { written::read(scene, read_text); });
}

std::unique_ptr<io::EditedScene> edited_by_text(const io::Source& scene, const std::string& text) {
  return std::make_unique<written::Edited>(scene, std::make_shared<const written::Text>(text));
}

Editor editor_by_spec() {
  return [judge = std::make_shared<const spec::Judge>()](io::EditedScene& edited, const io::ScriptStep& step) {
    return carry_out(edited, step, *judge);
  };
}

ClauseFinder clauses_by_spec() {
  return [judge = std::make_shared<const spec::Judge>()](const io::EditedScene& edited, const io::ScriptStep& step) {
    io::WhyNot told = io::why_not(edited, step);
    const model::Escena before = scene::retrieve(edited.of().scene);
    std::optional<std::string> difference;
    if (const auto* const edit = std::get_if<scene::Edit>(&step.edit))
      difference = judge->difference(before, edit->operation, model::pre(before, edit->operation));
    else if (const auto* const change = std::get_if<model::AttributeChange>(&step.edit))
      difference = judge->change_difference(before, *change, model::pre(before, *change));
    if (!difference) return told;
    throw std::logic_error(
        fmt::format("a defect of the program: {}; expected that contracts and text agree", *difference));
  };
}

std::vector<std::string> elements_of_set(const scene::Scene& scene, const std::string& set) {
  constexpr const char* file = "--for-each";
  const spec::Calculator text(scene::retrieve(scene));
  zed::Steps unbounded;
  try {
    return text.names(set, unbounded);
  } catch (const zed::ZError& error) {
    throw io::InputError(file, {error.place.line, error.place.column}, error.what_is_wrong, error.expected);
  } catch (const zed::EvaluationError& error) {
    throw io::InputError(file, {1, 1}, std::string("this is not decided: ") + error.what(),
                         "expected a finite set of elements");
  }
}

}  // namespace durero::cli
