/// Bundles of rays in binary32 and their box tests (u = 2⁻²⁴). Planes are numbers of binary32, of a magnitude of M at
/// most.
///
/// One ray. With i = 1/v and c = p·i a ray crosses a plane at plane·i − c. The test computes plane·î − near for near
/// planes and plane·î − far for far ones, where near = c + E and far = c − E. v and the quotient are rounded, so î errs
/// by 2u|i|; c, a product of p and î, each rounded, by 4u|p||i|; near and far round once more; and so do the product
/// and the difference, whether fused or not. In all that is less than 6u(M + |p|)|i| and 2uE, of the E = 16u(M +
/// |p|)|i| and `tiny`, which pays for underflow too. So no near crossing is computed later than it is, no far one
/// sooner; the limit is rounded up; and a ray that has a point in the box at 0 < t ≤ limit has its entry not after its
/// exit.
///
/// A component 0. The ray keeps its coordinate p on that axis, and i has no value. î is 2⁹⁶ there, which overflows in
/// no product, and E gets 2⁶² more. A ray with a point in the box has p between the planes: its near crossing is
/// computed below 0, and its far one beyond 2⁶¹, the greatest t in range, as no two points differ by more than 2³¹ on
/// an axis, and some component of v is 2⁻³⁰ or more.
///
/// A bundle. The bounds of p and of î·(1 ± 4u) are rounded outwards. The test is that of `met` of wide_node.hpp, whose
/// two roundings are monotonic. `grow` pays for them, as 16u is more than the 5u by which an entry and an exit differ.
/// The bounds of p are 2⁻³⁴ wider where a component is 0, which times 2⁹⁶ is 2⁶². The ends of segments that are turned
/// round are 4u of that wider, which times 2⁹⁶ is 2⁴⁰; the greatest t is 1 there.

#if defined(DURERO_ACCEL_WIDE_MESH_BUNDLE_INL_HPP_) == defined(HWY_TARGET_TOGGLE)
#ifdef DURERO_ACCEL_WIDE_MESH_BUNDLE_INL_HPP_
#undef DURERO_ACCEL_WIDE_MESH_BUNDLE_INL_HPP_
#else
#define DURERO_ACCEL_WIDE_MESH_BUNDLE_INL_HPP_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "durero/accel/wide/mesh_traversal.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::accel {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using BoxTag = hn::CappedTag<float, WideNode::width>;
using BoxLanes = hn::Vec<BoxTag>;

constexpr float u32 = 0x1p-24F, tiny32 = 0x1p-100F, grow32 = 1 + 16 * u32;
constexpr float still_v = 0x1p-96F, still_width = 0x1p-34F, still_E = still_width / still_v;  // of components 0
constexpr float least_v = 0x1p-31F;  // less than the magnitude of any other component, rounded outwards

HWY_INLINE BoxLanes in_all(float x) { return hn::Set(BoxTag(), x); }
HWY_INLINE unsigned box_bits(hn::Mask<BoxTag> mask) {
  std::uint8_t stored[8] = {};
  hn::StoreMaskBits(BoxTag(), mask, stored);
  return stored[0];
}

/// A bundle is some rays at consecutive places, whole groups of eight, and their bounds by axis.
struct MeshBundle {
  std::size_t begin, end;
  std::array<Range32, 3> p, v, inverse;
};

/// The components of directions whose inverses are taken, and whether they are 0 as stored.
struct BoxDirections {
  BoxLanes v;
  hn::Mask<BoxTag> still;
};
HWY_INLINE BoxDirections directions_at(const trace::SingleRays::Column& column, std::size_t at) {
  const BoxLanes v = hn::Load(BoxTag(), &column[at]);
  const auto still = hn::Eq(v, hn::Zero(BoxTag()));
  return {hn::IfThenElse(still, in_all(still_v), v), still};
}

/// The box columns of the rays, by axis.
struct BoxColumns {
  alignas(64) trace::SingleRays::Columns inverse, near, far;
};

