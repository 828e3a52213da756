#pragma once
/// Segments on their way through the wide hierarchy together, as the space between planes that none of them crosses: a
/// node is opened where a box of it reaches there. Those towards one light are so held together however far apart they
/// start on their way to it.
///
/// A half-space that holds both ends of a segment holds all of it. Along one axis, y, the segments lie between two
/// numbers; across it, for each other axis x, x − b·y is not less than a bound on all of them, and x − d·y not greater
/// than another. So a box is passed over where the greatest x − b·y of its corners is less than the bound, or the least
/// x − d·y greater. Any slopes b and d do; what is chosen makes the space narrow only.
///
/// In binary64, with u = 2⁻⁵³ and X, Y not less than any |x|, |y| of the ends and of the boxes: x − b·y errs by 3u(X +
/// |b|Y), for the product and the difference; the far end p + v by uX along x and uY along y, once more where a bound
/// is computed of it; and a bound by 2u(X + |b|Y) more, as `slack` is taken off it. In all less than 12u(X + |b|Y) and
/// some roundings of what underflows, each within 2⁻¹⁰⁷⁵ (proofs/Beams.v: low_side_keeps, high_side_keeps); what is
/// taken off is 32u(X + |b|Y) and the least normal number. Rays are ordinary, and boxes finite in binary32: nothing
/// overflows.

#include <array>
#include <cstddef>

#include "durero/accel/wide_node.hpp"

namespace durero::accel {

/// The space between six planes.
struct WideBeam {
  /// A side of it: x − slope·y and `bound` are in order.
  struct Side {
    double slope = 0;  ///< of the axis `along`
    double bound = 0;  ///< with the slack that roundings need
  };

  std::size_t along = 0;                ///< the axis of y
  std::array<std::size_t, 2> across{};  ///< the axes of x
  double from = 0, to = 0;              ///< y is between them
  std::array<Side, 2> low{}, high{};    ///< of each axis across
  double width = 0;                     ///< how far two sides are apart, within the box of the scene
};

/// Of the rays that walk, to t = 1, in the box of a scene; of those whose limit is below 0, the origins. Where its
/// width is not finite it says nothing. Precondition: all other limits are 1.
WideBeam beam_of(const WideBundle& bundle, const surface::Box& all);

/// A bit for each child whose box may hold a point of such a segment, the first child's lowest. Precondition: the width
/// is finite, and the node is of the scene.
unsigned met(const WideNode& node, const WideBeam& beam);

}  // namespace durero::accel
