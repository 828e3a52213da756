#pragma once
/// An attribute of a shape: one row that holds all that its letters name. Whoever needs the attributes of a shape
/// (files, scripts, messages, the retrieve function, the values of the Z text) walks the shape's table of them
/// (scene/attributes.hpp).

#include <array>
#include <glm/vec3.hpp>
#include <map>
#include <string_view>
#include <tuple>

#include "durero/model/operation.hpp"
#include "durero/model/tipos.hpp"

namespace durero::scene {

/// A Terna as the compact tables hold it: a, b and c.
using Corners = std::array<glm::dvec3, 3>;

/// One attribute of a shape, by all its names.
template <class ShapeType, class StoredType, class Addition, class InputType, class Escena, class ValueType>
struct Attribute {
  using Stored = StoredType;  ///< of the compact table: double, glm::dvec3 or Corners
  using Input = InputType;    ///< of the addition: double, Punto, Vector or Terna
  using Value = ValueType;    ///< of the specification: Rmas, Punto, Vector or Vertices

  std::string_view word;                                ///< in files, scripts and messages
  Stored ShapeType::*field;                             ///< in the compact table
  Input Addition::*input;                               ///< radio? and the like
  std::map<model::Elemento, Value> Escena::*component;  ///< mi_radio and the like
};

/// As the standard deduces them of an aggregate; Clang 16 does not.
template <class ShapeType, class StoredType, class Addition, class InputType, class Escena, class ValueType>
Attribute(std::string_view, StoredType ShapeType::*, InputType Addition::*,
          std::map<model::Elemento, ValueType> Escena::*)
    -> Attribute<ShapeType, StoredType, Addition, InputType, Escena, ValueType>;

}  // namespace durero::scene
