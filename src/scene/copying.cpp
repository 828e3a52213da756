#include "durero/scene/copying.hpp"

#include "scene/body_edits.hpp"

namespace durero::scene {

Outcome apply_total(Scene& scene, const Copying& in) {
  if (scene.find(in.e)) return {model::name(model::Respuesta::elemento_ya_existe), &Agregar_Instancia_pre_1};
  const auto original = scene.find(in.de);
  if (!original) return {model::name(model::Respuesta::elemento_no_existe), &Agregar_Instancia_pre_2};
  if (!model::inv(in.mapa).front().holds) return {"mapa_singular", &model::Mapa_inv_1};
  add_body(scene, in.e, copied(in.mapa, body_of(scene, *original)), in.material);
  return {"instancia_agregada"};
}

Outcome apply_total(Scene& scene, const CopyRemoval& in) {
  return remove_body<Instance>(scene, in.e, Eliminar_Instancia_pre_1, Eliminar_Instancia_pre_2, "instancia_eliminada");
}

}  // namespace durero::scene
