#pragma once
/// A disc, as the compact tables hold it.

#include "durero/scene/shape/attribute.hpp"

namespace durero::scene {

/// q·vector = 0 ∧ |q|² ≤ radio², with q = w − centro (puntos_disco): vector is its normal.
struct Disc {
  glm::dvec3 centro;
  double radio;
  glm::dvec3 vector;

  using Addition = model::Agregar_Disco;
  using Removal = model::Eliminar_Disco;
  static constexpr model::Tipo tipo = model::Tipo::soy_disco;
  static constexpr std::string_view word = "disco";
  /// Whoever looks into them names their types, which are complete in model/operaciones.hpp (scene/addition.hpp).
  template <class Addition, class Escena>
  static constexpr auto attributes =
      std::tuple{Attribute{"centro", &Disc::centro, &Addition::centro, &Escena::mi_centro},
                 Attribute{"radio", &Disc::radio, &Addition::radio, &Escena::mi_radio},
                 Attribute{"vector", &Disc::vector, &Addition::vector, &Escena::mi_vector}};
};

}  // namespace durero::scene
