#pragma once
/// The wide hierarchy: boxes of eight children a node, in binary32 and rounded outwards, down to single elements. One
/// ray walks it alone, nearest box first; many walk it together (wide_walk.hpp), or are tested in columns against each
/// element where these are so few that they are one node.
///
/// Apart from it are kept the elements that are not ordinary, and those without a finite box in binary32, as planes.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "durero/accel/structure.hpp"
#include "durero/accel/wide_leaves.hpp"
#include "durero/accel/wide_walk.hpp"
#include "durero/trace/picked.hpp"

namespace durero::accel {

/// Keeps a reference to the scene, which must outlive it unedited.
class WideBvh {
 public:
  /// On as many threads as the calling one may use; the tree does not depend on their number. O(n log n) for n
  /// elements.
  explicit WideBvh(const scene::Scene& scene);

  /// The scene, unedited since.
  const scene::Scene& scene() const noexcept { return *scene_; }
  /// The elements that are not ordinary.
  std::span<const scene::ElementRef> extraordinary() const noexcept { return extraordinary_; }
  /// The ordinary ones without a finite box, which every ray is tested against.
  std::span<const scene::ElementRef> unbounded() const noexcept { return unbounded_; }
  /// The nodes, the root first and each before its children; none where no element is bounded. Their elements are
  /// leaves.
  std::span<const WideNode> nodes() const noexcept { return nodes_; }

  /// @{ As a source of candidates has it; with `work`, as a structure.
  template <class Limit, class Visit>
  bool any(const trace::Ray& ray, Limit limit, Visit visit) const {
    return walk(ray, limit, visit, [](auto) {});
  }
  template <class Limit, class Visit>
  bool any(const trace::Ray& ray, Limit limit, Visit visit, Work& work) const {
    return walk(ray, limit, visit, [&](auto count) { count(work); });
  }
  /// @}
  /// @{ As a source of candidates has it for many rays.
  template <class Limit, class Take, class Flush>
  void pairs(std::span<const trace::Ray> rays, Limit limit, Take take, Flush flush) const;
  template <class Visit>
  decltype(auto) visit(scene::ElementRef leaf, Visit&& visit) const {
    return leaves_.visit(leaf, visit);
  }
  scene::ElementRef element(scene::ElementRef leaf) const { return leaves_.element(leaf); }
  scene::ElementRef own(scene::ElementRef e) const { return leaves_.leaf(e); }
  void ask_for_own(scene::ElementRef e) const { leaves_.ask_for_leaf(e); }
  /// @}
  /// The order in which many rays are answered faster, as trace::order_of has it: those into one octant and from one
  /// part of space together, where the tree is too large for the nearer memory, and else as they come.
  std::vector<std::uint32_t> order(std::span<const scene::Query> queries, trace::Asked asked) const;
  /// The leaves of the nodes, and of unbounded().
  const WideLeaves& leaves() const noexcept { return leaves_; }

  /// About as far apart as the elements lie: what is narrower among them is narrow.
  double spacing() const noexcept { return spacing_; }
  /// What it holds. A leaf is an element alone.
  Size size() const;

 private:
  template <class Bundles, class Limit, class Take>
  void pairs_in_columns(std::span<const trace::Ray> rays, Limit& limit, Take& take) const;
  template <class Limit, class Visit, class Count>
  bool walk(const trace::Ray& ray, Limit limit, Visit visit, Count count) const;

  const scene::Scene* scene_;
  LargeVector<WideNode> nodes_;
  WideLeaves leaves_;  // of the nodes, then those of unbounded_
  double spacing_ = 0;
  std::vector<scene::ElementRef> unbounded_, extraordinary_;
  // Those of unbounded_ in their order, then those of a tree of one node: what every ray may be tested against.
  std::vector<scene::ElementRef> every_rays_leaves_;
};

/// count(f) adds up by f(work), where work is counted. All eight boxes of a node are tested, empty ones with them.
template <class Limit, class Visit, class Count>
bool WideBvh::walk(const trace::Ray& ray, Limit limit, Visit visit, Count count) const {
  for (const scene::ElementRef e : unbounded_) {
    count([](Work& work) { ++work.candidates; });
    if (visit(e)) return true;
  }
  if (nodes_.empty()) return false;
  WideWalker walker(ray);
  bool answered = false;
  while (!answered && walker.advance(nodes_.data(), limit()) == WideWalker::Next::element) {
    count([](Work& work) { ++work.cells, ++work.candidates; });
    answered = visit(element(walker.element));
  }
  count([&](Work& work) {
    work.nodes += walker.nodes;
    work.volumes += WideNode::width * walker.nodes;
    work.by_miss += WideNode::width * walker.nodes - walker.met;
    work.by_distance += walker.late;
  });
  return answered;
}

/// As many rays as columns have room for against one of every ray's leaves after another.
template <class Bundles, class Limit, class Take>
void WideBvh::pairs_in_columns(std::span<const trace::Ray> rays, Limit& limit, Take& take) const {
  trace::RayColumns columns;
  typename Bundles::Numbers numbers{};
  std::size_t count = 0;
  const bool starts = take.starts();
  const auto take_all = [&] {
    std::uint64_t which = ~std::uint64_t{} >> (columns.size - count);
    for (const scene::ElementRef leaf : every_rays_leaves_) {
      const std::uint64_t changed = which == 0 ? 0 : take(columns, numbers, which, leaf);
      if constexpr (Bundles::takes_any) which &= ~changed;
    }
    count = 0;
  };
  for (std::uint32_t number = 0; number < rays.size(); ++number) {
    if (!(limit(number) > 0)) continue;
    columns.set(count, rays[number]);
    if (starts) columns.set_start(count, rays[number].start());
    numbers[count++] = number;
    if (count == columns.size) take_all();
  }
  if (count > 0) take_all();
}

template <class Limit, class Take, class Flush>
void WideBvh::pairs(std::span<const trace::Ray> rays, Limit limit, Take take, Flush flush) const {
  if (rays.empty()) return;
  using Bundles = WideBundles<WideBvh, Limit, Take, Flush>;
  if constexpr (Bundles::takes_many) {
    if (!every_rays_leaves_.empty()) pairs_in_columns<Bundles>(rays, limit, take);
    if (nodes_.size() == 1) return;
  } else {
    const auto unbounded = std::span(every_rays_leaves_).first(unbounded_.size());
    for (std::uint32_t number = 0; number < rays.size() && !unbounded.empty(); ++number)
      if (limit(number) > 0)
        for (const scene::ElementRef leaf : unbounded) take(number, leaf);
  }
  if (!nodes_.empty()) WideWalk(*this, rays, limit, take, flush).all();
}

}  // namespace durero::accel