HWY_INLINE void set_columns(const MeshTree& tree, const MeshBundle& bundle, const trace::SingleRays& rays,
                            BoxColumns& columns) {
  const BoxTag tag;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const BoxLanes M = in_all(tree.all[axis].size());
    for (std::size_t at = bundle.begin; at < bundle.end; at += hn::Lanes(tag)) {
      const BoxLanes p = hn::Load(tag, &rays.p[axis][at]);
      const BoxDirections directions = directions_at(rays.v[axis], at);
      const BoxLanes inverse = hn::Div(in_all(1), directions.v);
      const BoxLanes c = hn::Mul(p, inverse);
      const BoxLanes reach = hn::Mul(hn::Add(M, hn::Abs(p)), hn::Abs(inverse));
      const BoxLanes least = hn::IfThenElse(directions.still, in_all(still_E), in_all(tiny32));
      const BoxLanes E = hn::MulAdd(reach, in_all(16 * u32), least);
      hn::Store(inverse, tag, &columns.inverse[axis][at]);
      hn::Store(hn::Add(c, E), tag, &columns.near[axis][at]);
      hn::Store(hn::Sub(c, E), tag, &columns.far[axis][at]);
    }
  }
}

/// A number, 4u of it and `tiny` farther to one side.
HWY_INLINE float outwards(float x, float side) { return x + side * (std::abs(x) * (4 * u32) + tiny32); }

/// The range of the numbers that were joined to it, lane by lane.
struct LaneRange {
  HWY_INLINE LaneRange() : low(in_all(HUGE_VALF)), high(in_all(-HUGE_VALF)) {}
  HWY_INLINE void join(BoxLanes x) { low = hn::Min(low, x), high = hn::Max(high, x); }
  /// The range, so much wider at both ends.
  HWY_INLINE Range32 wider(float by) const {
    const float least = hn::GetLane(hn::MinOfLanes(BoxTag(), low)) - by;
    return {outwards(least, -1), outwards(hn::GetLane(hn::MaxOfLanes(BoxTag(), high)) + by, 1)};
  }
  BoxLanes low, high;
};

/// The room around origins of rays with these components on an axis.
HWY_INLINE float room_of(const Range32& v) {
  return std::min(std::abs(v.low), std::abs(v.high)) < least_v ? still_width : 0;
}

/// Bounds the rays at some places. False where the signs of their directions differ.
HWY_INLINE bool bounded(const trace::SingleRays& rays, MeshBundle& bundle) {
  const BoxTag tag;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    LaneRange p, v;
    for (std::size_t at = bundle.begin; at < bundle.end; at += hn::Lanes(tag)) {
      p.join(hn::Load(tag, &rays.p[axis][at]));
      v.join(directions_at(rays.v[axis], at).v);
    }
    bundle.v[axis] = v.wider(0), bundle.p[axis] = p.wider(room_of(bundle.v[axis]));
    if (!(bundle.v[axis].low > 0 || bundle.v[axis].high < 0)) return false;
  }
  return true;
}

/// Turns a bundle of segments round, so that they start where they ended, if that is narrower: segments towards one
/// light diverge from it.
HWY_INLINE void turn_to_narrow(const trace::SingleRays& rays, MeshBundle& bundle) {
  const BoxTag tag;
  std::array<Range32, 3> end;
  float as_is = 0, turned = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    LaneRange ends;
    for (std::size_t at = bundle.begin; at < bundle.end; at += hn::Lanes(tag))
      ends.join(hn::Add(hn::Load(tag, &rays.p[axis][at]), hn::Load(tag, &rays.v[axis][at])));
    const Range32 &p = bundle.p[axis], &v = bundle.v[axis];
    end[axis] = ends.wider(4 * u32 * (p.size() + v.size()));
    as_is += p.width(), turned += end[axis].width();
  }
  if (turned >= as_is) return;
  bundle.p = end;
  for (Range32& v : bundle.v) v = {-v.high, -v.low};
}

HWY_INLINE void invert(MeshBundle& bundle) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    bundle.inverse[axis] = {outwards(1 / bundle.v[axis].high, -1), outwards(1 / bundle.v[axis].low, 1)};
}

/// use(axis) for each axis, without a loop: the compiler would keep one.
template <class Use>
HWY_INLINE void for_each_axis(Use use) {
  use(std::size_t{0}), use(std::size_t{1}), use(std::size_t{2});
}

/// The stretch of some rays, or of a bundle, in boxes.
struct LaneStretch {
  BoxLanes entry, exit;
};

/// Cuts a bundle's stretch by the planes of an axis.
HWY_INLINE void cut(const MeshBundle& bundle, std::size_t axis, BoxLanes low, BoxLanes high, LaneStretch& stretch) {
  const Range32 &p = bundle.p[axis], &inverse = bundle.inverse[axis];
  const bool backwards = inverse.high < 0;
  const BoxLanes near = hn::Sub(backwards ? high : low, in_all(backwards ? p.low : p.high));
  const BoxLanes far = hn::Sub(backwards ? low : high, in_all(backwards ? p.high : p.low));
  const BoxLanes a = in_all(inverse.low), b = in_all(inverse.high);
  stretch.entry = hn::Max(stretch.entry, hn::Min(hn::Mul(near, a), hn::Mul(near, b)));
  stretch.exit = hn::Min(stretch.exit, hn::Max(hn::Mul(far, a), hn::Mul(far, b)));
}

