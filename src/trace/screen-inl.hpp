/// The test of triangles and rays of binary32. It is that of shape/triangle-inl.hpp, with e1 = b − a, e2 = c − a and
/// q = p − a, in binary32 (u = 2⁻²⁴):
///   det = e1·(v × e2)    C = e2·(q × e1)    t = C/det
///   ca = q·(v × e2)      ab = v·(q × e1)    bc = det − ca − ab
/// margin is the least of ca, ab and bc, times the sign of det.
///
/// Bounds, to first order in u, with extents (sums of the components' sizes) V of v, Q of q, L1 of e1 and L2 of e2. A
/// fused multiply-add rounds once where the two operations round twice, so the bounds hold with it and without.
///   v    is rounded once: u of itself. The vertices are exact, so e1 and e2 err by u of themselves.
///   q    = (P − a) + rest, with P and the rest of p rounded once each. The rest is at most u|p| and errs by u²|p|. The
///        two sums round, so q errs by 2u|q| + 4u²|p|; with Q + 8u|p| in the place of Q that is at most 2uQ.
///   A component of v × e2 errs by 4u, of q × e1 by 5u, of the sizes of its products. A triple product adds three
///   roundings and the error of its other factor. The sizes of the products of a whole triple product add up to at most
///   the product of the three extents. This gives
///     det  (4 + 1 + 3)u·V·L1·L2    C   (5 + 1 + 3)u·Q·L1·L2
///     ca   (4 + 2 + 3)u·V·Q·L2     ab  (5 + 1 + 3)u·V·Q·L1
///     bc   their sum and two roundings, in all 11u·V(L1·L2 + Q(L1 + L2)).
/// Every bound below has 12u. The twelfth part of it that is over pays for terms of second order and for the roundings
/// of the bounds themselves, each some 10u of the bound. Numbers within `range` add up to less than 2³³ each, so that
/// no triple product reaches 2¹⁰⁰. An operation that underflows errs by 2⁻¹⁵⁰ at most, and later factors make that less
/// than 2⁻¹⁵⁰·2³³·2³³ each; `tiny`, 2⁻¹⁰⁰ less or more, pays for all.
///
/// Miss. Let the computed det be positive (else turn all signs), and a computed side below −error. Then the true side
/// is negative, since its bound is less than `error`. If the true det is positive, the line passes outside of that
/// side. If it is 0, the line is parallel to the plane; in the plane all three sides would be 0, and beside it the line
/// misses. If it is negative, it is at most 8u·V·L1·L2 in size, and a line that meets the triangle has no positive
/// side; the sides add up to det, so none is larger. A side ca or ab would then not be computed below −error, whose
/// part in L1·L2 alone exceeds that. Nor would bc, which is computed from a positive det and from sides of at most
/// 9u·V·Q·L2 and 9u·V·Q·L1.
///
/// Hit. Where margin > error all three true sides have the sign of the computed det, and so has their sum, det.
///
/// Parameter. With |det| > 4·det_error the quotient of C and det errs by (C_error + |t|·det_error)/(|det| − det_error),
/// at most 4/3·(…)/|det|. The factor 1.4 pays for the roundings of the bound. The inverse and the product round: 2u|t|;
/// two more units allow for the roundings of t ± error, and `tiny` for what underflows in t and in the bound.
///
/// proofs/Screen.v proves these bounds, with fused operations and without (the_screen_of_triangles_is_right).

#if defined(DURERO_TRACE_SCREEN_INL_HPP_) == defined(HWY_TARGET_TOGGLE)
#ifdef DURERO_TRACE_SCREEN_INL_HPP_
#undef DURERO_TRACE_SCREEN_INL_HPP_
#else
#define DURERO_TRACE_SCREEN_INL_HPP_
#endif

#include <hwy/highway.h>

#include <cstdint>

#include "durero/trace/single_rays.hpp"
#include "trace/block_lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::trace {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr float u = 0x1p-24F, tiny = 0x1p-100F;  // of the derivation above

HWY_INLINE Singles all(float x) { return hn::Set(SingleTag(), x); }
HWY_INLINE std::size_t singles() { return hn::Lanes(SingleTag()); }
HWY_INLINE unsigned bits_of(SingleMask mask) {
  std::uint8_t stored[8] = {};
  hn::StoreMaskBits(SingleTag(), mask, stored);
  return stored[0];
}

