#pragma once
/// Where an element lies in the tables of a scene: its type and its place in the dense table of that type.
/// Valid until the next edit of the scene.

#include <boost/container/small_vector.hpp>
#include <compare>
#include <cstdint>

#include "durero/model/tipos.hpp"

namespace durero::scene {

/// The element of row `index` of the table of `tipo`, in a scene that is known from elsewhere.
struct ElementRef {
  model::Tipo tipo;     ///< which table
  std::uint32_t index;  ///< which row of it
  auto operator<=>(const ElementRef&) const = default;
};

/// A set of elements, ascending and without repetition. Nearly always of size 0 or 1, so kept in place.
using ElementSet = boost::container::small_vector<ElementRef, 2>;

}  // namespace durero::scene
