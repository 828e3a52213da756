#pragma once
/// The wide hierarchy is a BVH with eight children a node, boxes in binary32 that are rounded outwards, and single
/// elements as leaves. One ray traverses it nearest box first; many rays share a traversal (wide_traversal.hpp). A tree
/// of one node is not traversed by many rays: their columns are tested against each of its elements.
///
/// Two lists stand beside the tree: the elements that are not ordinary, and those without a finite box in binary32,
/// such as planes.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "durero/accel/structure.hpp"
#include "durero/accel/wide/leaf_columns.hpp"
#include "durero/accel/wide/mesh_traversal.hpp"
#include "durero/accel/wide/wide_traversal.hpp"
#include "durero/trace/bundled.hpp"
#include "durero/trace/picked.hpp"

namespace durero::accel {

/// A BVH with eight children a node over a scene, which it keeps a reference to and which must outlive it unedited.
class WideBvh {
 public:
  /// Builds the tree on as many threads as the calling thread may use; the tree does not depend on their number. O(n
  /// log n) for n elements.
  explicit WideBvh(const scene::Scene& scene);

  /// The scene of the tree.
  const scene::Scene& scene() const noexcept { return *scene_; }
  /// The elements that are not ordinary.
  std::span<const scene::ElementRef> extraordinary() const noexcept { return extraordinary_; }
  /// The ordinary elements without a finite box. Every ray is tested against them.
  std::span<const scene::ElementRef> unbounded() const noexcept { return unbounded_; }
  /// The nodes, each before its children and the root first; none where no element is bounded. The elements in them are
  /// names of leaves().
  std::span<const WideNode> nodes() const noexcept { return nodes_; }

  /// @{ Candidates::any of a source of candidates (trace/candidates.hpp). The overload with `work` is that of a
  /// structure.
  template <class Limit, class Visit>
  bool any(const trace::Ray& ray, Limit limit, Visit visit) const {
    return walk(ray, limit, visit, [](auto) {});
  }
  template <class Limit, class Visit>
  bool any(const trace::Ray& ray, Limit limit, Visit visit, Work& work) const {
    return walk(ray, limit, visit, [&](auto count) { count(work); });
  }
  /// @}
  /// @{ The operations of PairCandidates (trace/candidates.hpp).
  template <class Limit, class Visitor, class Flush>
  void pairs(std::span<const trace::Ray> rays, Limit limit, Visitor take, Flush flush) const;
  template <class Visit>
  decltype(auto) visit(scene::ElementRef leaf, Visit&& visit) const {
    return leaves_.visit(leaf, visit);
  }
  scene::ElementRef element(scene::ElementRef leaf) const { return leaves_.element(leaf); }
  scene::ElementRef own(scene::ElementRef e) const { return leaves_.leaf(e); }
  void ask_for_own(scene::ElementRef e) const { leaves_.ask_for_leaf(e); }
  void ask_for_shape(scene::ElementRef leaf) const { leaves_.ask_for_shape(leaf); }
  /// @}
  /// @{ The operations of BundleSource (trace/bundled.hpp), and whether blocks are for tests in binary32: bundles serve
  /// where nearly all elements are triangles in blocks, within the range of binary32.
  bool bundles() const noexcept { return is_mesh_; }
  bool single_blocks() const noexcept { return in_range_; }
  trace::TriangleBlock block(std::uint32_t name) const { return leaves_.block_of(name); }
  void search(trace::SingleSearch search, trace::SingleRays& rays) const {
    accel::search({nodes(), leaves_.blocks(), all_, static_cast<float>(bundle_width * spacing_)}, search, rays);
  }
  /// @}
  /// All leaves, for trace::FewCandidates, of a tree of one node without extraordinary elements; otherwise none.
  std::span<const scene::ElementRef> all_leaves() const noexcept {
    if (nodes_.size() > 1 || !extraordinary_.empty()) return {};
    return every_rays_leaves_;
  }
  /// The order of the queries that is traversed faster, for trace::order_of: by octant of the direction and by cell of
  /// the origin where the tree exceeds the cache and the queries are not coherent already; otherwise empty, which keeps
  /// the queries' own order.
  std::vector<std::uint32_t> order(std::span<const scene::Query> queries, trace::QueryKind asked) const;
  /// The elements of nodes() and unbounded(), copied into the tree's order.
  const LeafColumns& leaves() const noexcept { return leaves_; }

  /// The mean distance of neighbouring elements, the unit in which a bundle's width is measured: the longest edge of
  /// the root's box by the cube root of the number of elements.
  double spacing() const noexcept { return spacing_; }
  /// The tree's size. Each of its leaves is one element.
  Size size() const;

 private:
  static constexpr double bundle_width = 8;  // the greatest of a bundle in binary32, in spacings

  bool mostly_in_blocks() const;
  template <class Bundles, class Limit, class Visitor>
  void pairs_in_columns(std::span<const trace::Ray> rays, Limit& limit, Visitor& take) const;
  template <class Limit, class Visit, class Count>
  bool walk(const trace::Ray& ray, Limit limit, Visit visit, Count count) const;

  const scene::Scene* scene_;
  LargeVector<WideNode> nodes_;
  LeafColumns leaves_;  // of the nodes, then of unbounded_
  double spacing_ = 0;
  std::array<Range32, 3> all_{};  // the box of the root
  bool in_range_ = false;         // of the tests in binary32
  bool is_mesh_ = false;          // nearly each element is a triangle in a block, within the range of binary32
  std::vector<scene::ElementRef> unbounded_, extraordinary_;
  // The leaves that any ray may be tested against: of unbounded_, then of a tree of one node.
  std::vector<scene::ElementRef> every_rays_leaves_;
};

/// Traverses the tree with one ray; count(f) calls f(work) where work is counted. A node's eight boxes are all counted,
/// because the lanes test empty ones too.
template <class Limit, class Visit, class Count>
bool WideBvh::walk(const trace::Ray& ray, Limit limit, Visit visit, Count count) const {
  for (const scene::ElementRef e : unbounded_) {
    count([](Work& work) { ++work.candidates; });
    if (visit(e)) return true;
  }
  if (nodes_.empty()) return false;
  SingleRayTraversal walker(ray);
  bool answered = false;
  while (!answered && walker.advance(nodes_.data(), leaves_.blocks(), limit()) == SingleRayTraversal::Next::element) {
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

/// Tests the rays, in columns of 64, against each leaf of every_rays_leaves_.
template <class Bundles, class Limit, class Visitor>
void WideBvh::pairs_in_columns(std::span<const trace::Ray> rays, Limit& limit, Visitor& take) const {
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

template <class Limit, class Visitor, class Flush>
void WideBvh::pairs(std::span<const trace::Ray> rays, Limit limit, Visitor take, Flush flush) const {
  if (rays.empty()) return;
  using Bundles = PacketTraversal<WideBvh, Limit, Visitor, Flush>;
  if constexpr (Bundles::takes_many) {
    if (!every_rays_leaves_.empty()) pairs_in_columns<Bundles>(rays, limit, take);
    if (nodes_.size() == 1) return;
  } else {
    const auto unbounded = std::span(every_rays_leaves_).first(unbounded_.size());
    for (std::uint32_t number = 0; number < rays.size() && !unbounded.empty(); ++number)
      if (limit(number) > 0)
        for (const scene::ElementRef leaf : unbounded) take(number, leaf);
  }
  if (!nodes_.empty()) WideTraversal(*this, rays, limit, take, flush).all();
}

}  // namespace durero::accel
