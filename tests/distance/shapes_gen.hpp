#pragma once
/// Random shapes of every type, with axes that are unit vectors and axes that are not quite.

#include <type_traits>

#include "durero/scene/shapes.hpp"
#include "support/model_gen.hpp"

namespace durero::test {

/// A shape of that type.
template <class Shape>
Shape any_shape() {
  Shape shape{};
  if constexpr (requires { shape.vertices; }) {
    do
      for (glm::dvec3& vertex : shape.vertices) vertex = (*any_point()).xyz();
    while (!model::Vertices::contains(model::Terna{model::Punto(shape.vertices[0]), model::Punto(shape.vertices[1]),
                                                   model::Punto(shape.vertices[2])}));
  } else {
    shape.centro = (*any_point()).xyz();
    if constexpr (requires { shape.radio; }) shape.radio = *any_length();
    if constexpr (requires { shape.proporcion; }) shape.proporcion = *any_length() / 4;
    if constexpr (requires { shape.vector; }) shape.vector = (*any_axis()).xyz();
    if constexpr (requires { shape.altura; }) shape.altura = *any_length();
  }
  return shape;
}

}  // namespace durero::test
