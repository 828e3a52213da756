// The triage in lanes: of packets, and of rays in columns.
#define HWY_TARGET_INCLUDE "trace/packet.cpp"  // as seen from src/
#include "lanes/for_each_target.hpp"
//
#include "trace/closed_form-inl.hpp"
#include "trace/packet_lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::trace {
namespace HWY_NAMESPACE {
namespace {

/// Stores the findings of a quadratic into the lanes from `at` on.
HWY_INLINE void keep(const BoundedQuadratic<Lanes>& f, const LanesFound<Lanes>& found, std::size_t at,
                     Findings& findings) {
  found.root.t.store(&findings.t[at]);
  found.root.error.store(&findings.error[at]);
  found.slope.store(&findings.at_root[at]);
  found.slope_error.store(&findings.at_root_error[at]);
  f.A.store(&findings.A[at]);
  f.A_error.store(&findings.A_error[at]);
  findings.hit |= bits(found.hit) << at;
  findings.undecided |= bits(found.undecided) << at;
}

/// Stores find(quadratic) for every lane.
template <model::Tipo tipo, class Find>
HWY_INLINE void find_in(const Packet& packet, Findings& findings, Find find) {
  findings.hit = findings.undecided = 0;
  for (std::size_t at = 0; at < Packet::size; at += lanes()) {
    const BoundedQuadratic<Lanes> f = quadratic<Lanes>(element<tipo>(packet, at), rays(packet, at));
    keep(f, find(f), at, findings);
  }
}

void triage_packet(const Packet& packet, model::Tipo tipo, Findings& findings) {
  scene::with_shape(tipo, [&]<class Shape>(std::type_identity<Shape>) HWY_ATTR {
    find_in<Shape::tipo>(packet, findings,
                         [](const BoundedQuadratic<Lanes>& f) HWY_ATTR { return found_in_lanes<Shape::tipo>(f); });
  });
}

/// The lanes of `some` whose line may meet the surface. The other lanes miss it, by the first test of first_in_lanes.
template <model::Tipo tipo>
HWY_INLINE unsigned not_missed(const BoundedQuadratic<Lanes>& f, unsigned some) {
  if constexpr (is_linear(tipo)) return some;
  return some & ~bits(f.F < -f.B_error);
}

/// Stores find(quadratic) for the rays in `which`, but of lanes that skip(quadratic, used) answers true for.
template <class Skip, class Find>
HWY_INLINE void find_in_columns(const RayColumns& rays, std::uint64_t which, scene::ShapeView of,
                                ColumnFindings& findings, Skip skip, Find find) {
  of.visit([&]<class Shape>(const Shape& shape) HWY_ATTR {
    const LaneElement<Shape::tipo> element = in_every_lane(shape);
    for (std::size_t eight = 0; which != 0; ++eight, which >>= Packet::size) {
      if ((which & ((1u << Packet::size) - 1)) == 0) continue;
      Findings& own = findings[eight];
      own.hit = own.undecided = 0;
      for (std::size_t at = 0; at < Packet::size; at += lanes()) {
        const std::size_t place = eight * Packet::size + at;
        const auto used = static_cast<unsigned>(which >> at & ((1u << lanes()) - 1));
        const LaneRay some{load(rays.p, place), load(rays.v, place), Lanes::load(&rays.speed[place])};
        const BoundedQuadratic<Lanes> f = quadratic<Lanes>(element, some);
        if (!skip(Of<Shape::tipo>(), f, used)) keep(f, find(Of<Shape::tipo>(), f), at, own);
      }
    }
  });
}

void triage_columns(const RayColumns& rays, std::uint64_t which, scene::ShapeView of, ColumnFindings& findings) {
  find_in_columns(
      rays, which, of, findings,
      []<model::Tipo tipo>(Of<tipo>, const BoundedQuadratic<Lanes>& f, unsigned used)
          HWY_ATTR { return not_missed<tipo>(f, used) == 0; },
      []<model::Tipo tipo>(Of<tipo>, const BoundedQuadratic<Lanes>& f) HWY_ATTR { return found_in_lanes<tipo>(f); });
}

void triage_columns_from(const RayColumns& rays, std::uint64_t which, scene::ShapeView of, ColumnFindings& findings) {
  find_in_columns(
      rays, which, of, findings, [](auto, const BoundedQuadratic<Lanes>&, unsigned used) HWY_ATTR { return used == 0; },
      []<model::Tipo tipo>(Of<tipo>, const BoundedQuadratic<Lanes>& f)
          HWY_ATTR { return found_in_lanes_from<tipo>(f); });
}

void triage_block(const Ray& ray, const TriangleBlock& block, Findings& findings) {
  constexpr model::Tipo tipo = model::Tipo::soy_triangulo;
  const LaneRay everywhere{in_every_lane(ray.p), in_every_lane(ray.v), Lanes(ray.speed)};
  findings.hit = findings.undecided = 0;
  TriangleBlock::Columns vertices;
  unpack(block, vertices);
  for (std::size_t at = 0; at < TriangleBlock::size; at += lanes()) {
    const BoundedQuadratic<Lanes> f = quadratic<Lanes>(widened_triangles(vertices, at), everywhere);
    keep(f, found_in_lanes<tipo>(f), at, findings);
  }
  findings.hit &= block.lanes(), findings.undecided &= block.lanes();
}

std::uint64_t starting_in_columns(const RayColumns& rays, std::uint64_t which, std::uint64_t start) {
  const hn::Rebind<std::uint64_t, LaneTag> tag;
  std::uint64_t found = 0;
  for (std::size_t at = 0; at < RayColumns::size; at += lanes()) {
    const auto same = hn::Eq(hn::Load(tag, &rays.start[at]), hn::Set(tag, start));
    found |= std::uint64_t{bits({hn::RebindMask(LaneTag(), same)})} << at;
  }
  return found & which;
}

void triage_packet_from(const Packet& packet, model::Tipo tipo, Findings& findings) {
  scene::with_shape(tipo, [&]<class Shape>(std::type_identity<Shape>) HWY_ATTR {
    find_in<Shape::tipo>(packet, findings,
                         [](const BoundedQuadratic<Lanes>& f) HWY_ATTR { return found_in_lanes_from<Shape::tipo>(f); });
  });
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace durero::trace
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace durero::trace {
namespace {

HWY_EXPORT(triage_packet);
HWY_EXPORT(triage_columns);
HWY_EXPORT(triage_columns_from);
HWY_EXPORT(triage_block);
HWY_EXPORT(triage_packet_from);
HWY_EXPORT(starting_in_columns);

}  // namespace

void triage(const Packet& packet, model::Tipo tipo, Findings& findings) {
  HWY_DYNAMIC_DISPATCH(triage_packet)(packet, tipo, findings);
}
std::uint64_t starting_on(const RayColumns& rays, std::uint64_t which, scene::ElementRef own) {
  return HWY_DYNAMIC_DISPATCH(starting_in_columns)(rays, which, RayColumns::number(own));
}
void triage(const RayColumns& rays, std::uint64_t which, scene::ShapeView element, ColumnFindings& findings) {
  HWY_DYNAMIC_DISPATCH(triage_columns)(rays, which, element, findings);
}
void triage(const Ray& ray, const TriangleBlock& block, Findings& findings) {
  HWY_DYNAMIC_DISPATCH(triage_block)(ray, block, findings);
}
void triage_from(const RayColumns& rays, std::uint64_t which, scene::ShapeView element, ColumnFindings& findings) {
  HWY_DYNAMIC_DISPATCH(triage_columns_from)(rays, which, element, findings);
}
void triage_from(const Packet& packet, model::Tipo tipo, Findings& findings) {
  HWY_DYNAMIC_DISPATCH(triage_packet_from)(packet, tipo, findings);
}

}  // namespace durero::trace
#endif
