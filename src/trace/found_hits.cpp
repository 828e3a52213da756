// The hits of bundles, rounded in lanes.
#define HWY_TARGET_INCLUDE "trace/found_hits.cpp"  // as seen from src/
#include "lanes/for_each_target.hpp"
//
#include "durero/trace/found_hits.hpp"
#include "trace/closed_form-inl.hpp"
#include "trace/packet_lanes-inl.hpp"
#include "trace/range.hpp"
#include "trace/rounding-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::trace {
namespace HWY_NAMESPACE {
namespace {

/// Whether a number is 0 or of magnitude 2⁻¹⁰⁰ at least.
HWY_INLINE LaneMask not_too_small(Lanes x) { return (abs(x) >= least_ordinary) | (x == 0.0); }

/// The rays whose origins are ordinary; their other numbers are, within the range of binary32.
HWY_INLINE LaneMask ordinary_origins(const LaneRay& ray) {
  return not_too_small(ray.p.x) & not_too_small(ray.p.y) & not_too_small(ray.p.z);
}

/// Rounds the hits of the rays from a place on. The lanes that are certain: each ray meets its triangle, so the root of
/// the plane is the hit's, and no edge is asked about.
HWY_INLINE unsigned round_lanes_at(const SingleRays& rays, const HitTriangles& triangles, std::size_t at,
                                   RoundedRays& rounded) {
  constexpr model::Tipo tipo = model::Tipo::soy_triangulo;
  const Vec<Lanes> v = load(rays.stored_v, at);
  const LaneRay ray{load(rays.stored_p, at), v, extent(v)};
  const LaneElement<tipo> triangle = widened_triangles(triangles.vertices, at);
  const BoundedQuadratic<Lanes> f = quadratic<Lanes>(triangle, ray);
  const Root<Lanes> root = root_of_linear(f);
  const RefinedRoot<Lanes> better =
      newton<Lanes>(root, {f.B, f.B_error}, {f.A, f.A_error}, power_at(root.t, triangle, ray));
  const OncePoint<Lanes> once = round_point_on(triangle, ray, better.t, better.error);
  once.t.store(&rounded.t[at]);
  once.x.store(&rounded.point[0][at]);
  once.y.store(&rounded.point[1][at]);
  once.z.store(&rounded.point[2][at]);
  return bits((abs(f.B) > 2 * f.B_error) & better.known & once.certain & ordinary_origins(ray));
}

void round_bundle(const SingleRays& rays, const HitTriangles& triangles, std::uint64_t which, RoundedRays& rounded) {
  rounded.certain = 0;
  for (std::uint64_t eights = eights_of(which); eights != 0; eights &= eights - 1) {
    const auto eight = static_cast<std::size_t>(std::countr_zero(eights));
    for (std::size_t at = eight; at < eight + Packet::size; at += lanes())
      rounded.certain |= std::uint64_t{round_lanes_at(rays, triangles, at, rounded)} << at;
  }
  rounded.certain &= which;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace durero::trace
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "durero/trace/certified.hpp"
#include "durero/trace/search.hpp"

namespace durero::trace {
namespace {
HWY_EXPORT(round_bundle);
}  // namespace

void round_hits(const SingleRays& rays, const HitTriangles& triangles, std::uint64_t which, RoundedRays& rounded) {
  HWY_DYNAMIC_DISPATCH(round_bundle)(rays, triangles, which, rounded);
}

void FoundHits::write(std::uint32_t first, const SingleRays& rays, std::uint64_t which, std::uint64_t met) {
  if (met != 0) round_hits(rays, triangles_, met, rounded_);
  constexpr std::size_t ahead = SingleRays::size;  // the next bundle's queries are read while answers are written
  for (; which != 0; which &= which - 1) {
    const auto place = static_cast<std::size_t>(std::countr_zero(which));
    const std::uint32_t number = first + static_cast<std::uint32_t>(place);
    if (number + ahead < queries_.size()) ask_for(queries_[number + ahead]);
    scene::Hit& hit = hits_[number];
    if ((met >> place & 1) == 0) {
      write_miss(hit);
      continue;
    }
    const scene::ElementRef e{model::Tipo::soy_triangulo, triangles_.elements[place]};
    const auto& [x, y, z] = rounded_.point;
    if ((rounded_.certain >> place & 1) != 0) {
      write_hit(hit, e, {true, rounded_.t[place], {x[place], y[place], z[place]}});
    } else {
      write_hit(hit, e, rounded_alone(number, e));
    }
  }
}

/// Computes and rounds a hit by the search of one ray.
RoundedPoint FoundHits::rounded_alone(std::uint32_t number, scene::ElementRef e) const {
  Counts unseen;
  const scene::Query& query = queries_[number];
  const Search search(scene_, query.rayo, query.en, unseen);
  return search.rounded_hit(e, search.meeting(e, no_limit));
}

}  // namespace durero::trace
#endif
