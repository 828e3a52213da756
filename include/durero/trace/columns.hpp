#pragma once
/// Rays of queries in columns, and what the triage finds on them: the nearest hits, or which segments are blocked. All
/// steps go through lanes.

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>

#include "durero/scene/element_ref.hpp"
#include "durero/scene/query.hpp"
#include "durero/trace/finding.hpp"
#include "durero/trace/packet.hpp"
#include "durero/trace/picked.hpp"
#include "durero/trace/ray.hpp"

namespace durero::trace {

/// Computes the speeds of the first `count` rays. The bits of those whose numbers are ordinary; the columns of the
/// others become zeros.
std::uint64_t complete(RayColumns& rays, std::size_t count);

/// The nearest hits so far of rays in columns, with the triage's findings on them.
struct NearestColumns {
  using Column = RayColumns::Column;  ///< a number of each ray

  /// @{ The member of that name of Findings. Without a hit t is ∞.
  alignas(64) Column t{};
  Column error{}, at_root{}, at_root_error{}, A{}, A_error{};
  /// @}
  std::array<std::uint64_t, RayColumns::size> own{};  ///< RayColumns::number of the element

  /// Forgets the hits.
  void clear() {
    t.fill(no_limit);
    error.fill(0);
  }
  /// The finding of a ray that has a hit.
  RootEstimate operator[](std::size_t place) const {
    return {Decision::hit, t[place], 0, error[place], {at_root[place], at_root_error[place], A[place], A_error[place]}};
  }
};

/// The rays that a finding concerns, a bit each.
struct KeptBits {
  std::uint64_t nearer = 0;  ///< whose nearest hit it becomes
  std::uint64_t open = 0;    ///< that the triage leaves open: it cannot decide, or not tell two points apart
};
/// Keeps the findings of the rays in `which` on one element where they are nearer.
KeptBits keep_nearer(const ColumnFindings& findings, std::uint64_t which, scene::ElementRef own,
                     NearestColumns& nearest);

/// The segments that an element concerns, a bit each.
struct BlockedBits {
  std::uint64_t blocked = 0;  ///< that it blocks
  std::uint64_t open = 0;     ///< of which the triage cannot tell
};
/// Reads the findings of the segments in `which`: a point at t < 1 blocks.
BlockedBits blocked_by(const ColumnFindings& findings, std::uint64_t which);

/// Queries whose rays stand in columns.
class QueryColumns {
 public:
  /// Takes the `count` queries from `begin` on. The bits of those that stand in columns; the others are left alone.
  template <class Source>
  std::uint64_t take(const Source& source, IndexedView<const scene::Query> queries, std::size_t begin,
                     std::size_t count) {
    std::uint64_t several = 0;
    some_start_ = false;
    for (std::size_t place = 0; place < count; ++place) {
      const scene::Query& query = queries[begin + place];
      set(place, query.rayo.p().xyz(), query.rayo.v().xyz());
      const bool starts = query.en.size() == 1;
      rays.set_start(place, starts ? source.own(query.en[0]) : nothing);
      some_start_ |= starts;
      several |= std::uint64_t{query.en.size() > 1} << place;
    }
    return complete(rays, count) & ~several;
  }
  /// The rays of `which` that start on an element.
  std::uint64_t starting_on(std::uint64_t which, scene::ElementRef own) const {
    return some_start_ ? trace::starting_on(rays, which, own) : 0;
  }
  /// The numbers of a ray.
  RayNumbers operator[](std::size_t place) const {
    const auto of = [&](const auto& columns) {
      return glm::dvec3(columns[0][place], columns[1][place], columns[2][place]);
    };
    return {of(rays.p), of(rays.v), rays.speed[place]};
  }

  RayColumns rays;  ///< the rays

 private:
  void set(std::size_t place, const glm::dvec3& p, const glm::dvec3& v) {
    rays.p[0][place] = p.x, rays.p[1][place] = p.y, rays.p[2][place] = p.z;
    rays.v[0][place] = v.x, rays.v[1][place] = v.y, rays.v[2][place] = v.z;
  }

  bool some_start_ = false;
};

}  // namespace durero::trace
