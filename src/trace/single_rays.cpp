// Rays in binary32: how they are rounded, and what is kept of their tests (screen-inl.hpp).
#define HWY_TARGET_INCLUDE "trace/single_rays.cpp"  // as seen from src/
#include "lanes/for_each_target.hpp"
//
#include <bit>
#include <cmath>
#include <limits>

#include "durero/trace/packet.hpp"
#include "durero/trace/single_rays.hpp"
#include "trace/screen-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::trace {
namespace HWY_NAMESPACE {
namespace {

/// The lane of the triangle that a ray starts on among eight from `first` on, as a bit; 0 where it is none of them.
HWY_INLINE unsigned start_lane(std::uint32_t start, std::uint32_t first) {
  return start - first < TriangleBlock::size ? 1u << (start - first) : 0;
}

/// A number of binary32 that is below x, and one above it.
HWY_INLINE float single_below(double x) { return static_cast<float>(x - std::abs(x) * 0x1p-23 - double{tiny}); }
HWY_INLINE float single_above(double x) { return -single_below(-x); }

/// Keeps a hit of a ray on the triangle `name` where it is the nearest; hands the ray back where it and another hit are
/// not told apart.
HWY_INLINE void keep_nearest(SingleRays& rays, std::size_t i, std::uint32_t name, float low, float high) {
  if (low > rays.limit[i]) return;
  if (!(high < rays.low[i])) return rays.close(SingleRays::bit(i), rays.left);
  rays.low[i] = low, rays.limit[i] = high;
  rays.nearest[i] = name;
}

/// Decides a ray and some triangles of a block in binary64. The ray is handed back where that leaves a hit open.
template <SingleSearch search>
void settle(const TriangleBlock& block, std::uint32_t first, unsigned triangles, std::size_t i, SingleRays& rays) {
  const auto stored = [&](const auto& columns) { return glm::dvec3(columns[0][i], columns[1][i], columns[2][i]); };
  const Ray ray(stored(rays.stored_p), stored(rays.stored_v));
  Findings found;
  triage(ray, block, found);
  if (!ray.ordinary || (found.undecided & triangles) != 0) return rays.close(SingleRays::bit(i), rays.left);
  for (unsigned hits = found.hit & triangles; hits != 0 && (rays.open >> i & 1) != 0; hits &= hits - 1) {
    const auto lane = static_cast<std::uint32_t>(std::countr_zero(hits));
    const double low = found.t[lane] - found.error[lane], high = found.t[lane] + found.error[lane];
    if constexpr (search == SingleSearch::nearest) {
      keep_nearest(rays, i, first + lane, single_below(low), single_above(high));
    } else if (high < 1) {
      rays.close(SingleRays::bit(i), rays.hit);
    } else if (!(low > 1)) {
      rays.close(SingleRays::bit(i), rays.left);
    }
  }
}

/// Tests rays one after another against the triangles of a block side by side.
template <SingleSearch search>
void screen_rows(const TriangleBlock& block, std::uint32_t first, std::uint64_t which, SingleRays& rays) {
  const SingleTag tag;
  alignas(64) std::array<float, SingleRays::eight> low, high;
  for (std::size_t at = 0; at < TriangleBlock::size; at += singles()) {
    const LaneTriangles triangles = triangles_of(block, at);
    const auto first_here = first + static_cast<std::uint32_t>(at);
    for (std::uint64_t left = which & rays.open; left != 0; left &= left - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(left));
      Screened s;
      if (!screened(triangles, ray_of(rays, i), s)) continue;
      const unsigned own = start_lane(rays.start[i], first_here);
      if ((bits_of(s.known) & own) != 0) rays.crossed |= SingleRays::bit(i);
      const unsigned possible = bits_of(s.possible) & ~own, certain = bits_of(s.certain) & ~own;
      if (possible == 0) continue;
      if constexpr (search == SingleSearch::any) {
        if ((certain & bits_of(hn::Lt(s.high, all(1)))) != 0) {
          rays.close(SingleRays::bit(i), rays.hit);
          continue;
        }
      }
      if (search == SingleSearch::any || possible != certain) {
        settle<search>(block, first, possible << at, i, rays);
        continue;
      }
      hn::Store(s.low, tag, &low[0]), hn::Store(s.high, tag, &high[0]);
      for (unsigned hits = certain; hits != 0 && (rays.open >> i & 1) != 0; hits &= hits - 1) {
        const auto lane = static_cast<std::uint32_t>(std::countr_zero(hits));
        keep_nearest(rays, i, first_here + lane, low[lane], high[lane]);
      }
    }
  }
}

/// The triangles of a block, one after another in every lane.
class EachTriangle {
 public:
  HWY_INLINE explicit EachTriangle(const TriangleBlock& block) {
    for (std::size_t at = 0; at < TriangleBlock::size; at += singles()) {
      const LaneTriangles some = triangles_of(block, at);
      const Singles columns[] = {some.a.x,  some.a.y,  some.a.z,  some.e1.x, some.e1.y,   some.e1.z,
                                 some.e2.x, some.e2.y, some.e2.z, some.sum,  some.product};
      for (std::size_t i = 0; i < columns_.size(); ++i) hn::Store(columns[i], SingleTag(), &columns_[i][at]);
    }
  }
  HWY_INLINE LaneTriangles operator[](std::size_t lane) const {
    const auto of = [&](std::size_t i) HWY_ATTR { return all(columns_[i][lane]); };
    return {{of(0), of(1), of(2)}, {of(3), of(4), of(5)}, {of(6), of(7), of(8)}, of(9), of(10)};
  }

