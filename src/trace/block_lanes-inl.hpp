/// The triangles of a block (trace/triangle_block.hpp) in lanes of binary32. Eight lanes look their corners up among
/// the points by permutations of a register; fewer lanes read them one by one.

#if defined(DURERO_TRACE_BLOCK_LANES_INL_HPP_) == defined(HWY_TARGET_TOGGLE)
#ifdef DURERO_TRACE_BLOCK_LANES_INL_HPP_
#undef DURERO_TRACE_BLOCK_LANES_INL_HPP_
#else
#define DURERO_TRACE_BLOCK_LANES_INL_HPP_
#endif

#include <hwy/highway.h>

#include <array>
#include <cstddef>
#include <cstdint>

#include "durero/trace/triangle_block.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::trace {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using SingleTag = hn::CappedTag<float, TriangleBlock::size>;
using Singles = hn::Vec<SingleTag>;
using SingleMask = hn::Mask<SingleTag>;

struct Triple {
  Singles x, y, z;
};
/// The first, second and third corner of triangles.
struct LaneCorners {
  Triple a, b, c;
};

/// The lanes from `at` on that hold a triangle.
HWY_INLINE SingleMask used_from(const TriangleBlock& block, std::size_t at) {
  return hn::FirstN(SingleTag(), block.count() > at ? block.count() - at : 0);
}

/// The numbers of a corner of eight triangles, as places in two tables of eight points.
template <class Tag>
struct LaneNumbers {
  HWY_INLINE LaneNumbers(const TriangleBlock& block, std::size_t corner) {
    const hn::RebindToSigned<Tag> whole;
    const auto number = hn::PromoteTo(whole, hn::LoadU(hn::Rebind<std::uint8_t, Tag>(), block.numbers(corner)));
    in_second = hn::RebindMask(Tag(), hn::Gt(number, hn::Set(whole, 7)));
    place = hn::IndicesFromVec(Tag(), hn::And(number, hn::Set(whole, 7)));
  }
  decltype(hn::IndicesFromVec(Tag(), hn::Zero(hn::RebindToSigned<Tag>()))) place;
  hn::Mask<Tag> in_second;
};

/// The corners of triangles that share points, in eight lanes. The tables are read beyond the last point, where no
/// number leads.
template <class Tag>
HWY_INLINE LaneCorners looked_up(const TriangleBlock& block, Tag tag) {
  const LaneNumbers<Tag> a(block, 0), b(block, 1), c(block, 2);
  LaneCorners corners;
  const auto look_up = [&](std::size_t axis, Singles& of_a, Singles& of_b, Singles& of_c) HWY_ATTR {
    const float* const column = block.column(axis);
    const Singles first = hn::LoadU(tag, column), second = hn::LoadU(tag, column + TriangleBlock::size);
    const auto at = [&](const LaneNumbers<Tag>& n) HWY_ATTR {
      return hn::IfThenElse(n.in_second, hn::TableLookupLanes(second, n.place), hn::TableLookupLanes(first, n.place));
    };
    of_a = at(a), of_b = at(b), of_c = at(c);
  };
  look_up(0, corners.a.x, corners.b.x, corners.c.x);
  look_up(1, corners.a.y, corners.b.y, corners.c.y);
  look_up(2, corners.a.z, corners.b.z, corners.c.z);
  return corners;
}

/// The corners of triangles that share no point, in eight lanes.
template <class Tag>
HWY_INLINE LaneCorners loaded(const TriangleBlock& block, Tag tag) {
  const SingleMask used = used_from(block, 0);
  const auto of = [&](std::size_t corner, std::size_t axis) HWY_ATTR {
    return hn::IfThenElseZero(used, hn::LoadU(tag, block.column(axis) + corner * block.count()));
  };
  const auto corner = [&](std::size_t i) HWY_ATTR { return Triple{of(i, 0), of(i, 1), of(i, 2)}; };
  return {corner(0), corner(1), corner(2)};
}

/// The corners in lanes that are fewer, from lane `at` on.
template <class Tag>
HWY_INLINE LaneCorners read_one_by_one(const TriangleBlock& block, std::size_t at, Tag tag) {
  const auto of = [&](std::size_t corner, std::size_t axis) HWY_ATTR {
    HWY_ALIGN std::array<float, TriangleBlock::size> column{};
    for (std::size_t lane = 0; lane < hn::Lanes(tag); ++lane)
      column[lane] = block.column(axis)[block.has(at + lane) ? block.number(corner, at + lane) : 0];
    return hn::Load(tag, column.data());
  };
  const auto corner = [&](std::size_t i) HWY_ATTR { return Triple{of(i, 0), of(i, 1), of(i, 2)}; };
  return {corner(0), corner(1), corner(2)};
}

/// The corners of a block's triangles from lane `at` on. Lanes without a triangle hold the first point, or 0.
template <class Tag = SingleTag>
HWY_INLINE LaneCorners corners_of(const TriangleBlock& block, std::size_t at, Tag tag = {}) {
  if constexpr (hn::MaxLanes(tag) == TriangleBlock::size) {
    return block.is_shared() ? looked_up(block, tag) : loaded(block, tag);
  } else {
    return read_one_by_one(block, at, tag);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace durero::trace
HWY_AFTER_NAMESPACE();

#endif
