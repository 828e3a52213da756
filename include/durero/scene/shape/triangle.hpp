#pragma once
/// A triangle, as the compact tables hold it.

#include "durero/scene/shape/attribute.hpp"

namespace durero::scene {

/// The points between its three vertices, edges and vertices included (puntos_triangulo).
struct Triangle {
  Corners vertices;

  using Addition = model::Agregar_Triangulo;
  using Removal = model::Eliminar_Triangulo;
  static constexpr model::Tipo tipo = model::Tipo::soy_triangulo;
  static constexpr std::string_view word = "triangulo";
  /// Whoever looks into them names their types, which are complete in model/operaciones.hpp (scene/addition.hpp).
  template <class Addition, class Escena>
  static constexpr auto attributes =
      std::tuple{Attribute{"vertices", &Triangle::vertices, &Addition::vertices, &Escena::mi_vertices}};
};

}  // namespace durero::scene
