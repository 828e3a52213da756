#pragma once
/// Which elements come into the same child of a node of the wide hierarchy.

#include <algorithm>
#include <array>
#include <boost/container/static_vector.hpp>
#include <cmath>
#include <span>

#include "durero/accel/wide_node.hpp"

namespace durero::accel::wide {

using Corner = std::array<float, 3>;

/// A box of binary32; that of nothing holds no point, and joined to another leaves it as it is.
struct Box32 {
  Corner low{HUGE_VALF, HUGE_VALF, HUGE_VALF}, high{-HUGE_VALF, -HUGE_VALF, -HUGE_VALF};

  void join(const Box32& other) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], other.low[i]);
      high[i] = std::max(high[i], other.high[i]);
    }
  }
  /// Half the area of its surface; of nothing, 0. In binary64 none overflows.
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

/// An element and its box.
struct Item {
  Box32 box;
  scene::ElementRef e;
};
using Items = std::span<Item>;

/// Some items, room for as many, to which they come when they are parted, and their box.
struct Part {
  Items items, room;
  Box32 box;
  Box32 middles;  ///< the box of the middles of their boxes
  double area = box.area();

  std::size_t size() const { return items.size(); }
  bool is_item() const { return items.size() == 1; }
};

/// Precondition: as much room as items, elsewhere.
Part part_of(Items items, Items room);

/// The parts of a node.
using Parts = boost::container::static_vector<Part, WideNode::width>;

/// Eight parts of a part or fewer, none empty: the one with the greatest surface is split again and again, or where
/// `evenly` that of most items, until none is left that a node could not hold; then such as fit go to their items.
Parts parts_of(const Part& whole, bool evenly);

}  // namespace durero::accel::wide
