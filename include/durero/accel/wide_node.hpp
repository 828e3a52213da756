#pragma once
/// A node of the wide hierarchy: the boxes of eight children in binary32, tested together.
///
/// Each test computes in binary64, to which the planes of binary32 are taken exactly, by the operations of slab.hpp in
/// their order. So what is proved of those (proofs/Slab.v: slab64_never_rejects, and entry_never_rejects of a box that
/// has waited) holds in every lane. Its conditions hold: the planes are finite, hence of magnitude below 2¹²⁸, and the
/// rays ordinary; an empty child alone has infinite planes, and no ray meets it. So a walk over such nodes loses
/// nothing (proofs/Wide.v: prunable_right, nested_leads).

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "durero/accel/slab.hpp"
#include "durero/scene/element_ref.hpp"
#include "durero/trace/packet.hpp"

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
  static constexpr std::size_t size = trace::RayColumns::size;  ///< how many rays at most
  static constexpr std::size_t eight = trace::Packet::size;     ///< rays that are tested side by side
  using Column = trace::RayColumns::Column;                     ///< a number of each ray
  using Ends = std::array<double, 3>;                           ///< a number of each axis

  /// Fills a place but for what the ray starts on.
  void set(std::size_t place, const trace::Ray& ray, double limit_of) {
    rays.set(place, ray);
    limit[place] = limit_of;
  }

  /// What stands at a place to another, but for the inverse.
  void move(std::size_t from, std::size_t to) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      rays.p[axis][to] = rays.p[axis][from];
      rays.v[axis][to] = rays.v[axis][from];
    }
    rays.speed[to] = rays.speed[from];
    rays.start[to] = rays.start[from];
    limit[to] = limit[from];
  }

  trace::RayColumns rays;                       ///< all of them
  alignas(64) std::array<Column, 3> inverse{};  ///< as in Beam, by axis
  Column limit{};                               ///< of each ray; below 0 of one that takes no part
  std::size_t begin = 0, end = 0;               ///< which places walk: whole eights
  /// @{ Between which their origins, directions and inverses lie.
  Ends p_low{}, p_high{}, v_low{}, v_high{}, inverse_low{}, inverse_high{};
  /// @}
};

/// Computes the inverses of the first rays of a bundle: of whole eights.
void invert(WideBundle& bundle, std::size_t count);

/// Makes those at begin … end, whole eights, the ones that walk. Whether they can together; if not, the ends mean
/// nothing. Precondition: their inverses are computed.
bool gather(WideBundle& bundle, std::size_t begin, std::size_t end);

/// The greatest limit of those that walk; 0 where none takes part.
double farthest(const WideBundle& bundle);

/// A bit for each child whose box some ray of the bundle may meet at 0 < t ≤ limit, the first child's lowest; `entries`
/// gets a parameter before which none enters each. Subtraction and multiplication, rounded, are monotonic: so what is
/// computed of the ends between which origins and inverses lie is no later an entry, and no earlier an exit, than what
/// `stretch` computes of any ray between them (proofs/Bundles.v: bundle_entry, bundle_exit), and the test passes
/// wherever that of some ray does.
unsigned met(const WideNode& node, const WideBundle& bundle, double limit, WideNode::Entries& entries);

/// A number for each child of a node.
using WideMeetings = std::array<std::uint64_t, WideNode::width>;

/// Of each child that has a bit, one for each place of the bundle, of those that walk, whose ray may meet its box up to
/// the ray's own limit, as `stretch` finds it. What the other children get means nothing.
void met_by(const WideNode& node, unsigned children, const WideBundle& bundle, WideMeetings& met);

}  // namespace durero::accel
