#include "durero/accel/wide/wide_bvh.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "accel/wide/wide_split.hpp"
#include "durero/surface/surfaces.hpp"
#include "durero/trace/few.hpp"

namespace durero::accel {

static_assert(trace::FewCandidates<WideBvh>);

namespace {

using ChildKind = WideChild::Kind;
using wide::Box32;
using wide::Item;
using wide::ItemRange;

/// The greatest binary32 number not above x, and the least not below it. The nearest number is stepped by its bits,
/// which count away from 0 within a sign. The step has no branch, which would be mispredicted every other time.
float below(double x) {
  const auto nearest = static_cast<float>(x);
  const auto bits = std::bit_cast<std::int32_t>(nearest);
  const std::int32_t step = bits < 0 ? 1 : -1;
  return std::bit_cast<float>(bits + (static_cast<double>(nearest) > x ? step : 0));
}
float above(double x) { return -below(-x); }

/// A box of binary32 that holds every point of a box of binary64.
Box32 outwards(const surface::Box& box) {
  return {{below(box.low.x), below(box.low.y), below(box.low.z)},
          {above(box.high.x), above(box.high.y), above(box.high.z)}};
}

/// The last level that splits by surface area. Deeper nodes split evenly, so that 2³² items take eight levels more down
/// to few, and these four.
constexpr std::size_t last_level_by_area = most_levels - 13;
/// The most triangles of a scene for which blocks have names enough. A triangle takes three units at most, of one in a
/// block of two that share no point; a name has 28 bits for the index of a block.
constexpr std::size_t most_in_blocks = (std::size_t{1} << 28) / 3;
/// The greatest part that one thread builds alone.
constexpr std::size_t alone = 4096;

using Units = std::vector<LeafColumns::BlockUnit>;

/// A tree in one of two forms: all nodes, each before its children, whose indices count from the tree's first node; or,
/// of a large tree, the root alone and the trees below it, in the order of its children.
struct Tree {
  std::vector<WideNode> nodes;
  Units units;  // the blocks of the nodes, in the order of the nodes
  std::vector<Tree> below;

  /// The nodes and the units of all.
  std::pair<std::size_t, std::size_t> size() const {
    std::pair sum(nodes.size(), units.size());
    for (const Tree& tree : below) {
      const auto [more_nodes, more_units] = tree.size();
      sum.first += more_nodes, sum.second += more_units;
    }
    return sum;
  }
};

/// The child that a part becomes. The index of a node is set later. A block is written to `units`.
WideChild child_of(const ItemRange& part, const scene::Triangles& triangles, Units& units) {
  if (part.is_item()) return {part.items[0].index, part.items[0].tipo, ChildKind::element};
  if (!part.is_block()) return {0, {}, ChildKind::node};
  const auto index = static_cast<std::uint32_t>(units.size());
  trace::BlockBuilder block;
  for (const Item& item : part.items) block.push_back(triangles[item.index], item.index);
  block.append_to(units);
  return {index, {}, ChildKind::block};
}

/// The node of some parts.
WideNode node_of(const wide::Parts& parts, const scene::Triangles& triangles, Units& units) {
  WideNode node;
  for (std::size_t plane = 0; plane < 6; ++plane) node.planes[plane].fill(plane < 3 ? HUGE_VALF : -HUGE_VALF);
  for (std::size_t at = 0; at < parts.size(); ++at) {
    const ItemRange& part = parts[at];
    for (std::size_t i = 0; i < 3; ++i) {
      node.planes[i][at] = part.box.low[i];
      node.planes[i + 3][at] = part.box.high[i];
    }
    node.children[at] = child_of(part, triangles, units);
  }
  return node;
}

/// Appends the nodes of the tree over a part of few items: its root, then all below.
void build_few(Tree& tree, const wide::SplitTree& splits, wide::SplitTree::Number whole,
               const scene::Triangles& triangles) {
  const auto numbers = splits.children(whole);
  wide::Parts parts;
  for (const auto number : numbers) parts.push_back(splits.part(number));
  const std::size_t own = tree.nodes.size();
  tree.nodes.push_back(node_of(parts, triangles, tree.units));
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (tree.nodes[own].children[i].kind != ChildKind::node) continue;
    tree.nodes[own].children[i].index = static_cast<std::uint32_t>(tree.nodes.size());
    build_few(tree, splits, numbers[i], triangles);
  }
}

/// Appends the nodes of the tree over a part: its root, then all below.
void build(Tree& tree, const ItemRange& whole, const scene::Triangles& triangles, std::size_t level) {
  if (whole.size() <= wide::SplitTree::few) {
    const wide::SplitTree splits(whole, last_level_by_area - std::min(level, last_level_by_area));
    return build_few(tree, splits, 0, triangles);
  }
  const wide::Parts parts = parts_of(whole, level > last_level_by_area);
  std::vector<WideNode>& nodes = tree.nodes;
  const std::size_t own = nodes.size();
  nodes.push_back(node_of(parts, triangles, tree.units));
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (nodes[own].children[i].kind != ChildKind::node) continue;
    nodes[own].children[i].index = static_cast<std::uint32_t>(nodes.size());
    build(tree, parts[i], triangles, level + 1);
  }
}

