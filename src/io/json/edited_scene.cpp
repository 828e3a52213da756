#include "durero/io/json/edited_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "durero/contract/contract.hpp"
#include "durero/io/json/edit_history.hpp"
#include "durero/io/json/groups_file.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/scene/copying.hpp"
#include "durero/text/shown.hpp"
#include "texture_fields.hpp"

namespace durero::io {
namespace {

/// @{ The element that an edit concerns; null where it concerns none.
const std::string* element_of(const scene::Edit& edit) { return &scene::name_of(edit.operation).name(); }
const std::string* element_of(const WrittenEdit& edit) {
  const auto* const in = std::get_if<WrittenAddition>(&edit);
  return in == nullptr ? &std::get<WrittenRemoval>(edit).e : &in->element.id;
}
const std::string* element_of(const scene::Copying& edit) { return &edit.e; }
const std::string* element_of(const scene::CopyRemoval& edit) { return &edit.e; }
const std::string* element_of(const scene::Joining& edit) { return &edit.e; }
const std::string* element_of(const scene::SolidRemoval& edit) { return &edit.e; }
const std::string* element_of(const model::AttributeChange&) { return nullptr; }
const std::string* element_of(const model::LookChange&) { return nullptr; }
const std::string* element_of(const scene::GroupEdit&) { return nullptr; }
const std::string* element_of(const scene::Closing&) { return nullptr; }
const std::string* element_of(const scene::MeshEdit&) { return nullptr; }
/// @}

}  // namespace

scene::Edit removal_of(const std::string& name) { return {model::Eliminar_Elemento{model::Elemento{name}}, {}}; }

model::Answer EditedScene::own_answer(const scene::Edit& edit) {
  if (std::holds_alternative<model::Eliminar_Esfera>(edit.operation)) {
    const auto element = of_.scene.find(scene::name_of(edit.operation).name());
    if (element && of_.scene.body(*element) != nullptr)
      return {model::Respuesta::tipo_incorrecto, &model::Eliminar_Esfera_pre_1};
  }
  return of_.apply_total(edit);
}

EditAnswer EditedScene::apply_total(const scene::Copying& edit) {
  return edit_answer(scene::apply_total(of_.scene, edit));
}

EditAnswer EditedScene::apply_total(const scene::CopyRemoval& edit) {
  const scene::Outcome outcome = scene::apply_total(of_.scene, edit);
  if (outcome.ok()) of_.groups.follow(model::Eliminar_Elemento{model::Elemento(edit.e)});
  return edit_answer(outcome);
}

EditAnswer EditedScene::apply_total(const scene::Joining& edit) {
  return edit_answer(scene::apply_total(of_.scene, edit));
}

EditAnswer EditedScene::apply_total(const scene::SolidRemoval& edit) {
  const scene::Outcome outcome = scene::apply_total(of_.scene, edit);
  if (outcome.ok()) of_.groups.follow(model::Eliminar_Elemento{model::Elemento(edit.e)});
  return edit_answer(outcome);
}

EditAnswer EditedScene::apply_total(scene::MeshEdit edit) { return edit_answer(of_.apply_total(std::move(edit))); }

EditAnswer EditedScene::apply_total(const model::AttributeChange& change) {
  return edit_answer(of_.change_total(change));
}

EditAnswer EditedScene::apply_total(const model::LookChange& change) { return apply_own(change).second; }

void EditedScene::require_coordinates(const model::Cambiar_Material& in) const {
  const auto& materials = of_.scene.stage().materials;
  const auto material = std::ranges::find(materials, in.material, &scene::Material::name);
  const auto element = of_.scene.find(in.e.name());
  if (material == materials.end() || !has_textures(*material) || !element) return;
  if (of_.scene.body(*element) != nullptr || stands_in(in.e.name()))
    throw std::domain_error(
        fmt::format("{} has no coordinates (u, v), and material {} has textures; expected one without", in.e.name(),
                    text::shown(in.material)));
}

EditAnswer EditedScene::apply_total(const WrittenEdit&) { contract::unreachable(); }

EditAnswer EditedScene::apply_total(const ScriptStep& step) {
  return std::visit(
      [&](const auto& edit) {
        const std::string* const name = element_of(edit);
        if (name == nullptr) return apply_total(edit);
        std::string was_in(of_.groups.of_element(*name));
        EditAnswer answer = apply_total(edit);
        if (answer.ok()) answer.left_group = left_group(*name, std::move(was_in));
        return answer;
      },
      step.edit);
}

std::pair<model::Answer, EditAnswer> EditedScene::apply_own(const scene::Edit& edit) {
  const std::string& name = *element_of(edit);
  std::string was_in(of_.groups.of_element(name));
  const model::Answer answer = own_answer(edit);
  std::pair told(answer, edit_answer(answer));
  if (answer.ok()) told.second.left_group = left_group(name, std::move(was_in));
  return told;
}

std::pair<model::Answer, EditAnswer> EditedScene::apply_own(const model::AttributeChange& change) {
  const model::Answer answer = of_.change_total(change);
  return {answer, edit_answer(answer)};
}

std::pair<model::Answer, EditAnswer> EditedScene::apply_own(const model::LookChange& change) {
  if (const auto* const in = std::get_if<model::Cambiar_Material>(&change)) require_coordinates(*in);
  const model::Answer answer = of_.change_looks(change);
  return {answer, edit_answer(answer)};
}

std::string EditedScene::left_group(const std::string& name, std::string was_in) {
  if (!of_.scene.find(name)) {
    if (!was_in.empty()) left_.insert_or_assign(name, was_in);
    return was_in;
  }
  const auto left = left_.extract(name);
  return left.empty() || !of_.groups.table().contains(left.mapped()) ? "" : left.mapped();
}

EditAnswer EditedScene::apply_total(const scene::Closing& in) {
  const scene::Lids lids = scene::lids(of_.scene, in);
  if (lids.violated != nullptr) return edit_answer(scene::Outcome{"not_closed", lids.violated});
  std::size_t added = 0;
  const auto undo = [&] {
    while (added > 0) of_.apply_total(removal_of(scene::name_of(lids.additions[--added].operation).name()));
  };
  try {
    for (const scene::Edit& lid : lids.additions) {
      EditAnswer answer = apply_total(lid);
      if (!answer.ok()) {
        undo();
        return answer;
      }
      ++added;
    }
  } catch (...) {
    undo();
    throw;
  }
  return {lids.exact ? "closed" : "closed_but_for_rounding"};
}

void EditedScene::restore(const EditRecord& record) {
  for (const scene::ElementRecord& element : record.elements) scene::restore(of_, element);
  for (const auto& [name, element] : record.written) set_written(name, element);
  if (record.mesh) scene::restore(of_, *record.mesh);
  if (record.groups) of_.groups = *record.groups;
}

std::string EditedScene::scene_text() const { return io::scene_text(of_.scene, of_.groups); }

}  // namespace durero::io
