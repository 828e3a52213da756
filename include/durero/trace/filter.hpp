#pragma once
/// A filter that tests rays against balls in a few operations, and passes over a ball only where the ray certainly
/// misses it.
///
/// Let a ball have centre m and radius R, and let q = p − m and B = q·v. A point p + t·v of the ball implies |q × v| ≤
/// R|v|, and |v|²·t between −B − R|v| and −B + R|v|. A ray therefore misses the ball where |q × v|² > R²|v|², where B >
/// R|v| (the ball lies behind), and up to the limit where −B − R|v| > limit·|v|². In binary64, with u = 2⁻⁵³: q × v
/// errs by 3u of the products it is made of, in length at most 3u·√2·|q||v|; B by 4u|q||v|. As |q| ≤ |p| + |m|, R +
/// 16u(|p.x| + |p.y| + |p.z|) + 16u(|m.x| + |m.y| + |m.z|) in place of R pays for both, and for the rounding of B +
/// R|v|; the last term is part of the stored radius. |v|² and |v| are taken greater by 60u and 30u, which pays for all
/// roundings relative to their result, fewer than ten. Nothing overflows, because elements and rays here are
/// `ordinary`.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "durero/surface/bounds.hpp"
#include "durero/trace/ray.hpp"

namespace durero::trace {

/// Balls in columns, with radii that include the ball's part of the allowance. The columns are padded to whole blocks
/// with NaN, which no ray meets.
struct Balls {
  static constexpr std::size_t block = 8;  ///< balls that are tested together
  std::vector<double> x, y, z, radius;     ///< a column each

  /// Adds a ball. Precondition: pad() was not called yet.
  void push_back(const surface::Ball& ball);
  /// Fills the last block.
  void pad();
};

/// Writes to `passed` the places in begin … end of the balls that the ray may meet at 0 < t ≤ limit, in ascending
/// order, and answers their number. Preconditions: the ray is ordinary; the balls are padded; begin is a multiple of
/// Balls::block; `passed` has room for end − begin, rounded up to whole blocks.
std::size_t filter(const Balls& balls, const Ray& ray, double limit, std::size_t begin, std::size_t end,
                   std::uint32_t* passed);

}  // namespace durero::trace
