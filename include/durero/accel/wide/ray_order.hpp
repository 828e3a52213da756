#pragma once
/// A coherent order of rays for the wide hierarchy: rays of one octant of directions and from one part of space follow
/// each other, and form bundles.

#include <array>
#include <cstdint>
#include <glm/common.hpp>
#include <span>
#include <vector>

#include "durero/accel/wide/wide_node.hpp"

namespace durero::accel {

/// The sort key of a ray: the octant of its direction, then the Morton code of its origin's cell. Neighbouring cells
/// mostly have neighbouring codes.
class RayOrderKey {
 public:
  /// Divides the root's box into cells whose width is the spacing of the elements or half of it.
  RayOrderKey(const WideNode& root, double spacing);
  /// The greatest number of bits of a key.
  unsigned bits() const { return 3 * bits_ + 3; }
  /// The key of a ray with origin p and direction v.
  std::uint32_t operator()(const glm::dvec3& p, const glm::dvec3& v) const {
    std::uint32_t key = 0;
    for (int axis = 0; axis < 3; ++axis) {
      key |= apart(cell(p[axis] - low_[axis])) << axis;
      key |= static_cast<std::uint32_t>(v[axis] < 0) << (3 * bits_ + static_cast<unsigned>(axis));
    }
    return key;
  }

 private:
  static constexpr unsigned most_bits = 9;  // of a cell's place along an axis

  /// The cell of an origin along an axis. An origin outside the box counts to the first or the last cell.
  std::uint32_t cell(double from_low) const {
    const double at = from_low * scale_;
    return at > 0 ? static_cast<std::uint32_t>(at < last_ ? at : last_) : 0;
  }
  /// The nine bits of x, with two zeros between each.
  static std::uint32_t apart(std::uint32_t x) {
    x = (x | x << 16) & 0x030000ff;
    x = (x | x << 8) & 0x0300f00f;
    x = (x | x << 4) & 0x030c30c3;
    return (x | x << 2) & 0x09249249;
  }

  glm::dvec3 low_{};
  double scale_ = 0, last_ = 0;  // cells per unit of length; the last cell
  unsigned bits_ = 0;
};

/// The sort key of a segment that ends at one point with the others, such as a shadow ray: the direction's place on a
/// cube. Segments that pass the same elements on their way to the point mostly have neighbouring keys.
class DirectionKey {
 public:
  /// The number of bits of a key.
  static constexpr unsigned bits() { return 2 * bits_across + 3; }
  /// The key of a direction: the face of the cube, then the Morton code of the place on the face.
  std::uint32_t operator()(const glm::dvec3& v) const {
    const glm::dvec3 size = glm::abs(v);
    const int along = size.x < size.y ? (size.y < size.z ? 2 : 1) : (size.x < size.z ? 2 : 0);
    const std::uint32_t face = 2 * static_cast<std::uint32_t>(along) + (v[along] < 0 ? 1 : 0);
    const double inverse = 1 / v[along];
    return face << (2 * bits_across) | apart(cell(v[(along + 1) % 3] * inverse)) |
           apart(cell(v[(along + 2) % 3] * inverse)) << 1;
  }

 private:
  static constexpr unsigned bits_across = 10;  // of a place along an edge of a face
  static constexpr double cells = 1 << bits_across;

  /// The cell of a slope between −1 and 1.
  static std::uint32_t cell(double slope) {
    const double at = (slope + 1) * (cells / 2);
    return at > 0 ? static_cast<std::uint32_t>(at < cells - 1 ? at : cells - 1) : 0;
  }
  /// The ten bits of x, with one zero between each.
  static std::uint32_t apart(std::uint32_t x) {
    x = (x | x << 8) & 0x00ff00ff;
    x = (x | x << 4) & 0x0f0f0f0f;
    x = (x | x << 2) & 0x33333333;
    return (x | x << 1) & 0x55555555;
  }
};

/// Sorts the numbers of segments into a coherent order: by direction where their ends lie much closer together than
/// their origins, by origin and octant otherwise. The sort is stable.
void sort_segments(const RayOrderKey& key_of, std::span<const trace::Ray> rays, std::vector<std::uint32_t>& numbers);

}  // namespace durero::accel
