#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "accel/wide_walker.cpp"  // as seen from src/
#include <hwy/foreach_target.h>
//
#include "accel/wide_lanes-inl.hpp"
//
#include <bit>

#include "durero/accel/wide_walker.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::accel {
namespace HWY_NAMESPACE {
namespace {

using Next = WideWalker::Next;
using Pace = WideWalker::Pace;

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

/// The children pushed last, the nearest to the end. Each is carried from the end to the beginning and left where a
/// farther one stands, which is carried on in its place: without a branch, as which is nearer is as chance has it.
HWY_INLINE void sort(WideWalker& walker, std::uint32_t begin) {
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

HWY_INLINE void open(WideWalker& walker, const WideNode& node, const LaneBeam& beam, double limit) {
  const Tag tag;
  const hn::Rebind<std::uint64_t, Tag> tag_of_children;
  const std::uint32_t begin = walker.size;
  const auto* children = reinterpret_cast<const std::uint64_t*>(node.children.data());
  for (std::size_t at = 0; at < WideNode::width; at += hn::Lanes(tag)) {
    const auto crossing = [&](std::size_t plane, Lanes p, Lanes inverse)
                              HWY_ATTR { return hn::Mul(hn::Sub(planes(node, plane, at), p), inverse); };
    Lanes entry = later(hn::Zero(tag), crossing(beam.near[0], beam.x, beam.ix));
    entry = later(entry, crossing(beam.near[1], beam.y, beam.iy));
    entry = later(entry, crossing(beam.near[2], beam.z, beam.iz));
    Lanes exit = sooner(hn::Set(tag, limit), crossing(beam.far[0], beam.x, beam.ix));
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
  walker.met += walker.size - begin;
  if (walker.size > begin + 1) sort(walker, begin);
}

HWY_INLINE void prefetch(const WideNode& node) {
  const auto* line = reinterpret_cast<const char*>(&node);
  for (std::size_t at = 0; at < sizeof(WideNode); at += 64) __builtin_prefetch(line + at);
}

Next advance_walker(WideWalker& walker, const WideNode* nodes, double limit, Pace pace) {
  const LaneBeam beam(walker.beam);
  const double latest = latest_entry(limit);
  while (walker.size > 0) {
    --walker.size;
    if (walker.entries[walker.size] > latest) {
      ++walker.late;
      continue;
    }
    const auto child = std::bit_cast<WideChild>(walker.children[walker.size]);
    if (child.kind == WideChild::Kind::element) {
      walker.element = child.element();
      return Next::element;
    }
    open(walker, nodes[child.index], beam, limit);
    if (pace == Pace::steady || walker.size == 0) continue;
    const auto next = std::bit_cast<WideChild>(walker.children[walker.size - 1]);
    if (next.kind == WideChild::Kind::element) continue;
    prefetch(nodes[next.index]);
    return Next::node;
  }
  return Next::end;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace durero::accel
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace durero::accel {
namespace {
HWY_EXPORT(advance_walker);
}  // namespace

void WideWalker::restart(const trace::Ray& ray) {
  beam = Beam(ray);
  size = 1;
  entries[0] = 0;
  children[0] = std::bit_cast<std::uint64_t>(WideChild{0, {}, WideChild::Kind::node});
}

WideWalker::Next WideWalker::advance(const WideNode* all, double limit, Pace pace) {
  return HWY_DYNAMIC_DISPATCH(advance_walker)(*this, all, limit, pace);
}

}  // namespace durero::accel
#endif
