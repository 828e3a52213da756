#include "durero/scene/joining.hpp"

#include <algorithm>

#include "scene/body_edits.hpp"

namespace durero::scene {

Outcome apply_total(Scene& scene, const Joining& in) {
  if (scene.find(in.e)) return {model::name(model::Respuesta::elemento_ya_existe), &Agregar_Solido_pre_1};
  Compound solid{in.operation, {}};
  for (const std::string& name : in.de) {
    const auto part = scene.find(name);
    if (!part) return {model::name(model::Respuesta::elemento_no_existe), &Agregar_Solido_pre_2};
    solid.parts.push_back(body_of(scene, *part));
  }
  if (!std::ranges::all_of(solid.parts, bounds_a_solid)) return {"no_es_solido", &Agregar_Solido_pre_3};
  add_body(scene, in.e, {std::move(solid)}, in.material);
  return {"solido_agregado"};
}

Outcome apply_total(Scene& scene, const SolidRemoval& in) {
  return remove_body<Compound>(scene, in.e, Eliminar_Solido_pre_1, Eliminar_Solido_pre_2, "solido_eliminado");
}

}  // namespace durero::scene
