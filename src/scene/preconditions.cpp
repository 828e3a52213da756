#include "durero/scene/preconditions.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <variant>

#include "durero/model/malla_clauses.hpp"
#include "durero/model/operaciones_clauses.hpp"
#include "durero/scene/retrieve.hpp"
#include "scene/body_edits.hpp"

namespace durero::scene {
namespace {

using model::Judgements;

Judgements before_grouping(const GroupedScene& of, const Grouping& in) {
  const auto is_element = [&](const std::string& name) { return of.scene.find(name).has_value(); };
  const auto is_group = [&](const std::string& name) { return of.groups.table().contains(name); };
  const auto is_element_apart = [&](const std::string& name) { return of.groups.of_element(name).empty(); };
  const auto is_group_apart = [&](const std::string& name) { return of.groups.of_group(name).empty(); };
  return {{&group_pre_1, !is_group(in.g)},
          {&group_pre_2, std::ranges::all_of(in.of.elementos, is_element)},
          {&group_pre_3, std::ranges::all_of(in.of.groups, is_group)},
          {&group_pre_4, std::ranges::all_of(in.of.elementos, is_element_apart)},
          {&group_pre_5, std::ranges::all_of(in.of.groups, is_group_apart)}};
}

/// Whether an element has a body of that form, one of Body::form.
template <class Form>
bool has_form(const Scene& scene, const std::string& name) {
  const auto element = scene.find(name);
  const Body* const body = element ? scene.body(*element) : nullptr;
  return body != nullptr && std::holds_alternative<Form>(body->form);
}

/// @{ The same edit of the text, by its state before.
model::MeshOperation operation_of_text(const MeshAddition& in) {
  return model::Agregar_Malla{in.mesh.m, red_of(in.mesh)};
}
model::MeshOperation operation_of_text(const MeshRemoval& in) { return model::Eliminar_Malla{in.m}; }
model::MeshOperation operation_of_text(const MeshReplacement& in) {
  return model::Reemplazar_Malla{in.mesh.m, red_of(in.mesh)};
}
model::MeshOperation operation_of_text(const VertexMove& in) { return model::Mover_Vertice{in.m, in.n, in.punto}; }
/// @}

}  // namespace

Judgements pre(const GroupedScene& before, const GroupEdit& in) {
  if (const auto* const grouping = std::get_if<Grouping>(&in)) return before_grouping(before, *grouping);
  return {{&ungroup_pre_1, before.groups.table().contains(std::get<Ungrouping>(in).g)}};
}

Judgements pre(const GroupedScene& before, const Copying& in) {
  return {{&Agregar_Instancia_pre_1, !before.scene.find(in.e)},
          {&Agregar_Instancia_pre_2, before.scene.find(in.de).has_value()},
          model::inv(in.mapa).front()};
}

Judgements pre(const GroupedScene& before, const CopyRemoval& in) {
  return {{&Eliminar_Instancia_pre_1, before.scene.find(in.e).has_value()},
          {&Eliminar_Instancia_pre_2, has_form<Instance>(before.scene, in.e)}};
}

Judgements pre(const GroupedScene& before, const Joining& in) {
  const Scene& scene = before.scene;
  const auto is_element = [&](const std::string& name) { return scene.find(name).has_value(); };
  const auto is_no_surface = [&](const std::string& name) {  // what is not there is none
    const auto part = scene.find(name);
    return !part || bounds_a_solid(body_of(scene, *part));
  };
  return {{&Agregar_Solido_pre_1, !scene.find(in.e)},
          {&Agregar_Solido_pre_2, std::ranges::all_of(in.de, is_element)},
          {&Agregar_Solido_pre_3, std::ranges::all_of(in.de, is_no_surface)}};
}

Judgements pre(const GroupedScene& before, const SolidRemoval& in) {
  return {{&Eliminar_Solido_pre_1, before.scene.find(in.e).has_value()},
          {&Eliminar_Solido_pre_2, has_form<Compound>(before.scene, in.e)}};
}

Judgements pre(const GroupedScene& before, const Closing& in) {
  const Scene& scene = before.scene;
  Closing apart = in;  // with two names, so that pre.4 is asked whatever pre.3 is
  if (in.base == in.top) apart.top = std::string(1, in.base == "a" ? 'b' : 'a');
  const Lids lids = scene::lids(scene, apart);
  const bool exists = scene.find(in.e).has_value();
  const bool has_no_top = lids.additions.size() == 1;  // the name of one is not looked at
  Judgements all{{&close_pre_1, exists},
                 {&close_pre_2, exists && lids.violated != &close_pre_2},
                 {&close_pre_3, in.base != in.top || has_no_top},
                 {&close_pre_4, exists && lids.violated == nullptr}};
  if (!model::all_hold(all)) return all;
  const model::Escena escena = retrieve(scene);
  for (const Edit& lid : lids.additions) std::ranges::copy(model::pre(escena, lid.operation), std::back_inserter(all));
  return all;
}

Judgements pre(const GroupedScene& before, const MeshEdit& in) {
  const model::MeshOperation operation = std::visit([](const auto& edit) { return operation_of_text(edit); }, in);
  Judgements all;
  for (const model::MeshPrecondition& asked : model::preconditions(retrieve_mallas(before.scene), operation))
    all.push_back(asked.judged);
  return all;
}

}  // namespace durero::scene
