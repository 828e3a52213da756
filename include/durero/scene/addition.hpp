#pragma once
/// The additions of the shapes: from an operation's inputs to the geometry that a table stores, and back.

#include <tuple>

#include "durero/model/operaciones.hpp"
#include "durero/scene/attributes.hpp"

namespace durero::scene {

/// The table of a shape's attributes, each with the input of the shape's addition.
template <class Shape>
inline constexpr auto inputs_of = Shape::template attributes<typename Shape::Addition, model::Escena>;

/// visit(attribute) for each attribute of the shape, in the order of the text, each with its input.
template <class Shape, class Visit>
constexpr void for_each_input(Visit&& visit) {
  std::apply([&](const auto&... attribute) { (visit(attribute), ...); }, inputs_of<Shape>);
}

/// The geometry that an addition describes.
template <class Shape>
Shape shape_of(const typename Shape::Addition& in) {
  return std::apply([&](const auto&... attribute) { return Shape{stored(in.*attribute.input)...}; }, inputs_of<Shape>);
}

/// The addition that puts this geometry under a name.
template <class Shape>
typename Shape::Addition addition(const model::Elemento& e, const Shape& shape) {
  const auto input = [&]<class TableRow>(const TableRow& attribute) {
    return input_of<typename TableRow::Input>(shape.*attribute.field);
  };
  return std::apply(
      [&](const auto&... attribute) {
        return typename Shape::Addition{e, input(attribute)...};
      },
      inputs_of<Shape>);
}

}  // namespace durero::scene
