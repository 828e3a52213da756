#pragma once
/// The leaves of a wide hierarchy copy its elements into a column for each type, in the order of the tree. Neighbours
/// in space are neighbours in memory, and a traversal reads no other page of the scene's tables. A table maps each
/// element to its leaf, so that the elements that a ray starts on have the names that the traversal uses.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>
#include <utility>

#include "durero/accel/large_pages.hpp"
#include "durero/accel/wide/wide_node.hpp"
#include "durero/scene/scene.hpp"
#include "durero/trace/picked.hpp"

namespace durero::accel {

/// Columns of elements, one for each type. A leaf is a row of a column, named by an ElementRef whose index is the row.
class LeafColumns {
 public:
  static constexpr std::size_t nearby = 1 << 18;  ///< bytes of nodes that stay in the cache: no prefetch of leaves

  /// Reserves room for every element of the scene. Precondition: push_back adds elements of this scene alone.
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
  /// Adds an element of the scene, and answers its leaf.
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
  /// The addresses of the rows, for prefetching them without a branch. The traversal prefetches nearly every leaf that
  /// it reaches, and a branch on the leaf's type would be mispredicted.
  class Rows {
   public:
    /// The first byte of a leaf's row, and the last.
    std::pair<const std::byte*, const std::byte*> ends(scene::ElementRef leaf) const {
      const auto [first, size] = of_type_[static_cast<std::size_t>(leaf.tipo)];
      const std::byte* const row = first + leaf.index * size;
      return {row, row + size - 1};
    }
    /// Prefetches the leaf's row, which spans two cache lines at most.
    void ask_for(scene::ElementRef leaf) const {
      const auto [first, last] = ends(leaf);
      __builtin_prefetch(first);
      __builtin_prefetch(last);
      asm volatile("" : : "r"(first));  // for GCC, see trace::ask_for
    }

   private:
    friend class LeafColumns;
    struct OfType {
      const std::byte* first;
      std::size_t size;
    };
    std::array<OfType, scene::shape_count> of_type_{};
  };
  /// The addresses of the rows. They are valid until the next push_back.
  Rows rows() const {
    Rows rows;
    scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
      static_assert(sizeof(Shape) <= 2 * cache_line);
      const std::span<const Shape> shapes = std::get<Column<Shape>>(columns_).shapes;
      rows.of_type_[static_cast<std::size_t>(Shape::tipo)] = {std::as_bytes(shapes).data(), sizeof(Shape)};
    });
    return rows;
  }
  /// The element of the scene that the leaf is a copy of.
  scene::ElementRef element(scene::ElementRef leaf) const {
    return scene::with_shape(leaf.tipo, [&]<class Shape>(std::type_identity<Shape>) {
      return scene::ElementRef{leaf.tipo, std::get<Column<Shape>>(columns_).elements[leaf.index]};
    });
  }
  /// The leaf of an element of the scene. Precondition: it was added.
  scene::ElementRef leaf(scene::ElementRef e) const { return {e.tipo, rows_[place(e)]}; }
  /// Prefetches the entry that leaf(e) reads.
  void ask_for_leaf(scene::ElementRef e) const { trace::ask_for(rows_[place(e)]); }
  /// The bytes that the columns and the table hold.
  std::size_t bytes() const {
    std::size_t sum = rows_.capacity() * sizeof(std::uint32_t);
    scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
      const Column<Shape>& column = std::get<Column<Shape>>(columns_);
      sum += column.shapes.capacity() * sizeof(Shape) + column.elements.capacity() * sizeof(std::uint32_t);
    });
    return sum;
  }

 private:
  /// The copies of one type's elements.
  template <class Shape>
  struct Column {
    LargeVector<Shape> shapes;
    LargeVector<std::uint32_t> elements;  // the row of each in the scene
  };
  template <class List>
  struct ColumnsOf;
  template <class... Shape>
  struct ColumnsOf<std::tuple<Shape...>> {
    using type = std::tuple<Column<Shape>...>;
  };

  std::size_t place(scene::ElementRef e) const { return first_[static_cast<std::size_t>(e.tipo)] + e.index; }

  typename ColumnsOf<scene::Shapes>::type columns_;
  LargeVector<std::uint32_t> rows_;                      // the leaf of each element, in the scene's order
  std::array<std::size_t, scene::shape_count> first_{};  // the place in rows_ where each type begins
};

}  // namespace durero::accel
