#pragma once
/// The hits of a bundle in binary32 (trace/single_rays.hpp) are computed in binary64 and rounded once, in lanes, while
/// its rays are in columns.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "durero/scene/hit.hpp"
#include "durero/scene/query.hpp"
#include "durero/scene/scene.hpp"
#include "durero/trace/picked.hpp"
#include "durero/trace/single_rays.hpp"
#include "durero/trace/triangle_block.hpp"

namespace durero::trace {

/// The triangle that each ray of a bundle hits, in columns. Places without a hit mean nothing.
struct HitTriangles {
  /// Of each vertex: x, y and z.
  alignas(64) std::array<SingleRays::Columns, 3> vertices{};
  SingleRays::Names elements{};  ///< the row of each triangle in the scene

  /// Sets a place to a triangle of a block.
  void set(std::size_t place, const TriangleBlock& block, std::size_t lane) {
    const std::array numbers{block.number(0, lane), block.number(1, lane), block.number(2, lane)};
    const std::array columns{block.column(0), block.column(1), block.column(2)};
    for (std::size_t i = 0; i < vertices.size(); ++i)
      for (std::size_t axis = 0; axis < 3; ++axis) vertices[i][axis][place] = columns[axis][numbers[i]];
    elements[place] = block.element(lane);
  }
};

/// t and the point of each hit of a bundle, rounded once; they mean something only at certain places.
struct RoundedRays {
  alignas(64) SingleRays::Doubles t{};         ///< t!
  std::array<SingleRays::Doubles, 3> point{};  ///< punto!, by axis
  std::uint64_t certain = 0;                   ///< a bit for each place
};

/// Rounds the hits of the rays in `which` on these triangles; it is certain of those that Newton's step improves
/// enough. Preconditions: the rays meet the triangles, are rounded (round_to_single), and the triangles are ordinary.
void round_hits(const SingleRays& rays, const HitTriangles& triangles, std::uint64_t which, RoundedRays& rounded);

/// Writes the hits of bundles, whose triangles are known.
class FoundHits {
 public:
  /// The references must outlive it. Precondition: `hits` has a place for each query.
  FoundHits(const scene::Scene& scene, IndexedView<const scene::Query> queries, IndexedView<scene::Hit> hits)
      : scene_(scene), queries_(queries), hits_(hits) {}

  /// Writes the hits and misses of the rays in `which` of a bundle, whose first ray has this number. source.block(name)
  /// is the block of a triangle that the bundle names. Precondition: the triangles are ordinary, and each ray meets the
  /// one that is found, on which it does not start.
  template <class Source>
  void answer(std::uint32_t first, const SingleRays& rays, std::uint64_t which, const Source& source) {
    std::uint64_t met = 0;
    for (std::uint64_t left = which; left != 0; left &= left - 1) {
      const auto place = static_cast<std::size_t>(std::countr_zero(left));
      const std::uint32_t name = rays.found(place);
      if (name == SingleRays::none) continue;
      met |= SingleRays::bit(place);
      triangles_.set(place, source.block(name), name % TriangleBlock::size);
    }
    write(first, rays, which, met);
  }

 private:
  void write(std::uint32_t first, const SingleRays& rays, std::uint64_t which, std::uint64_t met);
  RoundedPoint rounded_alone(std::uint32_t number, scene::ElementRef e) const;

  const scene::Scene& scene_;
  IndexedView<const scene::Query> queries_;
  IndexedView<scene::Hit> hits_;
  HitTriangles triangles_;
  RoundedRays rounded_;
};

}  // namespace durero::trace
