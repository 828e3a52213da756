// The walk of bundles in binary32, whose box tests are those of mesh_bundle-inl.hpp.
#define HWY_TARGET_INCLUDE "accel/wide/mesh_traversal.cpp"  // as seen from src/
#include "lanes/for_each_target.hpp"
//
#include <algorithm>
#include <bit>
#include <cmath>

#include "accel/wide/mesh_bundle-inl.hpp"
#include "durero/accel/wide/leaf_columns.hpp"
#include "durero/accel/wide/mesh_traversal.hpp"
#include "durero/trace/picked.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::accel {
namespace HWY_NAMESPACE {
namespace {

using trace::SingleRays;
using trace::SingleSearch;

constexpr std::size_t in_cache = std::size_t{1} << 20;  // bytes of a tree whose nodes are soon at hand
constexpr float scattered = 4;  // bundles' widths, over which rays start that are no bundle, nor their halves

/// The limit of a ray without a hit.
template <SingleSearch search>
constexpr float no_limit_of = search == SingleSearch::any ? 1 : HUGE_VALF;

/// A child on the stack: a lower bound of the bundle's entry into its box, its index, and, of a block, the rays that
/// may meet its box; none of a node.
struct WaitingChild {
  float entry;
  std::uint32_t index;
  std::uint64_t which;
};

/// A traversal by one bundle, or by one ray.
template <SingleSearch search, class Boxes>
class MeshWalk {
 public:
  HWY_INLINE MeshWalk(const MeshTree& tree, const Boxes& boxes, SingleRays& rays)
      : tree_(tree), boxes_(boxes), rays_(rays) {}

  void walk() {
    open(tree_.nodes[0]);
    while (size_ > 0 && limit_ >= 0) {
      const WaitingChild child = waiting_[--size_];
      if (child.entry > limit_ * grow32 + tiny32) continue;
      if (child.which == 0) {
        open(tree_.nodes[child.index]);
      } else {
        test(child);
      }
    }
  }

 private:
  /// Pushes the children of a node that the bundle meets, the nearest on top where the nearest hit is searched.
  HWY_INLINE void open(const WideNode& node) {
    BoxEntries entries;
    const std::size_t begin = size_;
    for (unsigned met = boxes_.met(node, limit_, entries); met != 0; met &= met - 1) {
      const auto place = static_cast<std::size_t>(std::countr_zero(met));
      const WideChild& child = node.children[place];
      std::uint64_t which = 0;
      if (child.kind == WideChild::Kind::node) {
        trace::ask_for(tree_.nodes[child.index]);
      } else {
        which = boxes_.met_by(node, place);
        if (which == 0) continue;
        if (child.kind == WideChild::Kind::element) {
          rays_.close(which, rays_.left);
          continue;
        }
        tree_.blocks[child.index].ask();
      }
      std::size_t at = size_++;
      if constexpr (search == SingleSearch::nearest)
        for (; at > begin && waiting_[at - 1].entry < entries[place]; --at) waiting_[at] = waiting_[at - 1];
      waiting_[at] = {entries[place], child.index, which};
    }
  }

  HWY_INLINE void test(const WaitingChild& child) {
    const std::uint64_t which = child.which & rays_.open;
    if (which == 0) return;
    const trace::TriangleBlock block = tree_.blocks[child.index];
    const unsigned triangles = boxes_.met(block, which, limit_);
    if (triangles == 0) return;
    trace::screen(block, LeafColumns::first_of(child.index).index, triangles, which, search, rays_);
    limit_ = boxes_.farthest();
  }

