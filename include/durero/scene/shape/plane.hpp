#pragma once
/// A plane, as the compact tables hold it.

#include "durero/scene/shape/attribute.hpp"

namespace durero::scene {

/// q·vector = 0, with q = w − centro (puntos_plano): centro is any point of it, vector its normal.
struct Plane {
  glm::dvec3 centro;
  glm::dvec3 vector;

  using Addition = model::Agregar_Plano;
  using Removal = model::Eliminar_Plano;
  static constexpr model::Tipo tipo = model::Tipo::soy_plano;
  static constexpr std::string_view word = "plano";
  /// Whoever looks into them names their types, which are complete in model/operaciones.hpp (scene/addition.hpp).
  template <class Addition, class Escena>
  static constexpr auto attributes =
      std::tuple{Attribute{"centro", &Plane::centro, &Addition::centro, &Escena::mi_centro},
                 Attribute{"vector", &Plane::vector, &Addition::vector, &Escena::mi_vector}};
};

}  // namespace durero::scene
