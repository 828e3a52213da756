#pragma once
/// Random scenes of moderate size for tests: a seeded stream in, a scene under contract out. Not of any degenerate
/// family: those are in the families of the conformance cases.
#include <glm/vec3.hpp>
#include <string>

#include "durero/conform/random.hpp"
#include "durero/contract/contract.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/scene/scene.hpp"

namespace durero::test {

/// The stream of the families, and axes.
class Random : public conform::Random {
 public:
  using conform::Random::Random;
  /// A direction whose stored components are within tolerancia_unidad of unit length.
  model::Vector axis() {
    for (;;) {
      const model::Vector d(direction());
      if (model::Unitario::contains(d)) return d;
    }
  }
};

/// A random element named `name`, of a random type, its centre in [−1, 1]³ and its lengths between 0.1 and 0.8.
inline model::Operation random_addition(Random& random, const std::string& name) {
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

inline scene::Scene random_scene(Random& random, std::size_t elements) {
  scene::Scene scene;
  for (std::size_t i = 0; i < elements; ++i) scene.apply(random_addition(random, "e" + std::to_string(i)));
  return scene;
}

/// A ray from somewhere around the scene towards somewhere in it; its direction is no unit vector.
inline model::Rayo random_ray(Random& random) {
  const glm::dvec3 from = random.in_cube(3), to = random.in_cube(1);
  return {model::Punto(from), model::Vector((to - from) * random.uniform(0.5, 2))};
}

}  // namespace durero::test
