#pragma once
/// Coherent rays in columns of binary32, and a test of them against triangles of binary32 that decides most pairs
/// without binary64. It says hit or miss only where its bounds prove it (src/trace/screen-inl.hpp). The rays that it
/// cannot decide are handed back, to be answered in binary64 from the beginning.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>

#include "durero/trace/finding.hpp"
#include "durero/trace/ray.hpp"
#include "durero/trace/triangle_block.hpp"

namespace durero::trace {

/// Up to 64 rays that are answered together, and what is known of each. Sets of rays have a bit for each place.
struct SingleRays {
  static constexpr std::size_t size = 64;         ///< rays at most
  static constexpr std::size_t eight = 8;         ///< rays that lanes test side by side
  using Column = std::array<float, size>;         ///< a number of each ray
  using Columns = std::array<Column, 3>;          ///< by axis
  using Doubles = std::array<double, size>;       ///< a number of each ray, as stored
  using Names = std::array<std::uint32_t, size>;  ///< a name of each ray

  /// The greatest magnitude of coordinates, of rays and triangles, and of components of directions; the least magnitude
  /// of the latter, but for 0, is its inverse. Within this range nothing overflows in binary32, and the bounds allow
  /// for what underflows.
  static constexpr double range = 0x1p30;
  /// The name of no triangle.
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  /// Removes all rays.
  void clear() { count = 0; }
  /// Adds a ray that starts on the triangle `from`, or on none. Precondition: there are less than 64.
  void push(const glm::dvec3& origin, const glm::dvec3& direction, std::uint32_t from) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<int>(axis);
      stored_p[axis][count] = origin[i], stored_v[axis][count] = direction[i];
    }
    start[count++] = from;
  }

  /// Takes those of some rays that are open out of the search, and adds them to a set.
  void close(std::uint64_t which, std::uint64_t& set) {
    which &= open;
    set |= which, open &= ~which;
    for (; which != 0; which &= which - 1) limit[static_cast<std::size_t>(std::countr_zero(which))] = -1;
  }
  /// The set of one place.
  static constexpr std::uint64_t bit(std::size_t place) { return std::uint64_t{1} << place; }

  /// @{ The answer of a ray that is not handed back: the nearest triangle, or none; whether it meets any.
  std::uint32_t found(std::size_t place) const { return low[place] < no_limit ? nearest[place] : none; }
  bool meets(std::size_t place) const { return (hit >> place & 1) != 0; }
  /// @}

  std::size_t count = 0;  ///< the rays, at the first places
  /// @{ Origins and directions, by axis.
  alignas(64) std::array<Doubles, 3> stored_p{};
  std::array<Doubles, 3> stored_v{};
  /// @}
  /// @{ p to the nearest binary32, the rest of p, and v, each rounded once.
  Columns p{}, rest{}, v{};
  /// @}
  Column rate{};   ///< 12u·|v|, with u = 2⁻²⁴ and the sum of the components' magnitudes for |v|
  Column slack{};  ///< 8u·|p| and the allowance for underflow, which pay for the rounding of p
  /// @{ Bounds of the nearest hit's parameter, infinite without one. The upper one of a ray that is not open is
  /// negative. An any-hit search keeps the upper one at 1.
  Column low{}, limit{};
  /// @}
  Names nearest{};            ///< the nearest triangle, where `low` is finite
  Names start{};              ///< the triangle that each starts on, or none
  std::uint64_t open = 0;     ///< the rays that are searched
  std::uint64_t left = 0;     ///< the rays that are handed back
  std::uint64_t hit = 0;      ///< the rays of an any-hit search that are known to meet a triangle
  std::uint64_t crossed = 0;  ///< the rays that are known to cross the plane of the triangle that they start on
};

/// Rounds the rays to binary32, and opens all of them. False where some number is out of range: then nothing is open.
/// Empty places are filled with the last ray. Precondition: there is a ray.
bool round_to_single(SingleRays& rays);

/// A search is for the nearest hit, or for any hit at 0 < t < 1.
enum class SingleSearch : std::uint8_t { nearest, any };

/// Tests the rays in `which` against the triangles of a block, whose names count up from `first`. Lanes without a bit
/// in `triangles` are known to be missed by all of these rays, and may be passed over. Preconditions: the rays are
/// open, and the triangles' coordinates within range.
void screen(const TriangleBlock& block, std::uint32_t first, unsigned triangles, std::uint64_t which,
            SingleSearch search, SingleRays& rays);

/// Whether the triangles in a source's blocks are within range: source.single_blocks(), where it has blocks.
template <class Source>
bool has_single_blocks(const Source& source) {
  if constexpr (requires { source.single_blocks(); }) {
    return source.single_blocks();
  } else {
    return false;
  }
}

/// Whether the test in binary32 serves a ray: its numbers are within range.
bool in_single_range(const Ray& ray);

/// The triangles of a block that a ray may meet at 0 < t ≤ limit, a bit each; the test in binary32 proves that it
/// misses the others. Preconditions: in_single_range(ray), and the triangles' coordinates are within range.
unsigned possible_hits(const Ray& ray, const TriangleBlock& block, double limit);

}  // namespace durero::trace
