#pragma once
/// One ray on its way through the wide hierarchy, nearest box first.

#include <array>
#include <cstdint>

#include "durero/accel/wide_node.hpp"

namespace durero::accel {

/// A ray, and the children that it has still to visit. It can be left and taken up again.
struct WideWalker {
  /// What a walk has come to: an element to be tested; a node that lies open; or its end.
  enum class Next : std::uint8_t { element, node, end };
  /// Whether a walk goes on until it finds an element, or stops at each node, which gives memory time to come.
  enum class Pace : std::uint8_t { steady, by_nodes };

  static constexpr std::size_t room = most_waiting + WideNode::width;  ///< of the columns; whole lanes are stored

  /// Starts at the root. Precondition: the ray is ordinary.
  explicit WideWalker(const trace::Ray& ray) : beam(ray) { restart(ray); }
  /// The same with another ray.
  void restart(const trace::Ray& ray);

  /// Goes on, past all that lies beyond the limit. Precondition: the limit is not less than 0.
  Next advance(const WideNode* nodes, double limit, Pace pace);

  Beam beam;                    ///< the ray
  scene::ElementRef element{};  ///< the last that it came to
  std::uint32_t size = 0;       ///< how many children wait, the next one last
  /// @{ Counted on the way, for any number of rays.
  std::uint32_t nodes = 0;  ///< that were opened
  std::uint32_t met = 0;    ///< boxes of them that were met
  std::uint32_t late = 0;   ///< children that the limit had fallen below
  /// @}
  std::array<double, room> entries;          ///< of the children that wait
  std::array<std::uint64_t, room> children;  ///< they themselves
};

}  // namespace durero::accel
