// The triage in lanes, and its columns.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trace/pack.cpp"  // as seen from src/
#include <hwy/foreach_target.h>
//
#include "durero/trace/closed_form-inl.hpp"
#include "durero/trace/pack_lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::trace {
namespace HWY_NAMESPACE {
namespace {

template <model::Tipo type>
HWY_INLINE void triage_of(const Pack& pack, Findings& findings) {
  findings.hit = findings.undecided = 0;
  for (std::size_t at = 0; at < Pack::size; at += lanes()) {
    const Quadratic<Lanes> f = quadratic<Lanes>(element<type>(pack, at), beam(pack, at));
    const LanesFound found = first_in_lanes(f);
    found.root.t.store(&findings.t[at]);
    found.root.error.store(&findings.error[at]);
    found.slope.store(&findings.at_root[at]);
    found.slope_error.store(&findings.at_root_error[at]);
    f.A.store(&findings.A[at]);
    f.A_error.store(&findings.A_error[at]);
    findings.hit |= bits(found.hit) << at;
    findings.undecided |= bits(found.undecided) << at;
  }
}

void triage_pack(const Pack& pack, model::Tipo tipo, Findings& findings) {
  switch (tipo) {
    case model::Tipo::soy_esfera:
      return triage_of<model::Tipo::soy_esfera>(pack, findings);
    case model::Tipo::soy_cilindro:
      return triage_of<model::Tipo::soy_cilindro>(pack, findings);
    default:
      return triage_of<model::Tipo::soy_cono>(pack, findings);
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace durero::trace
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace durero::trace {
namespace {

HWY_EXPORT(triage_pack);

}  // namespace

void triage(const Pack& pack, model::Tipo tipo, Findings& findings) {
  HWY_DYNAMIC_DISPATCH(triage_pack)(pack, tipo, findings);
}

}  // namespace durero::trace
#endif
