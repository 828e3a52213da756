#pragma once
/// A shape whose type is known when the program runs: an element without its name.

#include <variant>

#include "durero/scene/shapes.hpp"

namespace durero::scene {

/// The closed set as alternatives of one value.
template <class List>
struct VariantOf;
/// Of a list of shapes.
template <class... Shape>
struct VariantOf<std::tuple<Shape...>> {
  using type = std::variant<Shape...>;  ///< one of them
};

/// Any shape, by value, in the order of Tipo.
using AnyShape = VariantOf<Shapes>::type;

}  // namespace durero::scene
