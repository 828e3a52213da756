#pragma once
/// An attribute of a shape: one row that holds all that its letters name. Whoever needs the attributes of a shape
/// (files, scripts, messages, the retrieve function, the values of the Z text) walks the shape's table of them.

#include <array>
#include <glm/vec3.hpp>
#include <map>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "durero/model/escena.hpp"
#include "durero/model/operaciones.hpp"

namespace durero::scene {

/// A Terna as the compact tables hold it: a, b and c.
using Corners = std::array<glm::dvec3, 3>;

/// One attribute of a shape, by all its names.
template <class ShapeType, class StoredType, class Addition, class InputType, class ValueType>
struct Attribute {
  using Stored = StoredType;  ///< of the compact table: double, glm::dvec3 or Corners
  using Input = InputType;    ///< of the addition: double, Punto, Vector or Terna
  using Value = ValueType;    ///< of the specification: Rmas, Punto, Vector or Vertices

  std::string_view word;                                       ///< in files, scripts and messages
  Stored ShapeType::*field;                                    ///< in the compact table
  Input Addition::*input;                                      ///< radio? and the like
  std::map<model::Elemento, Value> model::Escena::*component;  ///< mi_radio and the like
};

/// As the standard deduces them of an aggregate; Clang 16 does not.
template <class ShapeType, class StoredType, class Addition, class InputType, class ValueType>
Attribute(std::string_view, StoredType ShapeType::*, InputType Addition::*,
          std::map<model::Elemento, ValueType> model::Escena::*)
    -> Attribute<ShapeType, StoredType, Addition, InputType, ValueType>;

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
template <class Shape, class Visit>
constexpr void for_each_attribute(Visit&& visit) {
  std::apply([&](const auto&... attribute) { (visit(attribute), ...); }, Shape::attributes);
}

/// The geometry that an addition describes.
template <class Shape>
Shape shape_of(const typename Shape::Addition& in) {
  return std::apply([&](const auto&... attribute) { return Shape{stored(in.*attribute.input)...}; }, Shape::attributes);
}

/// The addition that puts this geometry under a name.
template <class Shape>
typename Shape::Addition addition(const model::Elemento& e, const Shape& shape) {
  const auto input = [&]<class Row>(const Row& attribute) {
    return input_of<typename Row::Input>(shape.*attribute.field);
  };
  return std::apply(
      [&](const auto&... attribute) {
        return typename Shape::Addition{e, input(attribute)...};
      },
      Shape::attributes);
}

/// The place in the shape's table of the attribute that this component of the specification holds, such as
/// &Escena::mi_radio; the size of the table where the shape has none such.
template <class Shape, auto component>
consteval std::size_t place_of_attribute() {
  std::size_t place = std::tuple_size_v<decltype(Shape::attributes)>, at = 0;
  for_each_attribute<Shape>([&]<class Row>(const Row& attribute) {
    if constexpr (std::is_same_v<decltype(attribute.component), std::remove_const_t<decltype(component)>>)
      if (attribute.component == component) place = at;
    ++at;
  });
  return place;
}

/// Whether the shape has that attribute.
template <class Shape, auto component>
constexpr bool has_attribute() {
  return place_of_attribute<Shape, component>() < std::tuple_size_v<decltype(Shape::attributes)>;
}

/// Its value, as the tables hold it.
template <auto component, class Shape>
constexpr const auto& attribute_value(const Shape& shape) {
  return shape.*std::get<place_of_attribute<Shape, component>()>(Shape::attributes).field;
}

}  // namespace durero::scene
