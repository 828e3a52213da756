#include "by_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <variant>

#include "durero/io/json/scene_file.hpp"
#include "durero/io/pov/algebraic.hpp"
#include "durero/scene/retrieve.hpp"
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

io::EditAnswer carry_out(io::EditedScene& edited, const io::ScriptStep& step, const spec::Judge& judge) {
  const auto* const edit = std::get_if<scene::Edit>(&step.edit);
  if (edit == nullptr) return edited.apply_total(step);
  const model::Escena before = scene::retrieve(edited.of().scene);
  const auto [answer, told] = edited.apply_own(*edit);
  const auto difference = judge.difference(before, edit->operation, answer, scene::retrieve(edited.of().scene));
  if (!difference) return told;
  throw std::logic_error(fmt::format("a defect of the program: at line {}, {}; expected that contracts and text agree",
                                     step.line, *difference));
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

}  // namespace durero::cli
