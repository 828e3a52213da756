#include "durero/accel/wide_bvh.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "durero/surface/surfaces.hpp"

namespace durero::accel {
namespace {

using Corner = std::array<float, 3>;
using Kind = WideChild::Kind;

/// The greatest number of binary32 that is not above x, and the least that is not below it.
float below(double x) {
  const auto nearest = static_cast<float>(x);
  return static_cast<double>(nearest) > x ? std::nextafterf(nearest, -HUGE_VALF) : nearest;
}
float above(double x) { return -below(-x); }

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

/// Rounded outwards: it holds all points of the other.
Box32 outwards(const surface::Box& box) {
  return {{below(box.low.x), below(box.low.y), below(box.low.z)},
          {above(box.high.x), above(box.high.y), above(box.high.z)}};
}

struct Item {
  Box32 box;
  scene::ElementRef e;

  /// Twice the middle of its box.
  double middle(std::size_t axis) const {
    return static_cast<double>(box.low[axis]) + static_cast<double>(box.high[axis]);
  }
};
using Items = std::span<Item>;

Box32 box_of(std::span<const Item> items) {
  Box32 box;
  for (const Item& item : items) box.join(item.box);
  return box;
}

/// Some items and their box.
struct Part {
  Items items;
  Box32 box;
  double area = box.area();
};

/// Where the middles of some items lie along an axis, in equal bins.
class Bins {
 public:
  static constexpr std::size_t count = 16;

  Bins(std::span<const Item> items, std::size_t axis) : axis_(axis) {
    const auto [least, greatest] = std::ranges::minmax(
        items, {}, [axis](const Item& item) { return item.middle(axis); });
    low_ = least.middle(axis);
    const double width = greatest.middle(axis) - low_;
    scale_ = width > 0 ? count * (1 - 0x1p-20) / width : 0;
  }
  /// Whether the middles differ.
  bool differ() const { return scale_ > 0; }
  /// In which bin the item is.
  std::size_t of(const Item& item) const {
    return std::min(static_cast<std::size_t>((item.middle(axis_) - low_) * scale_), count - 1);
  }
  std::size_t axis() const { return axis_; }

 private:
  std::size_t axis_;
  double low_ = 0, scale_ = 0;
};

/// The best way to part items by the bins of an axis: the first `bin` of them from the rest.
struct Split {
  double cost = HUGE_VAL;  ///< the sum of area times number; ∞ where there is no way
  std::size_t bin = 0;
};

Split best_split(std::span<const Item> items, const Bins& bins) {
  std::array<Box32, Bins::count> boxes;
  std::array<std::size_t, Bins::count> counts{};
  for (const Item& item : items) {
    const std::size_t bin = bins.of(item);
    boxes[bin].join(item.box);
    ++counts[bin];
  }
  std::array<double, Bins::count> below_cost{};
  Box32 box;
  std::size_t count = 0;
  for (std::size_t bin = 0; bin + 1 < Bins::count; ++bin) {
    box.join(boxes[bin]);
    count += counts[bin];
    below_cost[bin + 1] = count == 0 ? HUGE_VAL : box.area() * static_cast<double>(count);
  }
  Split best;
  box = {};
  count = 0;
  for (std::size_t bin = Bins::count - 1; bin > 0; --bin) {
    box.join(boxes[bin]);
    count += counts[bin];
    const double cost = below_cost[bin] + box.area() * static_cast<double>(count);
    if (count > 0 && cost < best.cost) best = {cost, bin};
  }
  return best;
}

/// The items in two, neither empty: where the surface areas promise least work; in the middle where the middles of all
/// boxes are one, or where nothing but the depth matters any more. Precondition: two items or more.
std::size_t split(Items items, bool evenly) {
  if (!evenly) {
    Split best;
    std::size_t axis = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Bins bins(items, i);
      if (!bins.differ()) continue;
      const Split found = best_split(items, bins);
      if (found.cost < best.cost) best = found, axis = i;
    }
    if (best.bin > 0) {
      const Bins bins(items, axis);
      const auto rest = std::ranges::partition(items, [&](const Item& item) { return bins.of(item) < best.bin; });
      return items.size() - rest.size();
    }
  }
  return items.size() / 2;
}

/// Eight parts of the items or fewer, none empty: again and again the part with the greatest surface is split, those
/// first that a node cannot hold. Where `evenly`, the one of most items is.
std::vector<Part> parts_of(Items items, bool evenly) {
  std::vector<Part> parts;
  parts.reserve(WideNode::width);
  parts.push_back({items, box_of(items)});
  while (parts.size() < WideNode::width) {
    const auto rank = [evenly](const Part& part) {
      const std::size_t n = part.items.size();
      return n == 1 ? std::pair(0, 0.0) : std::pair(n > WideNode::width ? 2 : 1, evenly ? double(n) : part.area);
    };
    Part& largest = *std::ranges::max_element(parts, {}, rank);
    if (largest.items.size() == 1) break;
    const Items all = largest.items;
    const std::size_t half = split(all, evenly);
    const Items first = all.first(half), second = all.subspan(half);
    largest = {first, box_of(first)};
    parts.push_back({second, box_of(second)});
  }
  return parts;
}

/// Beyond this level a node parts its items evenly, so that 2³² of them take eleven levels more.
constexpr std::size_t last_level_by_area = WideStack::most_levels - 12;
/// Above this number the parts of a node are built by several threads.
constexpr std::size_t alone = 4096;

void build(std::vector<WideNode>& nodes, Items items, std::size_t level);

void place(WideNode& node, std::size_t at, const Part& part) {
  for (std::size_t i = 0; i < 3; ++i) {
    node.planes[i][at] = part.box.low[i];
    node.planes[i + 3][at] = part.box.high[i];
  }
  const scene::ElementRef e = part.items[0].e;
  if (part.items.size() == 1) node.children[at] = {e.index, e.tipo, Kind::element};
}

/// The trees of the parts that are more than an element, each as if it stood alone.
std::vector<std::vector<WideNode>> built_apart(std::span<const Part> parts, std::size_t level) {
  std::vector<std::vector<WideNode>> trees(parts.size());
  oneapi::tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t i) {
    if (parts[i].items.size() > 1) build(trees[i], parts[i].items, level + 1);
  });
  return trees;
}