/// The tree over a part. The parts of a large node are built in parallel.
Tree built(const ItemRange& whole, const scene::Triangles& triangles, std::size_t level) {
  Tree tree;
  if (whole.size() <= alone) {
    tree.nodes.reserve(whole.size() / 4);
    build(tree, whole, triangles, level);
    return tree;
  }
  wide::Parts parts = parts_of(whole, level > last_level_by_area);
  tree.nodes.push_back(node_of(parts, triangles, tree.units));
  const auto is_leaf = [](const ItemRange& part) { return part.is_item() || part.is_block(); };
  parts.erase(std::remove_if(parts.begin(), parts.end(), is_leaf), parts.end());
  tree.below.resize(parts.size());
  oneapi::tbb::parallel_for(std::size_t{0}, parts.size(),
                            [&](std::size_t i) { tree.below[i] = built(parts[i], triangles, level + 1); });
  return tree;
}

void append(LargeVector<WideNode>& nodes, LargeVector<LeafColumns::BlockUnit>& units, const Tree& tree) {
  const auto before = static_cast<std::uint32_t>(nodes.size()), units_before = static_cast<std::uint32_t>(units.size());
  units.insert(units.end(), tree.units.begin(), tree.units.end());
  nodes.insert(nodes.end(), tree.nodes.begin(), tree.nodes.end());
  for (WideNode& node : std::span(nodes).subspan(before))
    for (WideChild& child : node.children)
      if (child.kind == ChildKind::node) {
        child.index += before;
      } else if (child.kind == ChildKind::block) {
        child.index += units_before;
      }
  auto below = tree.below.begin();
  for (std::size_t at = 0; below != tree.below.end(); ++at) {
    WideChild& child = nodes[before].children[at];
    if (child.kind != ChildKind::node) continue;
    child.index = static_cast<std::uint32_t>(nodes.size());
    append(nodes, units, *below++);
  }
}

/// The distance in nodes at which elements are prefetched, because they lie anywhere in the scene's tables.
constexpr std::size_t nodes_ahead = 4;

void ask_for_elements(const scene::Scene& scene, const WideNode& node) {
  for (const WideChild& child : node.children)
    if (child.kind == ChildKind::element)
      trace::ask_for(
          scene.visit(child.element(), [](const auto& shape) { return std::as_bytes(std::span(&shape, 1)); }));
}

bool fits_block(const scene::Triangle& triangle) { return trace::is_single(triangle); }
template <class Shape>
bool fits_block(const Shape&) {
  return false;
}

std::size_t depth(std::span<const WideNode> nodes, std::size_t at) {
  std::size_t deepest = 0;
  for (const WideChild& child : nodes[at].children)
    if (child.kind == ChildKind::node) deepest = std::max(deepest, depth(nodes, child.index));
  return deepest + 1;
}

}  // namespace