 private:
  alignas(64) std::array<TriangleBlock::Column, 11> columns_;
};

/// The rays from a place on.
HWY_INLINE LaneRays rays_from(const SingleRays& rays, std::size_t at) {
  const SingleTag tag;
  const auto of = [&](const SingleRays::Columns& c) HWY_ATTR {
    return Triple{hn::Load(tag, &c[0][at]), hn::Load(tag, &c[1][at]), hn::Load(tag, &c[2][at])};
  };
  return {of(rays.p),
          of(rays.rest),
          of(rays.v),
          hn::Load(tag, &rays.rate[at]),
          hn::Load(tag, &rays.slack[at]),
          hn::Load(tag, &rays.limit[at])};
}

/// Tests a triangle for the rays in `used`, from a place on, in lanes.
template <SingleSearch search>
HWY_INLINE void screen_lanes(const TriangleBlock& block, std::uint32_t first, std::uint32_t lane,
                             const LaneTriangles& triangle, std::size_t at, unsigned used, SingleRays& rays) {
  const SingleTag tag;
  const hn::Rebind<std::uint32_t, SingleTag> tag_of_names;
  Screened s;
  if (!screened(triangle, rays_from(rays, at), s)) return;
  const auto starts = hn::Eq(hn::Load(tag_of_names, &rays.start[at]), hn::Set(tag_of_names, first + lane));
  const unsigned own = bits_of(hn::RebindMask(tag, starts));
  rays.crossed |= std::uint64_t{bits_of(s.known) & own & used} << at;
  const unsigned possible = bits_of(s.possible) & used & ~own;
  const Singles end = search == SingleSearch::any ? all(1) : hn::Load(tag, &rays.low[at]);
  const unsigned taken = bits_of(hn::And(s.certain, hn::Lt(s.high, end))) & possible;
  if constexpr (search == SingleSearch::any) {
    rays.close(std::uint64_t{taken} << at, rays.hit);
  } else {
    const auto bytes = static_cast<std::uint8_t>(taken);
    const std::uint8_t stored[8] = {bytes};
    const SingleMask mask = hn::LoadMaskBits(tag, stored);
    hn::BlendedStore(s.low, mask, tag, &rays.low[at]);
    hn::BlendedStore(s.high, mask, tag, &rays.limit[at]);
    hn::BlendedStore(hn::Set(tag_of_names, first + lane), hn::RebindMask(tag_of_names, mask), tag_of_names,
                     &rays.nearest[at]);
  }
  for (unsigned left = possible & ~taken; left != 0; left &= left - 1)
    settle<search>(block, first, 1u << lane, at + static_cast<std::size_t>(std::countr_zero(left)), rays);
}

/// Tests triangles of a block one after another for rays side by side.
template <SingleSearch search>
void screen_columns(const TriangleBlock& block, std::uint32_t first, unsigned triangles, std::uint64_t which,
                    SingleRays& rays) {
  const EachTriangle each(block);
  for (; triangles != 0; triangles &= triangles - 1) {
    const auto lane = static_cast<std::uint32_t>(std::countr_zero(triangles));
    const LaneTriangles triangle = each[lane];
    const std::uint64_t still = which & rays.open;
    for (std::uint64_t eights = eights_of(still); eights != 0; eights &= eights - 1)
      for (std::size_t at = 0; at < SingleRays::eight; at += singles()) {
        const std::size_t place = at + static_cast<std::size_t>(std::countr_zero(eights));
        const auto used = static_cast<unsigned>(still >> place & ((1u << singles()) - 1));
        screen_lanes<search>(block, first, lane, triangle, place, used, rays);
      }
  }
}

template <SingleSearch search>
void screen_block(const TriangleBlock& block, std::uint32_t first, unsigned triangles, std::uint64_t which,
                  SingleRays& rays) {
  const int in_rows = std::popcount(which), in_columns = std::popcount(triangles) * std::popcount(eights_of(which));
  if (in_columns < in_rows) {
    screen_columns<search>(block, first, triangles, which, rays);
  } else {
    screen_rows<search>(block, first, which, rays);
  }
}
void screen_nearest(const TriangleBlock& block, std::uint32_t first, unsigned triangles, std::uint64_t which,
                    SingleRays& rays) {
  screen_block<SingleSearch::nearest>(block, first, triangles, which, rays);
}
void screen_any(const TriangleBlock& block, std::uint32_t first, unsigned triangles, std::uint64_t which,
                SingleRays& rays) {
  screen_block<SingleSearch::any>(block, first, triangles, which, rays);
}

unsigned possible_in_block(const Ray& ray, const TriangleBlock& block, double limit) {
  const auto nearest = [](double x) { return static_cast<float>(x); };
  const auto rest = [&](double x) { return nearest(x - double{nearest(x)}); };
  const auto everywhere = [](float x, float y, float z) HWY_ATTR { return Triple{all(x), all(y), all(z)}; };
  const glm::dvec3 &p = ray.p, &v = ray.v;
  const double p_size = std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
  const LaneRays lanes{
      everywhere(nearest(p.x), nearest(p.y), nearest(p.z)), everywhere(rest(p.x), rest(p.y), rest(p.z)),
      everywhere(nearest(v.x), nearest(v.y), nearest(v.z)), all(nearest(12.0 * u * ray.speed)),
      all(nearest(8.0 * u * p_size + double{tiny})),        all(single_above(limit))};
  unsigned possible = 0;
  for (std::size_t at = 0; at < TriangleBlock::size; at += singles()) {
    Screened s;
    if (screened(triangles_of(block, at), lanes, s)) possible |= bits_of(s.possible) << at;
  }
  return possible;
}

using WideTag = hn::CappedTag<double, SingleRays::eight>;
using HalfTag = hn::Rebind<float, WideTag>;
using Wide = hn::Vec<WideTag>;

/// Rounds some rays; false in the lanes whose numbers are out of range.
HWY_INLINE hn::Mask<WideTag> rounded_lanes(SingleRays& rays, std::size_t at) {
  const WideTag tag;
  const HalfTag half;
  Wide p_size = hn::Zero(tag), v_size = hn::Zero(tag);
  auto good = hn::Eq(p_size, p_size);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Wide p = hn::Load(tag, &rays.stored_p[axis][at]), v = hn::Load(tag, &rays.stored_v[axis][at]);
    const auto nearest = hn::DemoteTo(half, p);
    hn::Store(nearest, half, &rays.p[axis][at]);
    hn::Store(hn::DemoteTo(half, hn::Sub(p, hn::PromoteTo(tag, nearest))), half, &rays.rest[axis][at]);
    hn::Store(hn::DemoteTo(half, v), half, &rays.v[axis][at]);
    p_size = hn::Add(p_size, hn::Abs(p)), v_size = hn::Add(v_size, hn::Abs(v));
    const auto still = hn::Eq(v, hn::Zero(tag));
    good = hn::And(good, hn::Or(still, hn::Ge(hn::Abs(v), hn::Set(tag, 1 / SingleRays::range))));
  }
  hn::Store(hn::DemoteTo(half, hn::Mul(v_size, hn::Set(tag, 12.0 * u))), half, &rays.rate[at]);
  hn::Store(hn::DemoteTo(half, hn::MulAdd(p_size, hn::Set(tag, 8.0 * u), hn::Set(tag, double{tiny}))), half,
            &rays.slack[at]);
  const Wide most = hn::Set(tag, SingleRays::range);
  return hn::And(good, hn::And(hn::Le(p_size, most), hn::Le(v_size, most)));
}

