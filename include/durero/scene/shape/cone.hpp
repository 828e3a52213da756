#pragma once
/// A cone without base, as the compact tables hold it.

#include "durero/scene/shape/attribute.hpp"

namespace durero::scene {

/// |q − s·vector|² − (proporcion·(altura − s))² = 0 ∧ 0 ≤ s ≤ altura (puntos_cono): base at centro, apex at altura.
struct Cone {
  glm::dvec3 centro;
  double proporcion;
  glm::dvec3 vector;
  double altura;

  using Addition = model::Agregar_Cono;
  using Removal = model::Eliminar_Cono;
  static constexpr model::Tipo tipo = model::Tipo::soy_cono;
  static constexpr std::string_view word = "cono";
  /// Whoever looks into them names their types, which are complete in model/operaciones.hpp (scene/addition.hpp).
  template <class Addition, class Escena>
  static constexpr auto attributes =
      std::tuple{Attribute{"centro", &Cone::centro, &Addition::centro, &Escena::mi_centro},
                 Attribute{"proporcion", &Cone::proporcion, &Addition::proporcion, &Escena::mi_proporcion},
                 Attribute{"vector", &Cone::vector, &Addition::vector, &Escena::mi_vector},
                 Attribute{"altura", &Cone::altura, &Addition::altura, &Escena::mi_altura}};
};

}  // namespace durero::scene
