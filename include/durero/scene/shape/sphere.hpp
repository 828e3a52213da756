#pragma once
/// A sphere, as the compact tables hold it.

#include "durero/scene/shape/attribute.hpp"

namespace durero::scene {

/// |q|² − radio² = 0, with q = w − centro (puntos_esfera).
struct Sphere {
  glm::dvec3 centro;
  double radio;

  using Addition = model::Agregar_Esfera;
  using Removal = model::Eliminar_Esfera;
  static constexpr model::Tipo tipo = model::Tipo::soy_esfera;
  static constexpr std::string_view word = "esfera";
  /// Whoever looks into them names their types, which are complete in model/operaciones.hpp (scene/addition.hpp).
  template <class Addition, class Escena>
  static constexpr auto attributes =
      std::tuple{Attribute{"centro", &Sphere::centro, &Addition::centro, &Escena::mi_centro},
                 Attribute{"radio", &Sphere::radio, &Addition::radio, &Escena::mi_radio}};
};

}  // namespace durero::scene
