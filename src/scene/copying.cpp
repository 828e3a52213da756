#include "durero/scene/copying.hpp"

#include "durero/scene/addition.hpp"
#include "durero/scene/body.hpp"
#include "durero/scene/edit.hpp"

namespace durero::scene {
namespace {

Body copy_of(const Scene& scene, ElementRef original, const model::Mapa& mapa) {
  if (const Body* const body = scene.body(original)) return copied(mapa, *body);
  return scene.visit(original, [&](const auto& shape) { return Body{Instance{shape, mapa}}; });
}

}  // namespace

Outcome apply_total(Scene& scene, const Copying& in) {
  if (scene.find(in.e)) return {model::name(model::Respuesta::elemento_ya_existe), &Agregar_Instancia_pre_1};
  const auto original = scene.find(in.de);
  if (!original) return {model::name(model::Respuesta::elemento_no_existe), &Agregar_Instancia_pre_2};
  if (!model::inv(in.mapa).front().holds) return {"mapa_singular", &model::Mapa_inv_1};
  Body body = copy_of(scene, *original, in.mapa);
  const model::Elemento name(in.e);
  scene.apply_total(Edit{addition(name, stand_in), in.material});
  scene.set_body(scene.find(in.e).value(), std::move(body));
  return {"instancia_agregada"};
}

Outcome apply_total(Scene& scene, const CopyRemoval& in) {
  const auto element = scene.find(in.e);
  if (!element) return {model::name(model::Respuesta::elemento_no_existe), &Eliminar_Instancia_pre_1};
  const Body* const body = scene.body(*element);
  if (body == nullptr || !std::holds_alternative<Instance>(body->form))
    return {model::name(model::Respuesta::tipo_incorrecto), &Eliminar_Instancia_pre_2};
  scene.apply_total(Edit{model::Eliminar_Elemento{model::Elemento(in.e)}});
  return {"instancia_eliminada"};
}

}  // namespace durero::scene