WideBvh::WideBvh(const scene::Scene& scene) : scene_(&scene) {
  const scene::Triangles triangles = scene.shapes<scene::Triangle>();
  const bool fit = triangles.size() <= most_in_blocks;
  LargeVector<LeafColumns::BlockUnit> units;
  LargeVector<Item> items;
  items.reserve(scene.size());
  scene.for_each([&](scene::ElementRef e, const auto& shape) {
    if (!trace::ordinary(shape)) return extraordinary_.push_back(e);
    const Box32 box = outwards(surface::box(shape));
    if (!box.finite()) return unbounded_.push_back(e);
    items.push_back({box, e, fit && fits_block(shape)});
  });
  if (!items.empty()) {
    LargeVector<Item> room(items.size());
    const ItemRange all = wide::part_of(items, room);
    const double extent = std::max({all.box.width(0), all.box.width(1), all.box.width(2)});
    spacing_ = extent / std::cbrt(static_cast<double>(items.size()));
    for (std::size_t axis = 0; axis < 3; ++axis) all_[axis] = {all.box.low[axis], all.box.high[axis]};
    const Tree tree = built(all, triangles, 0);
    const auto [node_count, unit_count] = tree.size();
    nodes_.reserve(node_count);
    if (unit_count > 0) units.reserve(unit_count + trace::TriangleBlock::room);
    append(nodes_, units, tree);
    if (unit_count > 0) units.resize(unit_count + trace::TriangleBlock::room);
  }
  leaves_.reserve(scene, std::move(units));
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (i + nodes_ahead < nodes_.size()) ask_for_elements(scene, nodes_[i + nodes_ahead]);
    for (WideChild& child : nodes_[i].children)
      if (child.kind == ChildKind::element) child.index = leaves_.push_back(scene, child.element()).index;
  }
  for (const scene::ElementRef e : unbounded_) every_rays_leaves_.push_back(leaves_.push_back(scene, e));
  if (nodes_.size() == 1)
    for (const WideChild& child : nodes_[0].children) {
      if (child.kind == ChildKind::element) every_rays_leaves_.push_back(child.element());
      if (child.kind != ChildKind::block) continue;
      const scene::ElementRef first = LeafColumns::first_of(child.index);
      for (std::uint32_t lane = 0; lane < leaves_.blocks()[child.index].count(); ++lane)
        every_rays_leaves_.push_back({first.tipo, first.index + lane});
    }
  const auto fits = [](const Range32& planes) { return double{planes.size()} <= trace::SingleRays::range; };
  in_range_ = !nodes_.empty() && std::ranges::all_of(all_, fits);
  is_mesh_ = in_range_ && mostly_in_blocks();
}

bool WideBvh::mostly_in_blocks() const {
  std::size_t alone = 0, blocks = 0;
  for (const WideNode& node : nodes_) {
    alone += static_cast<std::size_t>(std::ranges::count(node.children, ChildKind::element, &WideChild::kind));
    blocks += static_cast<std::size_t>(std::ranges::count(node.children, ChildKind::block, &WideChild::kind));
  }
  return 16 * alone <= blocks && unbounded_.empty() && extraordinary_.empty();
}

Size WideBvh::size() const {
  Size size;
  for (const WideNode& node : nodes_)
    for (const WideChild& child : node.children) size.cells += child.kind == ChildKind::element;
  leaves_.blocks().for_each([&](std::uint32_t, const trace::TriangleBlock& block) { size.cells += block.count(); });
  size.elements = size.references = size.cells;
  size.apart = unbounded_.size() + extraordinary_.size();
  size.nodes = nodes_.size();
  size.depth = nodes_.empty() ? 0 : depth(nodes_, 0);
  size.bytes =
      sizeof *this + nodes_.capacity() * sizeof(WideNode) +
      (unbounded_.capacity() + every_rays_leaves_.capacity() + extraordinary_.capacity()) * sizeof(scene::ElementRef);
  size.bytes += leaves_.bytes();
  return size;
}

}  // namespace durero::accel
