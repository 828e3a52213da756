#include "durero/accel/wide_bvh.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "durero/surface/surfaces.hpp"

namespace durero::accel {
namespace {

using Corner = std::array<float, 3>;
using ChildKind = WideChild::Kind;

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

  /// The middle of its box, about: it tells items apart, and bounds nothing. It does not overflow.
  float middle(std::size_t axis) const { return 0.5F * box.low[axis] + 0.5F * box.high[axis]; }
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

/// Where the middles of some items lie along each axis, in equal bins.
class Bins {
 public:
  static constexpr std::size_t count = 16;

  explicit Bins(std::span<const Item> items) {
    Box32 middles;
    for (const Item& item : items)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        middles.low[axis] = std::min(middles.low[axis], item.middle(axis));
        middles.high[axis] = std::max(middles.high[axis], item.middle(axis));
      }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low_[axis] = middles.low[axis];
      const float scale = count * (1 - 0x1p-18F) / (middles.high[axis] - middles.low[axis]);
      scale_[axis] = std::isfinite(scale) ? scale : 0;
    }
  }
  /// Whether the middles differ along an axis, by more than next to nothing and less than overflows.
  bool differ(std::size_t axis) const { return scale_[axis] > 0; }
  /// In which bin of the axis the item is.
  std::size_t of(const Item& item, std::size_t axis) const {
    if (!differ(axis)) return 0;
    const auto bin = static_cast<std::size_t>((item.middle(axis) - low_[axis]) * scale_[axis]);
    return std::min(bin, count - 1);
  }

 private:
  std::array<float, 3> low_{}, scale_{};
};

/// A bin of an axis: how many items, and their box.
struct Bin {
  Box32 box;
  std::size_t count = 0;

  void join(const Bin& other) {
    box.join(other.box);
    count += other.count;
  }
  double cost() const { return count == 0 ? HUGE_VAL : box.area() * static_cast<double>(count); }
};
using Row = std::array<Bin, Bins::count>;

/// A way to part items by the bins of an axis: the first `bin` of them from the rest.
struct Split {
  double cost = HUGE_VAL;  ///< the sum of area times number; ∞ where there is no way
  std::size_t axis = 0, bin = 0;
  Bin first{}, second{};
};

void keep_best(Split& best, const Row& row, std::size_t axis) {
  Row first;  // of the bins before each
  for (std::size_t bin = 1; bin < Bins::count; ++bin) {
    first[bin] = first[bin - 1];
    first[bin].join(row[bin - 1]);
  }
  Bin second;
  for (std::size_t bin = Bins::count - 1; bin > 0; --bin) {
    second.join(row[bin]);
    const double cost = first[bin].cost() + second.cost();
    if (cost < best.cost) best = {cost, axis, bin, first[bin], second};
  }
}

std::pair<Part, Part> in_the_middle(Items items) {
  const Items first = items.first(items.size() / 2), second = items.subspan(items.size() / 2);
  return {{first, box_of(first)}, {second, box_of(second)}};
}

/// The items in two, neither empty: where the surface areas promise least work; in the middle where the middles of all
/// boxes are one, or where nothing but the depth matters any more. Precondition: two items or more.
std::pair<Part, Part> split(Items items, bool evenly) {
  if (evenly) return in_the_middle(items);
  const Bins bins(items);
  std::array<Row, 3> rows;
  for (const Item& item : items)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Bin& bin = rows[axis][bins.of(item, axis)];
      bin.box.join(item.box);
      ++bin.count;
    }
  Split best;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (bins.differ(axis)) keep_best(best, rows[axis], axis);
  if (best.bin == 0) return in_the_middle(items);
  std::ranges::partition(items, [&](const Item& item) { return bins.of(item, best.axis) < best.bin; });
  return {{items.first(best.first.count), best.first.box}, {items.subspan(best.first.count), best.second.box}};
}

/// The greatest of some parts by rank(part), of which 0 takes none; null where all take none.
template <class Rank>
Part* greatest(std::vector<Part>& parts, Rank rank) {
  const auto found = std::ranges::max_element(parts, {}, rank);
  return rank(*found) > 0 ? &*found : nullptr;
}

/// Eight parts of a part or fewer, none empty: the one with the greatest surface is split again and again, or where
/// `evenly` that of most items, until none is left that a node could not hold; then such as fit go to their items.
std::vector<Part> parts_of(const Part& whole, bool evenly) {
  constexpr std::size_t width = WideNode::width;
  std::vector<Part> parts;
  parts.reserve(width);
  parts.push_back(whole);
  const auto too_large = [&](const Part& part) {
    if (part.items.size() <= width) return 0.0;
    return evenly ? static_cast<double>(part.items.size()) : part.area + 0x1p-1000;
  };
  while (parts.size() < width) {
    Part* const largest = greatest(parts, too_large);
    if (largest == nullptr) break;
    auto [first, second] = split(largest->items, evenly);
    *largest = first;
    parts.push_back(second);
  }
  const auto fits = [&](const Part& part) {
    const std::size_t n = part.items.size();
    return n > 1 && parts.size() + n - 1 <= width ? part.area + 0x1p-1000 : 0.0;
  };
  while (Part* const fitting = greatest(parts, fits)) {
    const Items items = fitting->items;
    *fitting = {items.first(1), items[0].box};
    for (std::size_t i = 1; i < items.size(); ++i) parts.push_back({items.subspan(i, 1), items[i].box});
  }
  return parts;
}

