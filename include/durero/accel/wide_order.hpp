#pragma once
/// The order in which rays through a wide hierarchy find company: those into one octant and from one part of space
/// together.

#include <array>
#include <cstdint>
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

/// Orders numbers of rays by their keys; those of one key stay in the order in which they are.
void sort_by_key(const WideKeys& key_of, std::span<const trace::Ray> rays, std::vector<std::uint32_t>& numbers);

}  // namespace durero::accel
