#include "durero/scene/retrieve.hpp"

namespace durero::scene {
namespace {

/// The components that every element has.
void put(model::Escena& escena, const model::Elemento& e, model::Tipo t, const glm::dvec3& centro) {
  escena.elementos.insert(e);
  escena.tipos.insert(t);
  escena.de_que_tipo.emplace(e, t);
  escena.mi_centro.emplace(e, centro);
}

}  // namespace

model::Escena retrieve(const Scene& scene) {
  model::Escena escena;
  const auto name = [&](model::Tipo t, std::size_t i) -> const model::Elemento& {
    return scene.name({t, static_cast<std::uint32_t>(i)});
  };
  for (std::size_t i = 0; i < scene.spheres().size(); ++i) {
    const Sphere& sphere = scene.spheres()[i];
    const model::Elemento& e = name(model::Tipo::soy_esfera, i);
    put(escena, e, model::Tipo::soy_esfera, sphere.centro);
    escena.mi_radio.emplace(e, sphere.radio);
  }
  for (std::size_t i = 0; i < scene.cylinders().size(); ++i) {
    const Cylinder& cylinder = scene.cylinders()[i];
    const model::Elemento& e = name(model::Tipo::soy_cilindro, i);
    put(escena, e, model::Tipo::soy_cilindro, cylinder.centro);
    escena.mi_radio.emplace(e, cylinder.radio);
    escena.mi_vector.emplace(e, cylinder.vector);
    escena.mi_altura.emplace(e, cylinder.altura);
  }
  for (std::size_t i = 0; i < scene.cones().size(); ++i) {
    const Cone& cone = scene.cones()[i];
    const model::Elemento& e = name(model::Tipo::soy_cono, i);
    put(escena, e, model::Tipo::soy_cono, cone.centro);
    escena.mi_proporcion.emplace(e, cone.proporcion);
    escena.mi_vector.emplace(e, cone.vector);
    escena.mi_altura.emplace(e, cone.altura);
  }
  return escena;
}

}  // namespace durero::scene
