#pragma once
/// A wide node has eight children, whose boxes in binary32 are tested together in lanes.
///
/// The box test loses no hit. It widens the planes to binary64, which is exact, and computes the operations of slab.hpp
/// in their order, so the theorems on those (proofs/Slab.v: slab64_never_rejects, and entry_never_rejects for a box
/// that has waited on the stack) hold in every lane. Their conditions hold: planes are finite, hence of magnitude below
/// 2¹²⁸, and rays are ordinary. Only an empty child has infinite planes, and no ray meets it. A traversal of such nodes
/// therefore visits every element that the ray meets (proofs/Wide.v: prunable_right, nested_leads).

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "durero/accel/slab.hpp"
#include "durero/scene/element_ref.hpp"
#include "durero/trace/packet.hpp"

namespace durero::accel {

/// One of the eight children of a node.
struct WideChild {
  /// A child is nothing, a node, an element, or a block of triangles.
  enum class Kind : std::uint8_t { none, node, element, block };

  std::uint32_t index = 0;  ///< of the node or block; or of the element, among those of its type
  model::Tipo tipo{};       ///< the type of an element
  Kind kind = Kind::none;   ///< which of the four it is

  /// The child as an element. Precondition: kind is element.
  scene::ElementRef element() const { return {tipo, index}; }
};

/// A node of eight children and their boxes, in four cache lines.
struct alignas(64) WideNode {
  static constexpr std::size_t width = 8;            ///< children of a node
  using Entries = std::array<double, width>;         ///< the entry parameter of each child's box
  std::array<std::array<float, width>, 6> planes{};  ///< x, y, z of the low corners, then of the high corners
  std::array<WideChild, width> children{};           ///< empty children come last
};
static_assert(sizeof(WideNode) == 256);

/// The greatest number of levels of nodes. The builder splits evenly below a level, so that no tree has more.
inline constexpr std::size_t most_levels = 36;
/// The greatest number of children on a traversal stack: seven of each level, and eight of the last.
inline constexpr std::size_t most_waiting = most_levels * (WideNode::width - 1) + 1;

/// The entry parameter beyond which a box on the stack is pruned, for a limit (tmax).
inline double latest_entry(double limit) { return limit * grow + tiny; }

/// A bundle is up to 64 rays in columns that traverse the tree together. Preconditions: the rays are ordinary; no
/// component of a direction is 0; the components along an axis have one sign.
struct WidePacket {
  static constexpr std::size_t size = trace::RayColumns::size;  ///< rays at most
  static constexpr std::size_t eight = trace::Packet::size;     ///< rays that lanes test side by side
  using Column = trace::RayColumns::Column;                     ///< a number of each ray
  using Ends = std::array<double, 3>;                           ///< a number of each axis

  /// Sets a ray and its limit. The element that the ray starts on and the inverse are set elsewhere.
  void set(std::size_t place, const trace::Ray& ray, double limit_of) {
    rays.set(place, ray);
    limit[place] = limit_of;
  }

  /// Copies a ray, its start and its limit from one place to another; the inverse is not copied.
  void move(std::size_t from, std::size_t to) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      rays.p[axis][to] = rays.p[axis][from];
      rays.v[axis][to] = rays.v[axis][from];
    }
    rays.speed[to] = rays.speed[from];
    rays.start[to] = rays.start[from];
    limit[to] = limit[from];
  }

  trace::RayColumns rays;                       ///< the rays
  alignas(64) std::array<Column, 3> inverse{};  ///< the inverses of Beam, by axis
  Column limit{};                               ///< the limit (tmax) of each ray; below 0 for a ray that takes no part
  std::size_t begin = 0, end = 0;               ///< the places that traverse: whole groups of eight
  /// @{ The bounds of the rays' origins, directions and inverses, by axis.
  Ends p_low{}, p_high{}, v_low{}, v_high{}, inverse_low{}, inverse_high{};
  /// @}
};

/// Computes the inverses of the first `count` rays. Precondition: `count` is a multiple of eight.
void invert(WidePacket& bundle, std::size_t count);

/// Bounds the rays at begin … end, which are the ones that traverse from then on. False where the rays cannot share a
/// traversal, since their signs differ or an inverse is infinite; the bounds mean nothing then. Preconditions: begin
/// and end are multiples of eight; the rays' inverses are computed.
bool gather(WidePacket& bundle, std::size_t begin, std::size_t end);

/// The greatest limit of the rays that traverse, or 0 where none takes part.
double farthest(const WidePacket& bundle);

/// The children whose boxes some ray of the bundle may meet at 0 < t ≤ limit, a bit each, the first child's lowest.
/// `entries` gets a lower bound of each box's entry parameters. Rounded subtraction and multiplication are monotonic,
/// so the entry computed from the bounds of origins and inverses is no later, and the exit no earlier, than `stretch`
/// computes for any ray within the bounds (proofs/Bundles.v: bundle_entry, bundle_exit). The test therefore passes
/// wherever the test of some ray does.
unsigned met(const WideNode& node, const WidePacket& bundle, double limit, WideNode::Entries& entries);

/// A set of rays of a bundle for each child of a node, a bit for each ray.
using WideMeetings = std::array<std::uint64_t, WideNode::width>;

/// For each child in `children`, the rays that traverse and may meet its box up to their own limits, by the test of
/// `stretch`. The sets of other children mean nothing.
void met_by(const WideNode& node, unsigned children, const WidePacket& bundle, WideMeetings& met);

}  // namespace durero::accel