/// The boxes that a bundle may meet, a bit each, by the planes(axis) of the boxes, low and high; `entry` gets lower
/// bounds of the entries.
template <class Planes>
HWY_INLINE unsigned met_boxes(Planes planes, const MeshBundle& bundle, float limit, BoxLanes& entry) {
  LaneStretch stretch{hn::Zero(BoxTag()), in_all(limit)};
  for_each_axis([&](std::size_t axis) HWY_ATTR {
    const auto [low, high] = planes(axis);
    cut(bundle, axis, low, high, stretch);
  });
  entry = stretch.entry;
  return box_bits(hn::Le(entry, hn::MulAdd(stretch.exit, in_all(grow32), in_all(tiny32))));
}

using BoxEntries = std::array<float, WideNode::width>;  // of the boxes of a node's children

struct LanePlanePair {
  BoxLanes low, high;
};

/// met_boxes of a node's children.
HWY_INLINE unsigned met_children(const WideNode& node, const MeshBundle& bundle, float limit, BoxEntries& entries) {
  const BoxTag tag;
  unsigned met = 0;
  for (std::size_t at = 0; at < WideNode::width; at += hn::Lanes(tag)) {
    const auto planes = [&](std::size_t axis) HWY_ATTR {
      return LanePlanePair{hn::Load(tag, &node.planes[axis][at]), hn::Load(tag, &node.planes[axis + 3][at])};
    };
    BoxLanes entry;
    met |= met_boxes(planes, bundle, limit, entry) << at;
    hn::StoreU(entry, tag, &entries[at]);
  }
  return met;
}

/// met_boxes of a block's triangles.
HWY_INLINE unsigned met_triangles(const trace::TriangleBlock& block, const MeshBundle& bundle, float limit) {
  const BoxTag tag;
  trace::TriangleBlock::Columns corners;
  trace::unpack(block, corners);
  unsigned met = 0;
  for (std::size_t at = 0; at < trace::TriangleBlock::size; at += hn::Lanes(tag)) {
    const auto planes = [&](std::size_t axis) HWY_ATTR {
      const auto of = [&](std::size_t i) HWY_ATTR { return hn::LoadU(tag, &corners[i][axis][at]); };
      const BoxLanes a = of(0), b = of(1), c = of(2);
      return LanePlanePair{hn::Min(hn::Min(a, b), c), hn::Max(hn::Max(a, b), c)};
    };
    BoxLanes entry;
    met |= met_boxes(planes, bundle, limit, entry) << at;
  }
  return met & block.lanes();
}

/// The near and the far plane of a child's box along an axis, in every lane.
HWY_INLINE LanePlanePair planes_of(const WideNode& node, std::size_t child, bool backwards, std::size_t axis) {
  return {in_all(node.planes[backwards ? axis + 3 : axis][child]),
          in_all(node.planes[backwards ? axis : axis + 3][child])};
}

/// The rays of the bundle that may meet a child's box up to their limits.
HWY_INLINE std::uint64_t met_by_rays(const WideNode& node, std::size_t child, const MeshBundle& bundle,
                                     const BoxColumns& columns, const trace::SingleRays& rays) {
  const BoxTag tag;
  const auto planes = [&](std::size_t axis)
                          HWY_ATTR { return planes_of(node, child, rays.v[axis][bundle.begin] < 0, axis); };
  const LanePlanePair x = planes(0), y = planes(1), z = planes(2);
  std::uint64_t met = 0;
  for (std::size_t at = bundle.begin; at < bundle.end; at += hn::Lanes(tag)) {
    const auto crossing = [&](BoxLanes plane, BoxLanes inverse, const trace::SingleRays::Column& column)
                              HWY_ATTR { return hn::MulSub(plane, inverse, hn::Load(tag, &column[at])); };
    const auto inverse = [&](std::size_t axis) HWY_ATTR { return hn::Load(tag, &columns.inverse[axis][at]); };
    const BoxLanes ix = inverse(0), iy = inverse(1), iz = inverse(2);
    BoxLanes entry = hn::Max(hn::Zero(tag), crossing(x.low, ix, columns.near[0]));
    entry = hn::Max(entry, hn::Max(crossing(y.low, iy, columns.near[1]), crossing(z.low, iz, columns.near[2])));
    BoxLanes exit = hn::Min(hn::Load(tag, &rays.limit[at]), crossing(x.high, ix, columns.far[0]));
    exit = hn::Min(exit, hn::Min(crossing(y.high, iy, columns.far[1]), crossing(z.high, iz, columns.far[2])));
    met |= std::uint64_t{box_bits(hn::Le(entry, exit))} << at;
  }
  return met;
}

