#pragma once
/// The order in which rays through a wide hierarchy find company: those into one octant and from one part of space
/// together.

#include <array>
#include <cstdint>
#include <glm/common.hpp>
#include <span>
#include <vector>

#include "durero/accel/wide_node.hpp"

namespace durero::accel {

/// Numbers of rays by which they are ordered: cells that lie close together have numbers that mostly do (Morton), each
/// octant of directions its own.
class WideKeys {
 public:
  /// Cells as wide as the elements lie apart, or half that.
  WideKeys(const WideNode& root, double spacing);
  /// No key has more bits.
  unsigned bits() const { return 3 * bits_ + 3; }
  /// Of the ray from a point in a direction.
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

  /// In which cell an origin lies; whatever lies in none counts to the first or the last.
  std::uint32_t cell(double from_low) const {
    const double at = from_low * scale_;
    return at > 0 ? static_cast<std::uint32_t>(at < last_ ? at : last_) : 0;
  }
  /// The nine bits of a number, two of 0 between each.
  static std::uint32_t apart(std::uint32_t x) {
    x = (x | x << 16) & 0x030000ff;
    x = (x | x << 8) & 0x0300f00f;
    x = (x | x << 4) & 0x030c30c3;
    return (x | x << 2) & 0x09249249;
  }

  glm::dvec3 low_{};
  double scale_ = 0, last_ = 0;  // cells by length; the last cell
  unsigned bits_ = 0;
};

/// Numbers of segments by which they are ordered where they go to one point, as of shadows: those that pass the same
/// places on their way there have numbers that mostly lie close together.
class WideWays {
 public:
  /// No key has more bits.
  static constexpr unsigned bits() { return 2 * bits_across + 3; }
  /// Of the direction: by the face of a cube that it goes to, and where.
  std::uint32_t operator()(const glm::dvec3& v) const {
    const glm::dvec3 size = glm::abs(v);
    const int along = size.x < size.y ? (size.y < size.z ? 2 : 1) : (size.x < size.z ? 2 : 0);
    const std::uint32_t face = 2 * static_cast<std::uint32_t>(along) + (v[along] < 0 ? 1 : 0);
    const double inverse = 1 / v[along];
    return face << (2 * bits_across) | apart(cell(v[(along + 1) % 3] * inverse)) |
           apart(cell(v[(along + 2) % 3] * inverse)) << 1;
  }

 private:
  static constexpr unsigned bits_across = 10;  // of a place across a face
  static constexpr double cells = 1 << bits_across;

  /// In which cell a slope between −1 and 1 lies.
  static std::uint32_t cell(double slope) {
    const double at = (slope + 1) * (cells / 2);
    return at > 0 ? static_cast<std::uint32_t>(at < cells - 1 ? at : cells - 1) : 0;
  }
  /// The ten bits of a number, one of 0 between each.
  static std::uint32_t apart(std::uint32_t x) {
    x = (x | x << 8) & 0x00ff00ff;
    x = (x | x << 4) & 0x0f0f0f0f;
    x = (x | x << 2) & 0x33333333;
    return (x | x << 1) & 0x55555555;
  }
};

/// The numbers of segments in the order in which they find company: of those that end much closer together than they
/// begin by the way to there, of others by where they begin.
void sort_segments(const WideKeys& key_of, std::span<const trace::Ray> rays, std::vector<std::uint32_t>& numbers);

}  // namespace durero::accel
