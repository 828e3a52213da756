// The steps of the batch in columns that go through lanes.
#define HWY_TARGET_INCLUDE "trace/columns.cpp"  // as seen from src/
#include "lanes/for_each_target.hpp"
//
#include "durero/trace/columns.hpp"
#include "trace/packet_lanes-inl.hpp"
#include "trace/range.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::trace {
namespace HWY_NAMESPACE {
namespace {

/// Whether each number is 0 or in the range of ordinary ones, as pair_in_range has it.
HWY_INLINE LaneMask lanes_in_range(Lanes x) {
  const Lanes size = abs(x);
  return ((size >= least_ordinary) & (size <= greatest_ordinary)) | (size == 0.0);
}

std::uint64_t complete_columns(RayColumns& rays, std::size_t count) {
  std::uint64_t ordinary = 0;
  for (std::size_t at = 0; at < count; at += lanes()) {
    const Vec<Lanes> p = load(rays.p, at), v = load(rays.v, at);
    const LaneMask usual = lanes_in_range(p.x) & lanes_in_range(p.y) & lanes_in_range(p.z) & lanes_in_range(v.x) &
                           lanes_in_range(v.y) & lanes_in_range(v.z);
    const auto keep = [&](Lanes x, double* to) HWY_ATTR { choose(usual, x, Lanes(0.0)).store(to); };
    keep(p.x, &rays.p[0][at]), keep(p.y, &rays.p[1][at]), keep(p.z, &rays.p[2][at]);
    keep(v.x, &rays.v[0][at]), keep(v.y, &rays.v[1][at]), keep(v.z, &rays.v[2][at]);
    keep(extent(v), &rays.speed[at]);
    ordinary |= std::uint64_t{bits(usual)} << at;
  }
  return ordinary & ~std::uint64_t{} >> (RayColumns::size - count);
}

/// Calls visit(at, used) for the lanes from each `at` on that hold a ray of `which`, a bit of `used` each.
template <class Visit>
HWY_INLINE void for_lanes_of(std::uint64_t which, Visit visit) {
  for (std::uint64_t eights = eights_of(which); eights != 0; eights &= eights - 1) {
    const auto begin = static_cast<std::size_t>(std::countr_zero(eights));
    for (std::size_t at = begin; at < begin + Packet::size; at += lanes())
      visit(at, static_cast<unsigned>(which >> at & ((1u << lanes()) - 1)));
  }
}

/// A mask with these bits, the first lane's lowest.
HWY_INLINE LaneMask mask_of(unsigned bits) {
  const std::uint8_t stored[8] = {static_cast<std::uint8_t>(bits)};
  return {hn::LoadMaskBits(LaneTag(), stored)};
}

KeptBits keep_nearer_in_lanes(const ColumnFindings& findings, std::uint64_t which, std::uint64_t own,
                              NearestColumns& nearest) {
  const hn::Rebind<std::uint64_t, LaneTag> names;
  KeptBits kept;
  for_lanes_of(which, [&](std::size_t at, unsigned used) HWY_ATTR {
    const Findings& found = findings[at / Packet::size];
    const std::size_t lane = at % Packet::size;
    kept.open |= std::uint64_t{found.undecided >> lane & used} << at;
    const unsigned hit = found.hit >> lane & used;
    if (hit == 0) return;
    const Lanes t = Lanes::load(&found.t[lane]), error = Lanes::load(&found.error[lane]);
    const Lanes old_t = Lanes::load(&nearest.t[at]), old_error = Lanes::load(&nearest.error[at]);
    // Bounds of the parameters, as Findings::low and high have them.
    const LaneMask nearer = mask_of(hit) & !(t - error > old_t + old_error);
    const LaneMask apart = t + error < old_t - old_error;
    const auto blend = [&](Lanes x, double* to) HWY_ATTR { choose(nearer, x, Lanes::load(to)).store(to); };
    blend(t, &nearest.t[at]), blend(error, &nearest.error[at]);
    blend(Lanes::load(&found.at_root[lane]), &nearest.at_root[at]);
    blend(Lanes::load(&found.at_root_error[lane]), &nearest.at_root_error[at]);
    blend(Lanes::load(&found.A[lane]), &nearest.A[at]);
    blend(Lanes::load(&found.A_error[lane]), &nearest.A_error[at]);
    const auto to_names = hn::RebindMask(names, nearer.m);
    hn::Store(hn::IfThenElse(to_names, hn::Set(names, own), hn::Load(names, &nearest.own[at])), names,
              &nearest.own[at]);
    kept.nearer |= std::uint64_t{bits(nearer)} << at;
    kept.open |= std::uint64_t{bits(nearer & !apart)} << at;
  });
  return kept;
}

BlockedBits blocked_in_lanes(const ColumnFindings& findings, std::uint64_t which) {
  BlockedBits all;
  for_lanes_of(which, [&](std::size_t at, unsigned used) HWY_ATTR {
    const Findings& found = findings[at / Packet::size];
    const std::size_t lane = at % Packet::size;
    all.open |= std::uint64_t{found.undecided >> lane & used} << at;
    const unsigned hit = found.hit >> lane & used;
    if (hit == 0) return;
    const Lanes t = Lanes::load(&found.t[lane]), error = Lanes::load(&found.error[lane]);
    const unsigned before = bits(t + error < 1.0), behind = bits(t - error > 1.0);
    all.blocked |= std::uint64_t{hit & before} << at;
    all.open |= std::uint64_t{hit & ~before & ~behind} << at;
  });
  return all;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace durero::trace
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace durero::trace {
namespace {

HWY_EXPORT(complete_columns);
HWY_EXPORT(keep_nearer_in_lanes);
HWY_EXPORT(blocked_in_lanes);

}  // namespace

std::uint64_t complete(RayColumns& rays, std::size_t count) {
  return HWY_DYNAMIC_DISPATCH(complete_columns)(rays, count);
}
KeptBits keep_nearer(const ColumnFindings& findings, std::uint64_t which, scene::ElementRef own,
                     NearestColumns& nearest) {
  return HWY_DYNAMIC_DISPATCH(keep_nearer_in_lanes)(findings, which, RayColumns::number(own), nearest);
}
BlockedBits blocked_by(const ColumnFindings& findings, std::uint64_t which) {
  return HWY_DYNAMIC_DISPATCH(blocked_in_lanes)(findings, which);
}

}  // namespace durero::trace
#endif