  const MeshTree& tree_;
  const Boxes& boxes_;
  SingleRays& rays_;
  float limit_ = no_limit_of<search>;
  std::size_t size_ = 0;
  std::array<WaitingChild, most_waiting> waiting_;  // only the first size_ are set
};

/// How far apart the first and the last of some rays start.
HWY_INLINE float spread_of(const SingleRays& rays, const MeshBundle& some) {
  float spread = 0;
  for (const SingleRays::Column& p : rays.p) spread = std::max(spread, std::abs(p[some.end - 1] - p[some.begin]));
  return spread;
}

/// The width of a bundle within the tree, up to a limit.
HWY_INLINE float width_of(const MeshTree& tree, const MeshBundle& bundle, float limit) {
  float reach = limit, width = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const bool backwards = bundle.v[axis].high < 0;
    const Range32 &all = tree.all[axis], &p = bundle.p[axis], &inverse = bundle.inverse[axis];
    reach = std::min(reach, backwards ? (all.low - p.high) * inverse.low : (all.high - p.low) * inverse.high);
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
    width = std::max(width, bundle.p[axis].width() + std::max(reach, 0.0F) * bundle.v[axis].width());
  return width;
}

/// Walks with a bundle, if it meets the tree.
template <SingleSearch search>
void walk_bundle(const MeshTree& tree, const MeshBundle& bundle, SingleRays& rays) {
  BoxEntries entries;
  if (met_children(tree.nodes[0], bundle, no_limit_of<search>, entries) == 0) return;
  BoxColumns columns;
  set_columns(tree, bundle, rays, columns);
  const BundleBoxes boxes(bundle, columns, rays);
  MeshWalk<search, BundleBoxes>(tree, boxes, rays).walk();
}

/// Walks with each of some rays alone; hands them back where the tree exceeds the cache, and each would wait for
/// memory.
template <SingleSearch search>
void walk_alone(const MeshTree& tree, const MeshBundle& some, SingleRays& rays) {
  std::uint64_t open = rays.open >> some.begin << some.begin;
  if (some.end < SingleRays::size) open &= SingleRays::bit(some.end) - 1;
  if (search == SingleSearch::any || tree.nodes.size_bytes() + tree.blocks.size_bytes() > in_cache)
    return rays.close(open, rays.left);
  BoxColumns columns;
  set_columns(tree, some, rays, columns);
  for (; open != 0; open &= open - 1) {
    const LoneBoxes boxes(static_cast<std::size_t>(std::countr_zero(open)), columns, rays);
    MeshWalk<search, LoneBoxes>(tree, boxes, rays).walk();
  }
}

/// Walks with the rays at some places as a bundle, if they are narrow; else with each half of them, or alone.
template <SingleSearch search>
void walk_places(const MeshTree& tree, MeshBundle bundle, SingleRays& rays) {
  float width = HUGE_VALF;
  if (bounded(rays, bundle)) {
    if constexpr (search == SingleSearch::any) turn_to_narrow(rays, bundle);
    invert(bundle);
    width = width_of(tree, bundle, no_limit_of<search>);
  }
  if (width <= tree.narrow) return walk_bundle<search>(tree, bundle, rays);
  const std::size_t groups = (bundle.end - bundle.begin) / SingleRays::eight;
  if (groups <= 1 || spread_of(rays, bundle) > scattered * tree.narrow) return walk_alone<search>(tree, bundle, rays);
  const std::size_t middle = bundle.begin + (groups + 1) / 2 * SingleRays::eight;
  walk_places<search>(tree, {bundle.begin, middle, {}, {}, {}}, rays);
  walk_places<search>(tree, {middle, bundle.end, {}, {}, {}}, rays);
}

template <SingleSearch search>
void search_tree(const MeshTree& tree, SingleRays& rays) {
  if (!trace::round_to_single(rays)) {
    rays.left = ~std::uint64_t{0} >> (SingleRays::size - rays.count);
    return;
  }
  std::fill_n(rays.limit.begin(), rays.count, no_limit_of<search>);
  const std::size_t end = (rays.count + SingleRays::eight - 1) / SingleRays::eight * SingleRays::eight;
  walk_places<search>(tree, {0, end, {}, {}, {}}, rays);
  std::uint64_t started = 0;
  for (std::size_t i = 0; i < rays.count; ++i) started |= std::uint64_t{rays.start[i] != SingleRays::none} << i;
  rays.left |= rays.open & started & ~rays.crossed;
}
void search_nearest(const MeshTree& tree, SingleRays& rays) { search_tree<SingleSearch::nearest>(tree, rays); }
void search_any(const MeshTree& tree, SingleRays& rays) { search_tree<SingleSearch::any>(tree, rays); }

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace durero::accel
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace durero::accel {
namespace {
HWY_EXPORT(search_nearest);
HWY_EXPORT(search_any);
}  // namespace

void search(const MeshTree& tree, trace::SingleSearch search, trace::SingleRays& rays) {
  if (search == trace::SingleSearch::nearest) return HWY_DYNAMIC_DISPATCH(search_nearest)(tree, rays);
  HWY_DYNAMIC_DISPATCH(search_any)(tree, rays);
}

}  // namespace durero::accel
#endif
