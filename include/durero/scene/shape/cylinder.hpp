#pragma once
/// A cylinder without caps, as the compact tables hold it.

#include "durero/scene/shape/attribute.hpp"

namespace durero::scene {

/// |q − s·vector|² − radio² = 0 ∧ 0 ≤ s ≤ altura, with s = q·vector (puntos_cilindro).
struct Cylinder {
  glm::dvec3 centro;
  double radio;
  glm::dvec3 vector;
  double altura;

  using Addition = model::Agregar_Cilindro;
  using Removal = model::Eliminar_Cilindro;
  static constexpr model::Tipo tipo = model::Tipo::soy_cilindro;
  static constexpr std::string_view word = "cilindro";
  /// Whoever looks into them names their types, which are complete in model/operaciones.hpp (scene/addition.hpp).
  template <class Addition, class Escena>
  static constexpr auto attributes =
      std::tuple{Attribute{"centro", &Cylinder::centro, &Addition::centro, &Escena::mi_centro},
                 Attribute{"radio", &Cylinder::radio, &Addition::radio, &Escena::mi_radio},
                 Attribute{"vector", &Cylinder::vector, &Addition::vector, &Escena::mi_vector},
                 Attribute{"altura", &Cylinder::altura, &Addition::altura, &Escena::mi_altura}};
};

}  // namespace durero::scene
