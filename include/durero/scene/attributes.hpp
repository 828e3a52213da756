#pragma once
/// The attributes of the shapes: what a table stores of the inputs of an addition, and walks over the rows of a shape.
/// The additions themselves stand in scene/addition.hpp, and scenes of the specification in model/escena.hpp: whoever
/// walks words and fields alone is not compiled again when these change.

#include <cstddef>
#include <map>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "durero/scene/shapes.hpp"

namespace durero::scene {

/// An input of each name that some addition has: it stands where a table of attributes asks for an addition, and the
/// inputs are not looked at.
struct AnyInputs {
  model::Punto centro;    ///< centro?
  double radio;           ///< radio?
  model::Vector vector;   ///< vector?
  double altura;          ///< altura?
  double proporcion;      ///< proporcion?
  model::Terna vertices;  ///< vertices?
};

/// A component of each name that holds an attribute: it stands where a table of attributes asks for a scene of the
/// specification, and its components are told apart, not looked at.
struct AnyEscena {
  std::map<model::Elemento, model::Punto> mi_centro;       ///< as Escena::mi_centro
  std::map<model::Elemento, model::Rmas> mi_radio;         ///< as Escena::mi_radio
  std::map<model::Elemento, model::Vector> mi_vector;      ///< as Escena::mi_vector
  std::map<model::Elemento, model::Rmas> mi_altura;        ///< as Escena::mi_altura
  std::map<model::Elemento, model::Rmas> mi_proporcion;    ///< as Escena::mi_proporcion
  std::map<model::Elemento, model::Vertices> mi_vertices;  ///< as Escena::mi_vertices
};

/// The table of a shape's attributes, with the components of the specification where `Escena` is model::Escena.
template <class Shape, class Escena = AnyEscena>
inline constexpr auto attributes_of = Shape::template attributes<AnyInputs, Escena>;

/// @{ What a table stores of an input.
inline double stored(double x) { return x; }
inline const glm::dvec3& stored(const model::Punto& p) { return p.xyz(); }
inline const glm::dvec3& stored(const model::Vector& v) { return v.xyz(); }
inline Corners stored(const model::Terna& v) { return {v.a.xyz(), v.b.xyz(), v.c.xyz()}; }
/// @}

/// The input that is stored so.
template <class Input, class Stored>
Input input_of(const Stored& value) {
  return Input(value);
}
/// The three vertices that are stored so.
template <>
inline model::Terna input_of(const Corners& value) {
  return {model::Punto(value[0]), model::Punto(value[1]), model::Punto(value[2])};
}

/// visit(attribute) for each attribute of the shape, in the order of the text.
template <class Shape, class Escena = AnyEscena, class Visit>
constexpr void for_each_attribute(Visit&& visit) {
  std::apply([&](const auto&... attribute) { (visit(attribute), ...); }, attributes_of<Shape, Escena>);
}

/// visit(attribute) for each attribute of each shape; one that several shapes have is visited for each.
template <class Visit>
constexpr void for_each_attribute_of_all(Visit&& visit) {
  for_each_shape([&]<class Shape>(std::type_identity<Shape>) { for_each_attribute<Shape>(visit); });
}

/// The class of a component, Escena of &Escena::mi_radio.
template <class Escena, class Component>
Escena escena_of(Component Escena::*);

/// The place in the shape's table of the attribute that this component holds, such as &AnyEscena::mi_radio; the size of
/// the table where the shape has none such.
template <class Shape, auto component>
consteval std::size_t place_of_attribute() {
  std::size_t place = std::tuple_size_v<decltype(attributes_of<Shape>)>, at = 0;
  for_each_attribute<Shape, decltype(escena_of(component))>([&]<class TableRow>(const TableRow& attribute) {
    if constexpr (std::is_same_v<decltype(attribute.component), std::remove_const_t<decltype(component)>>)
      if (attribute.component == component) place = at;
    ++at;
  });
  return place;
}

/// Whether the shape has that attribute.
template <class Shape, auto component>
constexpr bool has_attribute() {
  return place_of_attribute<Shape, component>() < std::tuple_size_v<decltype(attributes_of<Shape>)>;
}

/// Its value, as the tables hold it.
template <auto component, class Shape>
constexpr const auto& attribute_value(const Shape& shape) {
  return shape.*std::get<place_of_attribute<Shape, component>()>(attributes_of<Shape>).field;
}

}  // namespace durero::scene
