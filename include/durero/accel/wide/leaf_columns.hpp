#pragma once
/// The leaves of a wide hierarchy copy its elements into a column for each type, in the order of the tree. Neighbours
/// in space are neighbours in memory, and a traversal reads no other page of the scene's tables. A table maps each
/// element to its leaf, so that the elements that a ray starts on have the names that the traversal uses. Triangles of
/// binary32 stand in blocks of up to eight instead, each of which takes the place of a node.

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
#include "durero/trace/triangle_block.hpp"

namespace durero::accel {

/// Columns of elements, one for each type, and blocks of triangles. A leaf is a row of a column, named by an ElementRef
/// whose index is the row; or a triangle of a block, whose index has `in_block` set.
class LeafColumns {
 public:
  using BlockUnit = trace::TriangleBlock::Unit;   ///< of the memory of blocks
  static constexpr std::size_t nearby = 1 << 18;  ///< bytes of nodes that stay in the cache: no prefetch of leaves

  /// The bit of an index that names a triangle of a block; the other bits are eight times the block's index, and the
  /// lane.
  static constexpr std::uint32_t in_block = std::uint32_t{1} << 31;

  /// The name of the first triangle of a block. Those of the others count up.
  static scene::ElementRef first_of(std::uint32_t block) {
    return {model::Tipo::soy_triangulo, in_block | block * static_cast<std::uint32_t>(trace::TriangleBlock::size)};
  }

  /// Takes the blocks of triangles of the scene, behind which is `room`, and reserves room for its other elements.
  /// Precondition: what is added are elements of this scene alone.
  void reserve(const scene::Scene& scene, LargeVector<BlockUnit> units = {}) {
    rows_.resize(scene.size());
    blocks_ = std::move(units);
    std::size_t in_blocks = 0;
    blocks().for_each([&](std::uint32_t, const trace::TriangleBlock& block) { in_blocks += block.count(); });
    std::size_t first = 0;
    scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
      first_[static_cast<std::size_t>(Shape::tipo)] = first;
      first += scene.shapes<Shape>().size();
      Column<Shape>& column = std::get<Column<Shape>>(columns_);
      std::size_t apart = scene.shapes<Shape>().size();
      if constexpr (Shape::tipo == model::Tipo::soy_triangulo) apart -= in_blocks;
      column.shapes.reserve(apart);
      column.elements.reserve(apart);
    });
    blocks().for_each([&](std::uint32_t index, const trace::TriangleBlock& block) {
      for (std::uint32_t lane = 0; lane < block.count(); ++lane)
        rows_[place({model::Tipo::soy_triangulo, block.element(lane)})] = first_of(index).index + lane;
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

  /// The block of a triangle by the index of its leaf. Precondition: `in_block` is set.
  trace::TriangleBlock block_of(std::uint32_t leaf) const {
    return blocks()[(leaf & ~in_block) / trace::TriangleBlock::size];
  }
  /// The blocks, by index.
  trace::TriangleBlocks blocks() const noexcept { return trace::TriangleBlocks(blocks_); }

  /// visit(shape) with the geometry of a leaf.
  template <class Visit>
  decltype(auto) visit(scene::ElementRef leaf, Visit&& visit) const {
    if (is_in_block(leaf)) {
      const scene::Triangle triangle = block_of(leaf.index).triangle(lane_in_block(leaf));
      return visit(triangle);
    }
    return scene::with_shape(leaf.tipo, [&]<class Shape>(std::type_identity<Shape>) -> decltype(auto) {
      return visit(std::get<Column<Shape>>(columns_).shapes[leaf.index]);
    });
  }
  /// Prefetches the geometry of a leaf.
  void ask_for_shape(scene::ElementRef leaf) const {
    if (is_in_block(leaf)) return block_of(leaf.index).ask();
    visit(leaf, [](const auto& shape) { trace::ask_for(shape); });
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
    if (is_in_block(leaf)) return {leaf.tipo, block_of(leaf.index).element(lane_in_block(leaf))};
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
    std::size_t sum = rows_.capacity() * sizeof(std::uint32_t) + blocks_.capacity() * sizeof(BlockUnit);
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

  static bool is_in_block(scene::ElementRef leaf) {
    return leaf.tipo == model::Tipo::soy_triangulo && (leaf.index & in_block) != 0;
  }
  static std::size_t lane_in_block(scene::ElementRef leaf) { return leaf.index % trace::TriangleBlock::size; }

  std::size_t place(scene::ElementRef e) const { return first_[static_cast<std::size_t>(e.tipo)] + e.index; }

  typename ColumnsOf<scene::Shapes>::type columns_;
  LargeVector<BlockUnit> blocks_;                        // the blocks, and room for lanes
  LargeVector<std::uint32_t> rows_;                      // the leaf of each element, in the scene's order
  std::array<std::size_t, scene::shape_count> first_{};  // the place in rows_ where each type begins
};

/// Gives `take` a ray's number with a block of triangles: the block, where it takes blocks, or each of the triangles.
template <class Visitor>
void take_block(Visitor& take, std::uint32_t number, trace::TriangleBlocks blocks, std::uint32_t index) {
  const trace::TriangleBlock block = blocks[index];
  const scene::ElementRef first = LeafColumns::first_of(index);
  if constexpr (requires { take(number, block, first); }) {
    take(number, block, first);
  } else {
    for (std::uint32_t lane = 0; lane < trace::TriangleBlock::size; ++lane)
      if (block.has(lane)) take(number, scene::ElementRef{first.tipo, first.index + lane});
  }
}

/// Makes the node that the block of this index stands for: its children are the triangles by their names, and their
/// boxes are exact in binary32. Unused lanes become empty children, which may not come last.
void unpack(trace::TriangleBlocks blocks, std::uint32_t index, WideNode& node);

}  // namespace durero::accel
