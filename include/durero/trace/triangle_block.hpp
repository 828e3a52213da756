#pragma once
/// A block holds up to eight triangles for a test of one ray against all of them side by side. Each point stands once,
/// in columns of binary32, and a corner is the number of a point, in a byte. The triangles' coordinates are numbers of
/// binary32, so that no coordinate is rounded.

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "durero/scene/element_ref.hpp"
#include "durero/scene/shapes.hpp"

namespace durero::trace {

/// Whether every coordinate of a triangle is a number of binary32.
inline bool is_single(const scene::Triangle& triangle) {
  bool single = true;
  for (const glm::dvec3& vertex : triangle.vertices)
    for (int axis = 0; axis < 3; ++axis)
      single &= static_cast<double>(static_cast<float>(vertex[axis])) == vertex[axis];
  return single;
}

/// A view of a block in memory, of as many units as its triangles and points need. In order it has the two numbers of
/// these, the corners' numbers where triangles share points, the points' x, y and z, and the triangles' rows in the
/// scene. Points that are not shared are a corner of each triangle in turn, first all first corners.
class TriangleBlock {
 public:
  static constexpr std::size_t size = 8;                 ///< triangles at most
  static constexpr std::size_t most_shared = 2 * size;   ///< points at most where some are shared
  using Column = std::array<float, size>;                ///< a coordinate of each triangle
  using Columns = std::array<std::array<Column, 3>, 3>;  ///< of each corner: x, y and z
  static constexpr std::size_t room = 4;                 ///< units behind the last block, which lanes read
  /// What memory for blocks is counted in.
  struct alignas(16) Unit {
    std::array<std::byte, 16> bytes{};  ///< uninterpreted
  };

  /// The block that begins at a unit. It must outlive the view, and `room` units must follow it.
  explicit TriangleBlock(const Unit* first) : bytes_(first->bytes.data()) {}

  /// The number of triangles. They stand in the first lanes.
  std::uint32_t count() const { return std::to_integer<std::uint32_t>(bytes_[0]); }
  /// The number of points.
  std::size_t points() const { return std::to_integer<std::size_t>(bytes_[1]); }
  /// Whether triangles share points.
  bool is_shared() const { return points() < 3 * count(); }
  /// The lanes that hold a triangle, a bit each.
  unsigned lanes() const { return (1u << count()) - 1; }
  /// Whether a lane holds a triangle.
  bool has(std::size_t lane) const { return lane < count(); }
  /// The row of a triangle in the scene. Precondition: has(lane).
  std::uint32_t element(std::size_t lane) const {
    std::uint32_t row;
    std::memcpy(&row, bytes_ + place_of_elements(is_shared(), points()) + lane * sizeof row, sizeof row);
    return row;
  }
  /// A coordinate of all points, in their order.
  const float* column(std::size_t axis) const {
    return reinterpret_cast<const float*>(bytes_ + place_of_points(is_shared())) + axis * points();
  }
  /// The numbers of a corner, one for each lane; 0 in lanes without a triangle. Precondition: is_shared().
  const std::uint8_t* numbers(std::size_t corner) const {
    return reinterpret_cast<const std::uint8_t*>(bytes_ + head) + corner * size;
  }
  /// The point that is a corner of a triangle. Precondition: has(lane).
  std::size_t number(std::size_t corner, std::size_t lane) const {
    return is_shared() ? numbers(corner)[lane] : corner * count() + lane;
  }
  /// The triangle of a lane. Precondition: has(lane).
  scene::Triangle triangle(std::size_t lane) const {
    scene::Triangle triangle{};
    for (std::size_t i = 0; i < 3; ++i)
      for (int axis = 0; axis < 3; ++axis)
        triangle.vertices[i][axis] = double{column(static_cast<std::size_t>(axis))[number(i, lane)]};
    return triangle;
  }
  /// The units that it takes.
  std::size_t units() const { return units_of(count(), points()); }
  /// Prefetches the units of a block of usual size.
  void ask() const {
    for (std::size_t at = 0; at < usual; at += line) __builtin_prefetch(bytes_ + at);
    asm volatile("" : : "r"(bytes_));  // for GCC, see trace::ask_for
  }

 private:
  friend class BlockBuilder;
  static constexpr std::size_t head = 4, line = 64, usual = 4 * line;  // in bytes

  static std::size_t place_of_points(bool shared) { return shared ? head + 3 * size : head; }
  static std::size_t place_of_elements(bool shared, std::size_t points) {
    return place_of_points(shared) + 3 * points * sizeof(float);
  }
  static std::size_t units_of(std::size_t count, std::size_t points) {
    const std::size_t rows = count * sizeof(std::uint32_t);
    return (place_of_elements(points < 3 * count, points) + rows + sizeof(Unit) - 1) / sizeof(Unit);
  }

  const std::byte* bytes_;
};

/// Blocks behind each other. The index of a block is the unit where it begins.
class TriangleBlocks {
 public:
  using Unit = TriangleBlock::Unit;  ///< of their memory

  /// The units are no blocks at all, or blocks and `room`. They must outlive it.
  explicit TriangleBlocks(std::span<const Unit> units) : units_(units) {}

  /// There is none.
  bool empty() const noexcept { return units_.empty(); }
  /// The bytes of all.
  std::size_t size_bytes() const noexcept { return units_.size_bytes(); }
  /// The block of an index.
  TriangleBlock operator[](std::uint32_t index) const noexcept { return TriangleBlock(&units_[index]); }
  /// visit(index, block) for each block.
  template <class Visit>
  void for_each(Visit visit) const {
    for (std::size_t at = 0; at + TriangleBlock::room < units_.size();) {
      const TriangleBlock block(&units_[at]);
      visit(static_cast<std::uint32_t>(at), block);
      at += block.units();
    }
  }

 private:
  std::span<const Unit> units_;
};

/// Collects the triangles of one block.
class BlockBuilder {
 public:
  /// Adds a triangle of the scene's row `element`. Preconditions: is_single(triangle); there are less than eight.
  void push_back(const scene::Triangle& triangle, std::uint32_t element);
  /// Writes the block behind others. Precondition: there is a triangle.
  template <class Units>
  void append_to(Units& units) const {
    const std::size_t before = units.size();
    units.resize(before + TriangleBlock::units_of(count_, points()));
    write(units[before].bytes.data());
  }

 private:
  using Point = std::array<float, 3>;

  std::size_t points() const { return points_ > TriangleBlock::most_shared ? 3 * count_ : points_; }
  void write(std::byte* to) const;

  std::size_t count_ = 0, points_ = 0;                                      // triangles, and points that differ
  std::array<Point, 3 * TriangleBlock::size> point_{};                      // that differ
  std::array<std::array<std::uint8_t, TriangleBlock::size>, 3> numbers_{};  // of each corner
  std::array<std::uint32_t, TriangleBlock::size> elements_{};
};

/// Puts the corners of a block's triangles into columns. Lanes without a triangle get NaN.
void unpack(const TriangleBlock& block, TriangleBlock::Columns& columns);

/// The lane of an element among eight whose names count up from `first`, as a bit; no bit where it is none of them.
inline unsigned lane_of(scene::ElementRef element, scene::ElementRef first) {
  const std::uint32_t lane = element.index - first.index;
  return element.tipo == first.tipo && lane < TriangleBlock::size ? 1u << lane : 0;
}

}  // namespace durero::trace
