#include "durero/scene/retrieve.hpp"

namespace durero::scene {

model::Escena retrieve(const Scene& scene) {
  model::Escena escena;
  scene.for_each([&]<class Shape>(ElementRef element, const Shape& shape) {
    const model::Elemento& e = scene.name(element);
    escena.elementos.insert(e);
    escena.tipos.insert(Shape::tipo);
    escena.de_que_tipo.emplace(e, Shape::tipo);
    for_each_attribute<Shape>(
        [&](const auto& attribute) { (escena.*attribute.component).emplace(e, shape.*attribute.field); });
  });
  return escena;
}

}  // namespace durero::scene
