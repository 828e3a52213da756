#pragma once
/// A frustum bounds the segments of a bundle by planes that none of them crosses. The traversal opens a node where one
/// of the node's boxes reaches into the frustum. Segments towards one light fit into a narrow frustum however far apart
/// they start.
///
/// A half-space that holds both ends of a segment holds all of it. Along one axis, y, the segments lie between two
/// numbers. For each other axis x, a lower bound holds for x − b·y of all segments, and an upper bound for x − d·y. The
/// test passes over a box whose corners' greatest x − b·y is less than the lower bound, or whose least x − d·y is
/// greater than the upper bound. The bounds hold for any slopes b and d; the choice of slopes only makes the frustum
/// narrow.
///
/// Rounding is covered by slack. In binary64, with u = 2⁻⁵³ and X, Y not less than any |x|, |y| of the ends and of the
/// boxes: x − b·y errs by 3u(X + |b|Y), for the product and the difference; the far end p + v errs by uX along x and uY
/// along y, and once more where a bound is computed from it; and a bound errs by 2u(X + |b|Y) more, because `slack` is
/// subtracted from it. The sum is less than 12u(X + |b|Y) and some roundings of underflowing products, each within
/// 2⁻¹⁰⁷⁵ (proofs/Beams.v: low_side_keeps, high_side_keeps). The slack is 32u(X + |b|Y) and the least normal number.
/// Nothing overflows, because rays are ordinary and boxes are finite in binary32.

#include <array>
#include <cstddef>

#include "durero/accel/wide/wide_node.hpp"

namespace durero::accel {

/// A frustum between six planes, two for each axis.
struct Frustum {
  /// A plane: x − slope·y of every point of the segments is not below `bound` (a low side) or not above it (a high
  /// side).
  struct Side {
    double slope = 0;  ///< by which x changes along y
    double bound = 0;  ///< slack included
  };

  std::size_t along = 0;                ///< the axis y, of the first ray's greatest |v|
  std::array<std::size_t, 2> across{};  ///< the two axes x
  double from = 0, to = 0;              ///< the range of y, slack included
  std::array<Side, 2> low{}, high{};    ///< the planes, by axis x
  double width = 0;                     ///< the greatest distance of a low and a high plane, within the scene's box
};

/// The frustum of a bundle's segments { p + t·v | 0 ≤ t ≤ 1 } in a scene whose box is `all`. A ray with a limit below 0
/// counts as its origin alone. A frustum whose width is not finite bounds nothing. Preconditions: all other limits are
/// 1; the bundle is gathered.
Frustum beam_of(const WidePacket& bundle, const surface::Box& all);

/// The children whose boxes may hold a point of the frustum's segments, a bit each, the first child's lowest.
/// Preconditions: the frustum's width is finite; the node belongs to the scene for which the frustum was made.
unsigned met(const WideNode& node, const Frustum& beam);

}  // namespace durero::accel
