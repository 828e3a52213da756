#pragma once
/// The elements of a wide hierarchy once more, a column for each type in the order of the tree: what lies side by side
/// in space lies side by side in memory, and a ray that reaches an element needs no other page of the scene's tables.
/// And which leaf each element is, so that what a ray starts on is known by the name that its walk comes to.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>
#include <utility>

#include "durero/accel/large_pages.hpp"
#include "durero/accel/wide_node.hpp"
#include "durero/scene/scene.hpp"
#include "durero/trace/picked.hpp"

namespace durero::accel {

/// Rows of elements of every type. A leaf is a type and a row of its column, written as an ElementRef of these columns.
class WideLeaves {
 public:
  static constexpr std::size_t nearby = 1 << 18;  ///< bytes of nodes whose elements need no waiting for

  /// Makes room for every element of a scene, which is the one whose elements are added.
  void reserve(const scene::Scene& scene) {
    rows_.resize(scene.size());
    std::size_t first = 0;
    scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
      first_[static_cast<std::size_t>(Shape::tipo)] = first;
      first += scene.shapes<Shape>().size();
      Column<Shape>& column = std::get<Column<Shape>>(columns_);
      column.shapes.reserve(scene.shapes<Shape>().size());
      column.elements.reserve(scene.shapes<Shape>().size());
    });
  }
  /// Adds an element of a scene. Its leaf.
  scene::ElementRef push_back(const scene::Scene& scene, scene::ElementRef e) {
    return scene.visit(e, [&]<class Shape>(const Shape& shape) {
      Column<Shape>& column = std::get<Column<Shape>>(columns_);
      column.shapes.push_back(shape);
      column.elements.push_back(e.index);
      rows_[place(e)] = static_cast<std::uint32_t>(column.shapes.size() - 1);
      return leaf(e);
    });
  }

  /// visit(shape) with the geometry of a leaf.
  template <class Visit>
  decltype(auto) visit(scene::ElementRef leaf, Visit&& visit) const {
    return scene::with_shape(leaf.tipo, [&]<class Shape>(std::type_identity<Shape>) -> decltype(auto) {
      return visit(std::get<Column<Shape>>(columns_).shapes[leaf.index]);
    });
  }
  /// Where the rows of every type lie, to ask memory for them ahead of time. It is asked for nearly each that a walk
  /// comes to, and of which type that is the processor could not foresee: so nothing branches on it.
  class Rows {
   public:
    /// The first byte of a leaf's row, and the last.
    std::pair<const std::byte*, const std::byte*> ends(scene::ElementRef leaf) const {
      const auto [first, size] = of_type_[static_cast<std::size_t>(leaf.tipo)];
      const std::byte* const row = first + leaf.index * size;
      return {row, row + size - 1};
    }
    /// Asks memory for it: no row is longer than two lines of the cache.
    void ask_for(scene::ElementRef leaf) const {
      const auto [first, last] = ends(leaf);
      __builtin_prefetch(first);
      __builtin_prefetch(last);
      asm volatile("" : : "r"(first));  // as of trace::ask_for
    }

   private:
    friend class WideLeaves;
    struct OfType {
      const std::byte* first;
      std::size_t size;
    };
    std::array<OfType, scene::shape_count> of_type_{};
  };
  /// Those of the leaves, while none is added.
  Rows rows() const {
    Rows rows;
    scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
      static_assert(sizeof(Shape) <= 2 * cache_line);
      const std::span<const Shape> shapes = std::get<Column<Shape>>(columns_).shapes;
      rows.of_type_[static_cast<std::size_t>(Shape::tipo)] = {std::as_bytes(shapes).data(), sizeof(Shape)};
    });
    return rows;
  }
  /// The element of the scene that a leaf is.
  scene::ElementRef element(scene::ElementRef leaf) const {
    return scene::with_shape(leaf.tipo, [&]<class Shape>(std::type_identity<Shape>) {
      return scene::ElementRef{leaf.tipo, std::get<Column<Shape>>(columns_).elements[leaf.index]};
    });
  }
  /// The leaf of an element of the scene. Precondition: it was added.
  scene::ElementRef leaf(scene::ElementRef e) const { return {e.tipo, rows_[place(e)]}; }
  /// Asks memory for what leaf(e) reads.
  void ask_for_leaf(scene::ElementRef e) const { trace::ask_for(rows_[place(e)]); }
  /// What it holds.
  std::size_t bytes() const {
    std::size_t sum = rows_.capacity() * sizeof(std::uint32_t);
    scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
      const Column<Shape>& column = std::get<Column<Shape>>(columns_);
      sum += column.shapes.capacity() * sizeof(Shape) + column.elements.capacity() * sizeof(std::uint32_t);
    });
    return sum;
  }

 private:
  /// The leaves of one type.
  template <class Shape>
  struct Column {
    LargeVector<Shape> shapes;
    LargeVector<std::uint32_t> elements;  // each one's row in the scene
  };
  template <class List>
  struct ColumnsOf;
  template <class... Shape>
  struct ColumnsOf<std::tuple<Shape...>> {
    using type = std::tuple<Column<Shape>...>;
  };

  std::size_t place(scene::ElementRef e) const { return first_[static_cast<std::size_t>(e.tipo)] + e.index; }

  typename ColumnsOf<scene::Shapes>::type columns_;
  LargeVector<std::uint32_t> rows_;                      // of the leaves of all elements, in the scene's order
  std::array<std::size_t, scene::shape_count> first_{};  // where those of each type begin there
};

}  // namespace durero::accel
