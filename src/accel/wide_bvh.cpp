#include "durero/accel/wide_bvh.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "accel/wide_split.hpp"
#include "durero/surface/surfaces.hpp"

namespace durero::accel {
namespace {

using ChildKind = WideChild::Kind;
using wide::Box32;
using wide::Item;
using wide::Part;
using wide::parts_of;

/// The greatest number of binary32 that is not above x, and the least that is not below it.
float below(double x) {
  const auto nearest = static_cast<float>(x);
  return static_cast<double>(nearest) > x ? std::nextafterf(nearest, -HUGE_VALF) : nearest;
}
float above(double x) { return -below(-x); }

/// Rounded outwards: it holds all points of the other.
Box32 outwards(const surface::Box& box) {
  return {{below(box.low.x), below(box.low.y), below(box.low.z)},
          {above(box.high.x), above(box.high.y), above(box.high.z)}};
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

/// So many nodes ahead memory is asked for their elements, which lie anywhere in the tables of the scene.
constexpr std::size_t nodes_ahead = 4;

void ask_for_elements(const scene::Scene& scene, const WideNode& node) {
  for (const WideChild& child : node.children)
    if (child.kind == ChildKind::element)
      trace::ask_for(
          scene.visit(child.element(), [](const auto& shape) { return std::as_bytes(std::span(&shape, 1)); }));
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
    const Box32 all = wide::box_of(items);
    const double extent = std::max({all.width(0), all.width(1), all.width(2)});
    spacing_ = extent / std::cbrt(static_cast<double>(items.size()));
    std::vector<WideNode> nodes;
    build(nodes, {items, all}, 0);
    nodes_.assign(nodes.begin(), nodes.end());
  }
  leaves_.reserve(scene);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (i + nodes_ahead < nodes_.size()) ask_for_elements(scene, nodes_[i + nodes_ahead]);
    for (WideChild& child : nodes_[i].children)
      if (child.kind == ChildKind::element) child.index = leaves_.push_back(scene, child.element()).index;
  }
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
