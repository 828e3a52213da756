#include "support/scenes.hpp"

#include "durero/contract/contract.hpp"
#include "durero/model/operaciones.hpp"

namespace durero::test {

model::Operation random_addition(Random& random, const std::string& name) {
  const model::Elemento e(name);
  const model::Punto centro(random.in_cube(1));
  switch (static_cast<model::Tipo>(random.below(scene::shape_count))) {
    case model::Tipo::soy_esfera:
      return model::Agregar_Esfera{e, centro, random.uniform(0.1, 0.8)};
    case model::Tipo::soy_cilindro:
      return model::Agregar_Cilindro{e, centro, random.uniform(0.1, 0.5), random.axis(), random.uniform(0.3, 1.2)};
    case model::Tipo::soy_cono:
      return model::Agregar_Cono{e, centro, random.uniform(0.2, 1.5), random.axis(), random.uniform(0.3, 0.8)};
    case model::Tipo::soy_tronco: {
      const double radio = random.uniform(0.1, 0.4), proporcion = random.uniform(0.1, 0.8);
      return model::Agregar_Tronco{e, centro, radio, proporcion, random.axis(), random.uniform(0.3, 0.8)};
    }
    case model::Tipo::soy_plano:
      return model::Agregar_Plano{e, centro, random.axis()};
    case model::Tipo::soy_disco: {
      const double radio = random.uniform(0.1, 0.8);
      return model::Agregar_Disco{e, centro, radio, random.axis()};
    }
    case model::Tipo::soy_triangulo: {
      const model::Punto b(centro.xyz() + random.in_cube(0.8)), c(centro.xyz() + random.in_cube(0.8));
      return model::Agregar_Triangulo{e, {centro, b, c}};
    }
  }
  contract::unreachable();
}

scene::Scene random_scene(Random& random, std::size_t elements) {
  scene::Scene scene;
  for (std::size_t i = 0; i < elements; ++i) scene.apply(random_addition(random, "e" + std::to_string(i)));
  return scene;
}

}  // namespace durero::test
