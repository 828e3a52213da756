#pragma once
/// A filter over balls that takes a few operations a ray and ball, and only ever passes over what the ray certainly
/// misses.
///
/// A point p + t·v of a ball of centre m and radius R, with q = p − m, B = q·v: |q × v| ≤ R|v|, and |v|²·t is between
/// −B − R|v| and −B + R|v|. So a ray misses the ball where |q × v|² > R²|v|², where B > R|v| (it lies behind), and up
/// to the limit where −B − R|v| > limit·|v|². In binary64, with u = 2⁻⁵³: q × v errs by 3u of the products it is made
/// of, in length at most 3u·√2·|q||v|; B by 4u|q||v|. As |q| ≤ |p| + |m|, R + 16u(|p.x| + |p.y| + |p.z|) + 16u(|m.x| +
/// |m.y| + |m.z|) in place of R pays for both, and for the rounding of B + R|v|; the last term is part of the stored
/// radius. |v|² and |v| are taken greater by 60u and 30u, which pays for all roundings relative to their result, fewer
/// than ten. Elements and rays that are not `ordinary` do not come here, so nothing overflows.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "durero/surface/bounds.hpp"
#include "durero/trace/ray.hpp"

namespace durero::trace {

/// Balls in columns, their radii with the part of the allowance that is theirs; padded to whole blocks with NaN, which
/// no ray meets.
struct Balls {
  static constexpr std::size_t block = 8;  ///< how many are tried together
  std::vector<double> x, y, z, radius;     ///< a column each

  /// Adds a ball. Precondition: not padded yet.
  void push_back(const surface::Ball& ball);
  /// Fills the last block up.
  void pad();
};

/// Writes to `passed` the places in begin … end of the balls that the ray may meet at 0 < t ≤ limit, ascending, and
/// returns their number. Preconditions: the ray is ordinary; begin is a multiple of Balls::block; `passed` has room
/// for end − begin, rounded up to whole blocks.
std::size_t filter(const Balls& balls, const Ray& ray, double limit, std::size_t begin, std::size_t end,
                   std::uint32_t* passed);

}  // namespace durero::trace