HWY_INLINE Triple minus(const Triple& a, const Triple& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE Singles inner(const Triple& a, const Triple& b) {
  return hn::MulAdd(a.z, b.z, hn::MulAdd(a.y, b.y, hn::Mul(a.x, b.x)));
}
HWY_INLINE Triple outer(const Triple& a, const Triple& b) {
  return {hn::MulSub(a.y, b.z, hn::Mul(a.z, b.y)), hn::MulSub(a.z, b.x, hn::Mul(a.x, b.z)),
          hn::MulSub(a.x, b.y, hn::Mul(a.y, b.x))};
}
HWY_INLINE Singles extent_of(const Triple& a) { return hn::Add(hn::Add(hn::Abs(a.x), hn::Abs(a.y)), hn::Abs(a.z)); }

/// Triangles in lanes: a vertex, the edges, and the sum and the product of the edges' extents.
struct LaneTriangles {
  Triple a, e1, e2;
  Singles sum, product;
};
/// Rays in lanes.
struct LaneRays {
  Triple p, rest, v;
  Singles rate, slack, limit;
};

/// The triangles of a block from lane `at` on. A lane without a triangle has no extent: NaN, which makes it a miss.
HWY_INLINE LaneTriangles triangles_of(const TriangleBlock& block, std::size_t at) {
  const auto [a, b, c] = corners_of(block, at);
  const Triple e1 = minus(b, a), e2 = minus(c, a);
  const Singles nothing = all(std::numeric_limits<float>::quiet_NaN());
  const Singles L1 = hn::IfThenElse(used_from(block, at), extent_of(e1), nothing), L2 = extent_of(e2);
  return {a, e1, e2, hn::Add(L1, L2), hn::Mul(L1, L2)};
}

/// A ray in every lane.
HWY_INLINE LaneRays ray_of(const SingleRays& rays, std::size_t i) {
  const auto of = [&](const SingleRays::Columns& c) HWY_ATTR {
    return Triple{all(c[0][i]), all(c[1][i]), all(c[2][i])};
  };
  return {of(rays.p), of(rays.rest), of(rays.v), all(rays.rate[i]), all(rays.slack[i]), all(rays.limit[i])};
}

/// The results of the test: a pair is a hit, whose parameter is in low … high, or perhaps a hit, or a miss. Only
/// possible pairs have bounds.
struct Screened {
  SingleMask possible, certain, known;  ///< known: the line crosses the triangle's plane in one point
  Singles low, high;
};

/// The test of pairs in lanes. False where all are misses; nothing else means anything then.
HWY_INLINE bool screened(const LaneTriangles& of, const LaneRays& ray, Screened& result) {
  const SingleTag tag;
  const Triple d = minus(ray.p, of.a);
  const Triple q{hn::Add(d.x, ray.rest.x), hn::Add(d.y, ray.rest.y), hn::Add(d.z, ray.rest.z)};
  const Triple v_e2 = outer(ray.v, of.e2), q_e1 = outer(q, of.e1);
  const Singles det = inner(of.e1, v_e2), ca = inner(q, v_e2), ab = inner(ray.v, q_e1);
  const Singles bc = hn::Sub(hn::Sub(det, ca), ab);
  const Singles sign = hn::And(det, hn::SignBit(tag));
  const Singles margin = hn::Min(hn::Min(hn::Xor(ca, sign), hn::Xor(ab, sign)), hn::Xor(bc, sign));
  const Singles Q = hn::Add(extent_of(q), ray.slack);
  const Singles error = hn::MulAdd(ray.rate, hn::MulAdd(Q, of.sum, of.product), all(tiny));
  const SingleMask within = hn::Ge(margin, hn::Neg(error));
  if (hn::AllFalse(tag, within)) return false;

  const Singles det_error = hn::MulAdd(ray.rate, of.product, all(tiny)), size = hn::Abs(det);
  const Singles C_error = hn::MulAdd(hn::Mul(all(12 * u), Q), of.product, all(tiny));
  const Singles inverse = hn::Div(all(1), size), t = hn::Mul(hn::Xor(inner(of.e2, q_e1), sign), inverse);
  const Singles t_size = hn::Abs(t);
  const Singles t_error = hn::MulAdd(hn::Mul(all(1.4F), inverse), hn::MulAdd(t_size, det_error, C_error),
                                     hn::MulAdd(all(4 * u), t_size, all(tiny)));
  result.low = hn::Sub(t, t_error), result.high = hn::Add(t, t_error);
  result.known = hn::Gt(size, hn::Mul(all(4), det_error));
  const SingleMask elsewhere = hn::Or(hn::Lt(result.high, hn::Zero(tag)), hn::Gt(result.low, ray.limit));
  result.possible = hn::AndNot(hn::And(result.known, elsewhere), within);
  const SingleMask ahead = hn::And(result.known, hn::Gt(result.low, hn::Zero(tag)));
  result.certain = hn::And(result.possible, hn::And(ahead, hn::Gt(margin, error)));
  return true;
}

}  // namespace HWY_NAMESPACE
}  // namespace durero::trace
HWY_AFTER_NAMESPACE();

#endif
