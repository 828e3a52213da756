#include "durero/scene/grouped_scene.hpp"

#include <algorithm>
#include <utility>

#include "durero/model/malla_clauses.hpp"
#include "durero/model/vista.hpp"
#include "durero/scene/edit.hpp"
#include "durero/scene/retrieve.hpp"
#include "durero/scene/stage.hpp"

namespace durero::scene {
namespace {

using model::Answer;
using model::Respuesta;

/// What a look is changed of, and the answers. Precondition of the operators: the element exists.
struct LookEditor {
  GroupedScene& of;
  ElementRef element;

  Answer operator()(const model::Cambiar_Material& in) const {
    const auto& materials = of.scene.stage().materials;
    const auto found = std::ranges::find(materials, in.material, &Material::name);
    if (found == materials.end()) return {Respuesta::material_no_existe, &model::Cambiar_Material_pre_2};
    of.scene.set_material(element, static_cast<std::uint32_t>(found - materials.begin()));
    return done;
  }
  Answer operator()(const model::Quitar_Material&) const {
    of.scene.set_material(element, std::nullopt);
    return done;
  }
  Answer operator()(const model::Cambiar_Grupo& in) const {
    if (!of.groups.table().contains(in.g)) return {Respuesta::grupo_no_existe, &model::Cambiar_Grupo_pre_2};
    of.groups.put(in.e.name(), in.g);
    return done;
  }
  Answer operator()(const model::Quitar_Grupo& in) const {
    of.groups.take_out(in.e.name());
    return done;
  }

  static constexpr Answer done{Respuesta::elemento_cambiado};
};

/// The clause that the element exists, and whether the material is changed.
struct LookClauses {
  const contract::clause* exists;
  bool is_of_material;
};
LookClauses clauses_of(const model::Cambiar_Material&) { return {&model::Cambiar_Material_pre_1, true}; }
LookClauses clauses_of(const model::Quitar_Material&) { return {&model::Quitar_Material_pre_1, true}; }
LookClauses clauses_of(const model::Cambiar_Grupo&) { return {&model::Cambiar_Grupo_pre_1, false}; }
LookClauses clauses_of(const model::Quitar_Grupo&) { return {&model::Quitar_Grupo_pre_1, false}; }

}  // namespace

Answer GroupedScene::apply_total(const Edit& edit) {
  const Answer answer = scene.apply_total(edit);
  if (answer.ok()) groups.follow(edit.operation);
  return answer;
}

Answer GroupedScene::apply_total(MeshEdit edit) {
  const Answer answer = scene.apply_total(std::move(edit));
  if (answer.ok()) groups.follow_meshes(scene);
  return answer;
}

Answer GroupedScene::change_total(const model::AttributeChange& change) { return scene.change_total(change); }

Answer GroupedScene::change_looks(const model::LookChange& change) {
  const auto labels = std::visit([](const auto& in) { return clauses_of(in); }, change);
  const auto element = scene.find(model::name_of(change).name());
  if (!element) return {Respuesta::elemento_no_existe, labels.exists};
  if (labels.is_of_material && scene.face(*element)) return {Respuesta::es_de_malla, &model::Fuera_De_Malla_pre_1};
  return std::visit(LookEditor{*this, *element}, change);
}

model::Vista retrieve_looks(const GroupedScene& of) {
  const auto& materials = of.scene.stage().materials;
  model::Vista looks{retrieve(of.scene), {}, {}, {}, {}};
  for (const auto& [name, group] : of.groups.table()) looks.grupos.insert(name);
  for (const Material& material : materials) looks.materiales.insert(material.name);
  for (const model::Elemento& e : looks.escena.elementos) {
    if (const auto g = of.groups.of_element(e.name()); !g.empty()) looks.mi_grupo.emplace(e, g);
    if (const auto material = of.scene.material(of.scene.find(e.name()).value()))
      looks.mi_material.emplace(e, materials[*material].name);
  }
  return looks;
}

}  // namespace durero::scene
