#include "durero/scene/joining.hpp"

#include <algorithm>

#include "durero/scene/addition.hpp"
#include "durero/scene/edit.hpp"
#include "durero/scene/solids.hpp"

namespace durero::scene {
namespace {

Body body_of(const Scene& scene, ElementRef element) {
  if (const Body* const body = scene.body(element)) return *body;
  return scene.visit(element, [](const auto& shape) { return unmoved(shape); });
}

}  // namespace

Outcome apply_total(Scene& scene, const Joining& in) {
  if (scene.find(in.e)) return {model::name(model::Respuesta::elemento_ya_existe), &Agregar_Solido_pre_1};
  Compound solid{in.operation, {}};
  for (const std::string& name : in.de) {
    const auto part = scene.find(name);
    if (!part) return {model::name(model::Respuesta::elemento_no_existe), &Agregar_Solido_pre_2};
    solid.parts.push_back(body_of(scene, *part));
  }
  if (!std::ranges::all_of(solid.parts, bounds_a_solid)) return {"no_es_solido", &Agregar_Solido_pre_3};
  scene.apply_total(Edit{addition(model::Elemento(in.e), stand_in), in.material});
  scene.set_body(scene.find(in.e).value(), {std::move(solid)});
  return {"solido_agregado"};
}

Outcome apply_total(Scene& scene, const SolidRemoval& in) {
  const auto element = scene.find(in.e);
  if (!element) return {model::name(model::Respuesta::elemento_no_existe), &Eliminar_Solido_pre_1};
  const Body* const body = scene.body(*element);
  if (body == nullptr || !std::holds_alternative<Compound>(body->form))
    return {model::name(model::Respuesta::tipo_incorrecto), &Eliminar_Solido_pre_2};
  scene.apply_total(Edit{model::Eliminar_Elemento{model::Elemento(in.e)}});
  return {"solido_eliminado"};
}

}  // namespace durero::scene