/// Beyond this level a node parts its items evenly, so that 2³² of them take eleven levels more.
constexpr std::size_t last_level_by_area = most_levels - 12;
/// Above this number the parts of a node are built by several threads.
constexpr std::size_t alone = 4096;

void build(std::vector<WideNode>& nodes, const Part& whole, std::size_t level);

void place(WideNode& node, std::size_t at, const Part& part) {
  for (std::size_t i = 0; i < 3; ++i) {
    node.planes[i][at] = part.box.low[i];
    node.planes[i + 3][at] = part.box.high[i];
  }
  const scene::ElementRef e = part.items[0].e;
  if (part.items.size() == 1) node.children[at] = {e.index, e.tipo, ChildKind::element};
}

/// The trees of the parts that are more than an element, each as if it stood alone.
std::vector<std::vector<WideNode>> built_apart(std::span<const Part> parts, std::size_t level) {
  std::vector<std::vector<WideNode>> trees(parts.size());
  oneapi::tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t i) {
    if (parts[i].items.size() > 1) build(trees[i], parts[i], level + 1);
  });
  return trees;
}

void append(std::vector<WideNode>& nodes, const std::vector<WideNode>& tree) {
  const auto before = static_cast<std::uint32_t>(nodes.size());
  nodes.insert(nodes.end(), tree.begin(), tree.end());
  for (WideNode& node : std::span(nodes).subspan(before))
    for (WideChild& child : node.children)
      if (child.kind == ChildKind::node) child.index += before;
}

/// Appends the node of a part, and all below it.
void build(std::vector<WideNode>& nodes, const Part& whole, std::size_t level) {
  const std::vector<Part> parts = parts_of(whole, level > last_level_by_area);
  const std::size_t own = nodes.size();
  nodes.emplace_back();
  for (std::size_t plane = 0; plane < 6; ++plane) nodes[own].planes[plane].fill(plane < 3 ? HUGE_VALF : -HUGE_VALF);
  for (std::size_t i = 0; i < parts.size(); ++i) place(nodes[own], i, parts[i]);
  std::vector<std::vector<WideNode>> trees;
  if (whole.items.size() > alone) trees = built_apart(parts, level);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].items.size() == 1) continue;
    nodes[own].children[i] = {static_cast<std::uint32_t>(nodes.size()), {}, ChildKind::node};
    if (trees.empty()) {
      build(nodes, parts[i], level + 1);
    } else {
      append(nodes, trees[i]);
      trees[i] = {};
    }
  }
}

std::size_t depth(std::span<const WideNode> nodes, std::size_t at) {
  std::size_t deepest = 0;
  for (const WideChild& child : nodes[at].children)
    if (child.kind == ChildKind::node) deepest = std::max(deepest, depth(nodes, child.index));
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
  if (!items.empty()) {
    const Box32 all = box_of(items);
    const double extent = std::max({all.width(0), all.width(1), all.width(2)});
    spacing_ = extent / std::cbrt(static_cast<double>(items.size()));
    std::vector<WideNode> nodes;
    build(nodes, {items, all}, 0);
    nodes_.assign(nodes.begin(), nodes.end());
  }
  leaves_.reserve(scene);
  for (WideNode& node : nodes_)
    for (WideChild& child : node.children)
      if (child.kind == ChildKind::element) child.index = leaves_.push_back(scene, child.element()).index;
  for (const scene::ElementRef e : unbounded_) unbounded_leaves_.push_back(leaves_.push_back(scene, e));
}

Size WideBvh::size() const {
  Size size;
  for (const WideNode& node : nodes_)
    for (const WideChild& child : node.children) size.cells += child.kind == ChildKind::element;
  size.elements = size.references = size.cells;
  size.apart = unbounded_.size() + extraordinary_.size();
  size.nodes = nodes_.size();
  size.depth = nodes_.empty() ? 0 : depth(nodes_, 0);
  size.bytes =
      sizeof *this + nodes_.capacity() * sizeof(WideNode) +
      (unbounded_.capacity() + unbounded_leaves_.capacity() + extraordinary_.capacity()) * sizeof(scene::ElementRef);
  size.bytes += leaves_.bytes();
  return size;
}

}  // namespace durero::accel
