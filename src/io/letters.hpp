#pragma once
/// The letters that begin the names of elements in formats that have no names for them: s1, c1, k1, t1, p1, d1, v1, ….

#include <string_view>

#include "durero/scene/shapes.hpp"

namespace durero::io {

/// The letter of a type.
template <class Shape>
constexpr char letter_of() {
  return std::string_view("scktpdv")[scene::place_of<Shape>];
}

}  // namespace durero::io
