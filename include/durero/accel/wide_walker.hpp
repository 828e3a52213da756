#pragma once
/// One ray on its way through the wide hierarchy, nearest box first; or several that open their nodes side by side.

#include <array>
#include <bit>
#include <cstdint>
#include <span>

#include "durero/accel/wide_node.hpp"

namespace durero::accel {

/// A ray, and the children that it has still to visit. It can be left and taken up again.
struct WideWalker {
  /// What a walk has come to: an element to be tested; a node to be opened; or its end.
  enum class Next : std::uint8_t { element, node, end };

  static constexpr std::size_t room = most_waiting + WideNode::width;  ///< of the columns; whole lanes are stored

  /// Starts at the root. Precondition: the ray is ordinary.
  explicit WideWalker(const trace::Ray& ray) : beam(ray) { restart(ray); }
  /// The same with another ray.
  void restart(const trace::Ray& ray);

  /// Goes on to the next child, past all that lies beyond the limit, which is kept. Precondition: the limit is not less
  /// than 0, and the node that it came to last, if any, was opened.
  Next next(double greatest) {
    limit = greatest;
    const double latest = latest_entry(limit);
    while (size > 0) {
      if (entries[--size] > latest) {
        ++late;
        continue;
      }
      const auto child = std::bit_cast<WideChild>(children[size]);
      if (child.kind == WideChild::Kind::element) {
        element = child.element();
        return Next::element;
      }
      node = child.index;
      return Next::node;
    }
    return Next::end;
  }
  /// The same, opening what it comes to until that is an element: never a node.
  Next advance(const WideNode* nodes, double greatest);

  Beam beam;                    ///< the ray
  double limit = 0;             ///< beyond which nothing matters
  scene::ElementRef element{};  ///< the last that it came to
  std::uint32_t node = 0;       ///< the last that it came to
  std::uint32_t size = 0;       ///< how many children wait, the next one last
  std::uint32_t sorted = 0;     ///< how many of them are in order, while the last node lies open
  /// @{ Counted on the way, for any number of rays.
  std::uint32_t nodes = 0;  ///< that were opened
  std::uint32_t met = 0;    ///< boxes of them that were met
  std::uint32_t late = 0;   ///< children that the limit had fallen below
  /// @}
  std::array<double, room> entries;          ///< of the children that wait
  std::array<std::uint64_t, room> children;  ///< they themselves
};

/// Opens the nodes that some walkers have come to. First the boxes of all are tested, without a branch, so that the
/// tests of one need not wait for what another's come to; then what each met is put in order.
void open(const WideNode* nodes, std::span<WideWalker* const> walkers);

}  // namespace durero::accel
