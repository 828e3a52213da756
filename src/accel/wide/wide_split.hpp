#pragma once
/// Splits the elements among the children of a wide node.

#include <algorithm>
#include <array>
#include <boost/container/static_vector.hpp>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "durero/accel/wide/wide_node.hpp"
#include "durero/trace/triangle_block.hpp"

namespace durero::accel::wide {

using Corner = std::array<float, 3>;

/// A box of binary32. The empty box has low above high, and is neutral to join.
struct Box32 {
  Corner low{HUGE_VALF, HUGE_VALF, HUGE_VALF}, high{-HUGE_VALF, -HUGE_VALF, -HUGE_VALF};

  void join(const Box32& other) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], other.low[i]);
      high[i] = std::max(high[i], other.high[i]);
    }
  }
  /// Half the surface area, or 0 for the empty box. It is computed in binary64, which does not overflow.
  double area() const {
    const double x = width(0), y = width(1), z = width(2);
    return x < 0 ? 0 : x * y + y * z + z * x;
  }
  double width(std::size_t axis) const { return static_cast<double>(high[axis]) - static_cast<double>(low[axis]); }
  bool finite() const {
    return std::ranges::all_of(low, [](float x) { return std::isfinite(x); }) &&
           std::ranges::all_of(high, [](float x) { return std::isfinite(x); });
  }
};

/// An element and its box, which the builder sorts. It is read as one vector.
struct alignas(32) Item {
  Item() = default;
  Item(const Box32& box, scene::ElementRef e, bool is_single)
      : low(box.low),
        index(e.index),
        minus_high{-box.high[0], -box.high[1], -box.high[2]},
        tipo(e.tipo),
        single(is_single) {}

  Corner low;           ///< of the box
  std::uint32_t index;  ///< of the element, among those of its type
  Corner minus_high;    ///< of the box, each coordinate with its sign turned
  model::Tipo tipo;     ///< the element's type
  bool single;          ///< the element is a triangle that fits into a block (trace/triangle_block.hpp)
};
static_assert(sizeof(Item) == 32);
using Items = std::span<Item>;

/// A subtree's items, as much room to partition them into, and their box.
struct ItemRange {
  Items items, room;
  Box32 box;
  Box32 middles;  ///< the box of the centres of the items' boxes
  double area = box.area();

  std::size_t size() const { return items.size(); }
  bool is_item() const { return items.size() == 1; }
  /// Whether the items are several triangles that fit into one block.
  bool is_block() const {
    return size() > 1 && size() <= trace::TriangleBlock::size && std::ranges::all_of(items, &Item::single);
  }
};

/// Bounds some items. Precondition: `room` has as many places as `items`, and does not overlap them.
ItemRange part_of(Items items, Items room);

/// The children of a node, as parts.
using Parts = boost::container::static_vector<ItemRange, WideNode::width>;

/// Splits a part of more than `few` items into at most eight parts, none empty, for the children of a node. The part of
/// greatest surface is split again and again, or of most items where `evenly`, until there are eight.
Parts parts_of(const ItemRange& whole, bool evenly);

/// The splits of a part of few items, down to the leaves of the tree. Nodes over them are full where they can be, as
/// the number of leaves below each part is known before its node is made: few bytes, and few nodes for a ray.
class SplitTree {
 public:
  static constexpr std::size_t few = 512;  ///< items at most

  /// Splits by surface area on so many levels, and evenly below. Precondition: few items at most, and one at least.
  SplitTree(const ItemRange& whole, std::size_t levels_by_area);

  /// A number of a part; the whole has 0.
  using Number = std::uint32_t;
  /// The part of a number.
  const ItemRange& part(Number number) const { return branches_[number].part; }
  /// The children of the node over a part: its halves, one of which is opened again and again. Parts of more leaves
  /// than a node holds come first, the one of greatest surface first, and then parts whose leaves all fit.
  boost::container::static_vector<Number, WideNode::width> children(Number number) const;

 private:
  /// A part, its leaves, and what it is opened into: halves, or the items of a part that fits a node.
  struct Branch {
    ItemRange part;
    std::size_t leaves = 1;
    Number first = 0, count = 0;
  };

  void open(Number number, std::size_t levels_by_area);

  std::vector<Branch> branches_;
};

}  // namespace durero::accel::wide
