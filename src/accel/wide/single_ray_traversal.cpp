#define HWY_TARGET_INCLUDE "accel/wide/single_ray_traversal.cpp"  // as seen from src/
#include "lanes/for_each_target.hpp"
//
#include <bit>

#include "accel/wide/wide_lanes-inl.hpp"
#include "durero/accel/wide/single_ray_traversal.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::accel {
namespace HWY_NAMESPACE {
namespace {

using Next = SingleRayTraversal::Next;

/// A ray in every lane.
struct LaneBeam {
  HWY_INLINE explicit LaneBeam(const Beam& beam) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<int>(axis);
      const bool backwards = std::signbit(beam.inverse[i]);
      near[axis] = backwards ? axis + 3 : axis;
      far[axis] = backwards ? axis : axis + 3;
    }
    x = hn::Set(Tag(), beam.p.x), y = hn::Set(Tag(), beam.p.y), z = hn::Set(Tag(), beam.p.z);
    ix = hn::Set(Tag(), beam.inverse.x), iy = hn::Set(Tag(), beam.inverse.y), iz = hn::Set(Tag(), beam.inverse.z);
  }
  std::size_t near[3], far[3];
  Lanes x, y, z, ix, iy, iz;
};

/// Sorts the last node's children, the nearest on top, by insertion. An insertion carries a child down the stack and
/// exchanges it for each farther one by a mask, because a branch on which is nearer would be mispredicted.
HWY_INLINE void sort(SingleRayTraversal& walker) {
  const std::uint32_t begin = walker.sorted;
  for (std::uint32_t i = begin + 1; i < walker.size; ++i) {
    double entry = walker.entries[i];
    std::uint64_t child = walker.children[i];
    for (std::uint32_t at = i; at > begin; --at) {
      const double before = walker.entries[at - 1];
      const std::uint64_t other = (child ^ walker.children[at - 1]) & -std::uint64_t{before < entry};
      walker.children[at] = child ^ other;
      child = walker.children[at - 1] ^ other;
      walker.entries[at] = before < entry ? before : entry;
      entry = before < entry ? entry : before;
    }
    walker.entries[begin] = entry;
    walker.children[begin] = child;
  }
}

/// Pushes the children of a node whose boxes the ray meets, not sorted yet.
HWY_INLINE void meet(SingleRayTraversal& walker, const WideNode& node, const LaneBeam& beam) {
  const Tag tag;
  const hn::Rebind<std::uint64_t, Tag> tag_of_children;
  walker.sorted = walker.size;
  const auto* children = reinterpret_cast<const std::uint64_t*>(node.children.data());
  for (std::size_t at = 0; at < WideNode::width; at += hn::Lanes(tag)) {
    const auto crossing = [&](std::size_t plane, Lanes p, Lanes inverse)
                              HWY_ATTR { return hn::Mul(hn::Sub(planes(node, plane, at), p), inverse); };
    Lanes entry = later(hn::Zero(tag), crossing(beam.near[0], beam.x, beam.ix));
    entry = later(entry, crossing(beam.near[1], beam.y, beam.iy));
    entry = later(entry, crossing(beam.near[2], beam.z, beam.iz));
    Lanes exit = sooner(hn::Set(tag, walker.limit), crossing(beam.far[0], beam.x, beam.ix));
    exit = sooner(exit, crossing(beam.far[1], beam.y, beam.iy));
    exit = sooner(exit, crossing(beam.far[2], beam.z, beam.iz));
    const unsigned places = bits(meets(entry, exit));
    const auto order = in_front(places);
    const auto own = hn::BitCast(tag, hn::LoadU(tag_of_children, children + at));
    hn::StoreU(hn::TableLookupLanes(entry, order), tag, &walker.entries[walker.size]);
    hn::StoreU(hn::BitCast(tag_of_children, hn::TableLookupLanes(own, order)), tag_of_children,
               &walker.children[walker.size]);
    walker.size += static_cast<std::uint32_t>(std::popcount(places));
  }
  ++walker.nodes;
  walker.met += walker.size - walker.sorted;
}

Next advance_walker(SingleRayTraversal& walker, const WideNode* nodes, trace::TriangleBlocks blocks, double limit) {
  WideNode unpacked;
  const LaneBeam beam(walker.beam);
  Next next = walker.next(limit);
  for (; next == Next::node || next == Next::block; next = walker.next(limit)) {
    if (next == Next::block) unpack(blocks, walker.node, unpacked);
    meet(walker, next == Next::block ? unpacked : nodes[walker.node], beam);
    sort(walker);
  }
  return next;
}

void open_walkers(const WideNode* nodes, std::span<SingleRayTraversal* const> walkers) {
  for (SingleRayTraversal* const walker : walkers) meet(*walker, nodes[walker->node], LaneBeam(walker->beam));
  for (SingleRayTraversal* const walker : walkers) sort(*walker);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace durero::accel
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace durero::accel {
namespace {
HWY_EXPORT(advance_walker);
HWY_EXPORT(open_walkers);
}  // namespace

void SingleRayTraversal::restart(const trace::Ray& ray) {
  beam = Beam(ray);
  size = 1;
  entries[0] = 0;
  children[0] = std::bit_cast<std::uint64_t>(WideChild{0, {}, WideChild::Kind::node});
}

SingleRayTraversal::Next SingleRayTraversal::advance(const WideNode* all, trace::TriangleBlocks blocks,
                                                     double greatest) {
  return HWY_DYNAMIC_DISPATCH(advance_walker)(*this, all, blocks, greatest);
}

void open(const WideNode* nodes, std::span<SingleRayTraversal* const> walkers) {
  HWY_DYNAMIC_DISPATCH(open_walkers)(nodes, walkers);
}

}  // namespace durero::accel
#endif