void append(std::vector<WideNode>& nodes, const std::vector<WideNode>& tree) {
  const auto before = static_cast<std::uint32_t>(nodes.size());
  nodes.insert(nodes.end(), tree.begin(), tree.end());
  for (WideNode& node : std::span(nodes).subspan(before))
    for (WideChild& child : node.children)
      if (child.kind == Kind::node) child.index += before;
}

/// Appends the node of the items, and all below it.
void build(std::vector<WideNode>& nodes, Items items, std::size_t level) {
  const std::vector<Part> parts = parts_of(items, level > last_level_by_area);
  const std::size_t own = nodes.size();
  nodes.emplace_back();
  for (std::size_t plane = 0; plane < 6; ++plane) nodes[own].planes[plane].fill(plane < 3 ? HUGE_VALF : -HUGE_VALF);
  for (std::size_t i = 0; i < parts.size(); ++i) place(nodes[own], i, parts[i]);
  std::vector<std::vector<WideNode>> trees;
  if (items.size() > alone) trees = built_apart(parts, level);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].items.size() == 1) continue;
    nodes[own].children[i] = {static_cast<std::uint32_t>(nodes.size()), {}, Kind::node};
    if (trees.empty()) {
      build(nodes, parts[i].items, level + 1);
    } else {
      append(nodes, trees[i]);
      trees[i] = {};
    }
  }
}

std::size_t depth(std::span<const WideNode> nodes, std::size_t at) {
  std::size_t deepest = 0;
  for (const WideChild& child : nodes[at].children)
    if (child.kind == Kind::node) deepest = std::max(deepest, depth(nodes, child.index));
  return deepest + 1;
}

}  // namespace

WideBvh::WideBvh(const scene::Scene& scene) : scene_(&scene) {
  std::vector<Item> items;
  items.reserve(scene.size());
  scene.for_each([&](scene::ElementRef e, const auto& shape) {
    if (!trace::ordinary(shape)) return extraordinary_.push_back(e);
    const Box32 box = outwards(surface::box(shape));
    if (!box.finite()) return unbounded_.push_back(e);
    items.push_back({box, e});
  });
  if (items.empty()) return;
  const Box32 all = box_of(items);
  const double extent = std::max({all.width(0), all.width(1), all.width(2)});
  spacing_ = extent / std::cbrt(static_cast<double>(items.size()));
  build(nodes_, items, 0);
  nodes_.shrink_to_fit();
}

Size WideBvh::size() const {
  Size size;
  for (const WideNode& node : nodes_)
    for (const WideChild& child : node.children) size.cells += child.kind == Kind::element;
  size.elements = size.references = size.cells;
  size.apart = unbounded_.size() + extraordinary_.size();
  size.nodes = nodes_.size();
  size.depth = nodes_.empty() ? 0 : depth(nodes_, 0);
  size.bytes = sizeof *this + nodes_.capacity() * sizeof(WideNode) +
               (unbounded_.capacity() + extraordinary_.capacity()) * sizeof(scene::ElementRef);
  return size;
}

}  // namespace durero::accel
