#pragma once
/// A block holds up to eight triangles in columns of binary32, for a test of one ray against all of them side by side.
/// Its triangles have coordinates that are numbers of binary32, so that no coordinate is rounded.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
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

/// Triangles in columns, in five cache lines.
struct alignas(64) TriangleBlock {
  static constexpr std::size_t size = 8;   ///< triangles at most
  using Column = std::array<float, size>;  ///< a coordinate of each triangle

  std::array<std::array<Column, 3>, 3> vertices;  ///< of each vertex: x, y and z; NaN in lanes without a triangle
  std::array<std::uint32_t, size> elements{};     ///< the row of each triangle in the scene

  /// A block without triangles.
  TriangleBlock() {
    for (auto& vertex : vertices)
      for (Column& column : vertex) column.fill(std::numeric_limits<float>::quiet_NaN());
  }
  /// Puts a triangle of the scene's row `element` into a lane. Precondition: is_single(triangle).
  void set(std::size_t lane, const scene::Triangle& triangle, std::uint32_t element) {
    for (std::size_t i = 0; i < 3; ++i)
      for (int axis = 0; axis < 3; ++axis)
        vertices[i][static_cast<std::size_t>(axis)][lane] = static_cast<float>(triangle.vertices[i][axis]);
    elements[lane] = element;
  }
  /// Whether a lane holds a triangle.
  bool has(std::size_t lane) const { return vertices[0][0][lane] == vertices[0][0][lane]; }
  /// The number of triangles.
  std::uint32_t count() const {
    std::uint32_t count = 0;
    for (std::size_t lane = 0; lane < size; ++lane) count += has(lane);
    return count;
  }
  /// The triangle of a lane. Precondition: has(lane).
  scene::Triangle triangle(std::size_t lane) const {
    scene::Triangle triangle{};
    for (std::size_t i = 0; i < 3; ++i)
      for (int axis = 0; axis < 3; ++axis)
        triangle.vertices[i][axis] = static_cast<double>(vertices[i][static_cast<std::size_t>(axis)][lane]);
    return triangle;
  }
};
static_assert(sizeof(TriangleBlock) == 320);

/// The lane of an element among eight whose names count up from `first`, as a bit; no bit where it is none of them.
inline unsigned lane_of(scene::ElementRef element, scene::ElementRef first) {
  const std::uint32_t lane = element.index - first.index;
  return element.tipo == first.tipo && lane < TriangleBlock::size ? 1u << lane : 0;
}

}  // namespace durero::trace
