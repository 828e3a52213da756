#pragma once
/// A truncated cone without base and top, as the compact tables hold it.

#include "durero/scene/shape/attribute.hpp"

namespace durero::scene {

/// |q − s·vector|² − (radio + proporcion·(altura − s))² = 0 ∧ 0 ≤ s ≤ altura (puntos_tronco): the top, of radius radio,
/// at altura; the base, which is wider, at centro.
struct TruncatedCone {
  glm::dvec3 centro;
  double radio;
  double proporcion;
  glm::dvec3 vector;
  double altura;

  using Addition = model::Agregar_Tronco;
  using Removal = model::Eliminar_Tronco;
  static constexpr model::Tipo tipo = model::Tipo::soy_tronco;
  static constexpr std::string_view word = "tronco";
  /// Whoever looks into them names their types, which are complete in model/operaciones.hpp (scene/addition.hpp).
  template <class Addition, class Escena>
  static constexpr auto attributes =
      std::tuple{Attribute{"centro", &TruncatedCone::centro, &Addition::centro, &Escena::mi_centro},
                 Attribute{"radio", &TruncatedCone::radio, &Addition::radio, &Escena::mi_radio},
                 Attribute{"proporcion", &TruncatedCone::proporcion, &Addition::proporcion, &Escena::mi_proporcion},
                 Attribute{"vector", &TruncatedCone::vector, &Addition::vector, &Escena::mi_vector},
                 Attribute{"altura", &TruncatedCone::altura, &Addition::altura, &Escena::mi_altura}};
};

}  // namespace durero::scene
