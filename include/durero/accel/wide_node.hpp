#pragma once
/// A node of the wide hierarchy: the boxes of eight children in binary32, tested together.
///
/// Each test computes in binary64, to which the planes of binary32 are taken exactly, by the operations of slab.hpp in
/// their order. So what is proved of those (proofs/Slab.v: slab64_never_rejects, and entry_never_rejects of a box that
/// has waited) holds in every lane. Its conditions hold: the planes are finite, hence of magnitude below 2¹²⁸, and the
/// rays ordinary; an empty child alone has infinite planes, and no ray meets it.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "durero/accel/slab.hpp"
#include "durero/scene/element_ref.hpp"

namespace durero::accel {

/// What lies in one of the eight places of a node.
struct WideChild {
  /// Nothing, a node, or an element.
  enum class Kind : std::uint8_t { none, node, element };

  std::uint32_t index = 0;  ///< of the node, or of the element in the table of its type
  model::Tipo tipo{};       ///< of an element
  Kind kind = Kind::none;   ///< what it is

  /// Precondition: it is an element.
  scene::ElementRef element() const { return {tipo, index}; }
};

/// Eight children and their boxes. Four lines of the cache.
struct alignas(64) WideNode {
  static constexpr std::size_t width = 8;            ///< how many children
  using Entries = std::array<double, width>;         ///< a parameter of a ray for each child
  std::array<std::array<float, width>, 6> planes{};  ///< x, y, z of the low corners, then of the high ones
  std::array<WideChild, width> children{};           ///< those that are none come last
};
static_assert(sizeof(WideNode) == 256);

/// No tree has more levels of nodes.
inline constexpr std::size_t most_levels = 36;
/// No walk has more children waiting: seven of each level, and eight of the last.
inline constexpr std::size_t most_waiting = most_levels * (WideNode::width - 1) + 1;

/// The greatest parameter at which a box whose entry waits may still be met, once the limit is this.
inline double latest_entry(double limit) { return limit * grow + tiny; }

/// Rays in columns that walk the tree together: ordinary ones, in whose directions no component is 0 and all those
/// along an axis are of one sign.
struct WideBundle {
  static constexpr std::size_t size = 64;   ///< how many rays at most
  using Column = std::array<double, size>;  ///< a number of each ray
  /// @{ As in Beam, by axis.
  alignas(64) std::array<Column, 3> p{};
  std::array<Column, 3> inverse{};
  /// @}
  Column limit{};  ///< of each ray; below 0 of one that takes no part
  /// @{ Between which the origins and the inverses lie.
  std::array<double, 3> p_low{};
  std::array<double, 3> p_high{};
  std::array<double, 3> inverse_low{};
  std::array<double, 3> inverse_high{};
  /// @}
  std::size_t count = 0;  ///< how many rays

  /// Whether a ray may be added to those that are there: it is of their signs.
  bool takes(const Beam& beam) const {
    bool takes = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double inverse_of = beam.inverse[static_cast<int>(axis)];
      const bool other = (inverse_of < 0) != (inverse_low[axis] < 0);
      takes &= !std::isinf(inverse_of) & !((count > 0) & other);
    }
    return takes;
  }
  /// Adds a ray. Precondition: it takes it, and is not full.
  void push(const Beam& beam) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double p_of = beam.p[static_cast<int>(axis)], inverse_of = beam.inverse[static_cast<int>(axis)];
      p[axis][count] = p_of;
      inverse[axis][count] = inverse_of;
      p_low[axis] = count == 0 ? p_of : std::min(p_low[axis], p_of);
      p_high[axis] = count == 0 ? p_of : std::max(p_high[axis], p_of);
      inverse_low[axis] = count == 0 ? inverse_of : std::min(inverse_low[axis], inverse_of);
      inverse_high[axis] = count == 0 ? inverse_of : std::max(inverse_high[axis], inverse_of);
    }
    ++count;
  }
};

/// A bit for each child whose box some ray of the bundle may meet at 0 < t ≤ limit, the first child's lowest; `entries`
/// gets a parameter before which none enters each. Subtraction and multiplication, rounded, are monotonic: so what is
/// computed of the ends between which origins and inverses lie is no later an entry, and no earlier an exit, than what
/// `stretch` computes of any ray between them (proofs/Bundles.v: bundle_entry, bundle_exit), and the test passes
/// wherever that of some ray does.
unsigned met(const WideNode& node, const WideBundle& bundle, double limit, WideNode::Entries& entries);

/// A bit for each ray of the bundle that may meet the box of one child up to its own limit, as `stretch` finds it of
/// each. Precondition: the bundle is not empty.
std::uint64_t met_by(const WideNode& node, std::size_t child, const WideBundle& bundle);

}  // namespace durero::accel