/// The rays of a bundle as MeshWalk asks about them.
class BundleBoxes {
 public:
  HWY_INLINE BundleBoxes(const MeshBundle& bundle, const BoxColumns& columns, const trace::SingleRays& rays)
      : bundle_(bundle), columns_(columns), rays_(rays) {}

  /// The children of a node whose boxes some ray may meet up to a limit, and lower bounds of the entries.
  HWY_INLINE unsigned met(const WideNode& node, float limit, BoxEntries& entries) const {
    return met_children(node, bundle_, limit, entries);
  }
  /// The rays that may meet a child's box, of a child that is met.
  HWY_INLINE std::uint64_t met_by(const WideNode& node, std::size_t child) const {
    return met_by_rays(node, child, bundle_, columns_, rays_);
  }
  /// The triangles of a block that some ray may meet up to a limit, of those in `which`.
  HWY_INLINE unsigned met(const trace::TriangleBlock& block, std::uint64_t which, float limit) const {
    return std::popcount(which) < few ? block.lanes() : met_triangles(block, bundle_, limit);
  }
  /// The greatest limit of the rays.
  HWY_INLINE float farthest() const {
    const BoxTag tag;
    BoxLanes farthest = hn::Load(tag, &rays_.limit[bundle_.begin]);
    for (std::size_t at = bundle_.begin + hn::Lanes(tag); at < bundle_.end; at += hn::Lanes(tag))
      farthest = hn::Max(farthest, hn::Load(tag, &rays_.limit[at]));
    return hn::GetLane(hn::MaxOfLanes(tag, farthest));
  }

 private:
  static constexpr int few = 12;  // rays from which on it pays to ask about the triangles

  const MeshBundle& bundle_;
  const BoxColumns& columns_;
  const trace::SingleRays& rays_;
};

/// One ray, likewise. The test of eight boxes is that of met_by_rays.
class LoneBoxes {
 public:
  HWY_INLINE LoneBoxes(std::size_t place, const BoxColumns& columns, const trace::SingleRays& rays)
      : place_(place), rays_(rays) {
    const auto of = [&](const trace::SingleRays::Columns& column, std::size_t axis)
                        HWY_ATTR { return in_all(column[axis][place]); };
    for_each_axis([&](std::size_t axis) HWY_ATTR {
      near_plane_[axis] = rays.v[axis][place] < 0 ? axis + 3 : axis;
      inverse_[axis] = of(columns.inverse, axis);
      near_[axis] = of(columns.near, axis), far_[axis] = of(columns.far, axis);
    });
  }

  HWY_INLINE unsigned met(const WideNode& node, float limit, BoxEntries& entries) const {
    const BoxTag tag;
    unsigned met = 0;
    for (std::size_t at = 0; at < WideNode::width; at += hn::Lanes(tag)) {
      LaneStretch stretch{hn::Zero(tag), in_all(limit)};
      for_each_axis([&](std::size_t axis) HWY_ATTR {
        const auto& first = node.planes[near_plane_[axis]];
        const auto& last = node.planes[2 * axis + 3 - near_plane_[axis]];
        stretch.entry = hn::Max(stretch.entry, hn::MulSub(hn::Load(tag, &first[at]), inverse_[axis], near_[axis]));
        stretch.exit = hn::Min(stretch.exit, hn::MulSub(hn::Load(tag, &last[at]), inverse_[axis], far_[axis]));
      });
      hn::StoreU(stretch.entry, tag, &entries[at]);
      met |= box_bits(hn::Le(stretch.entry, stretch.exit)) << at;
    }
    return met;
  }
  HWY_INLINE std::uint64_t met_by(const WideNode&, std::size_t) const { return trace::SingleRays::bit(place_); }
  HWY_INLINE unsigned met(const trace::TriangleBlock& block, std::uint64_t, float) const { return block.lanes(); }
  HWY_INLINE float farthest() const { return rays_.limit[place_]; }

 private:
  std::size_t place_;
  const trace::SingleRays& rays_;
  std::size_t near_plane_[3];
  BoxLanes inverse_[3], near_[3], far_[3];
};

}  // namespace HWY_NAMESPACE
}  // namespace durero::accel
HWY_AFTER_NAMESPACE();

#endif
