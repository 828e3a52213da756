#pragma once
/// The dense table of one type of element: row i of each column belongs to one element.

#include <algorithm>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "durero/model/tipos.hpp"

namespace durero::scene {

inline constexpr std::uint32_t no_material = std::numeric_limits<std::uint32_t>::max();

template <class Shape>
struct Row {
  Shape shape;
  model::Elemento name;
  std::uint32_t material = no_material;
};

template <class Shape>
struct Table {
  std::vector<Shape> shapes;
  std::vector<model::Elemento> names;
  std::vector<std::uint32_t> materials;  ///< no_material where the element has none

  std::uint32_t size() const noexcept { return static_cast<std::uint32_t>(shapes.size()); }

  /// Makes room for one more row. The only member that asks for memory; nothing that can be seen changes.
  void reserve_one_more() {
    if (shapes.size() >= no_material) throw std::length_error("a scene holds at most 2^32 - 1 elements of a type");
    grow(shapes);
    grow(names);
    grow(materials);
  }

  /// Precondition: room for the row.
  void push_back(Row<Shape>&& row) noexcept {
    shapes.push_back(row.shape);
    names.push_back(std::move(row.name));
    materials.push_back(row.material);
  }

  Row<Shape> pop_back() noexcept {
    Row<Shape> row{shapes.back(), std::move(names.back()), materials.back()};
    shapes.pop_back();
    names.pop_back();
    materials.pop_back();
    return row;
  }

  void swap_rows(std::uint32_t i, std::uint32_t j) noexcept {
    using std::swap;
    swap(shapes[i], shapes[j]);
    swap(names[i], names[j]);
    swap(materials[i], materials[j]);
  }

 private:
  template <class T>
  static void grow(std::vector<T>& column) {
    if (column.size() == column.capacity()) column.reserve(std::max<std::size_t>(16, 2 * column.size()));
  }
};

}  // namespace durero::scene