bool round_rays(SingleRays& rays) {
  bool good = true;
  for (std::size_t at = 0; at < rays.count; at += hn::Lanes(WideTag()))
    good &= hn::AllTrue(WideTag(), rounded_lanes(rays, at));
  return good;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace durero::trace
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace durero::trace {
namespace {
HWY_EXPORT(round_rays);
HWY_EXPORT(screen_nearest);
HWY_EXPORT(screen_any);
HWY_EXPORT(possible_in_block);
}  // namespace

bool round_to_single(SingleRays& rays) {
  const std::size_t places = (rays.count + SingleRays::eight - 1) / SingleRays::eight * SingleRays::eight;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t place = rays.count; place < places; ++place) {
      rays.stored_p[axis][place] = rays.stored_p[axis][rays.count - 1];
      rays.stored_v[axis][place] = rays.stored_v[axis][rays.count - 1];
    }
  rays.open = rays.left = rays.hit = rays.crossed = 0;
  rays.low.fill(std::numeric_limits<float>::infinity());
  rays.limit.fill(-1);
  if (!HWY_DYNAMIC_DISPATCH(round_rays)(rays)) return false;
  rays.open = ~std::uint64_t{0} >> (SingleRays::size - rays.count);
  return true;
}

void screen(const TriangleBlock& block, std::uint32_t first, unsigned triangles, std::uint64_t which,
            SingleSearch search, SingleRays& rays) {
  if (search == SingleSearch::nearest)
    return HWY_DYNAMIC_DISPATCH(screen_nearest)(block, first, triangles, which, rays);
  HWY_DYNAMIC_DISPATCH(screen_any)(block, first, triangles, which, rays);
}

bool in_single_range(const Ray& ray) {
  bool good = true;
  for (int axis = 0; axis < 3; ++axis) {
    const double v = std::abs(ray.v[axis]);
    good &= std::abs(ray.p[axis]) <= SingleRays::range && v <= SingleRays::range;
    good &= v == 0 || v >= 1 / SingleRays::range;
  }
  return good;
}

unsigned possible_hits(const Ray& ray, const TriangleBlock& block, double limit) {
  return HWY_DYNAMIC_DISPATCH(possible_in_block)(ray, block, limit);
}

}  // namespace durero::trace
#endif
