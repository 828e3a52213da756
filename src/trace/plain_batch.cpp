// The uncertified closed forms in lanes, and the batch over them.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trace/plain_batch.cpp"  // as seen from src/
#include <hwy/foreach_target.h>
//
#include "durero/trace/batch.hpp"
#include "durero/trace/pack_lanes-inl.hpp"
#include "durero/trace/plain.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::trace::plain {
namespace HWY_NAMESPACE {
namespace {

namespace base = durero::trace::HWY_NAMESPACE;
using base::LaneBeam;
using base::LaneElement;
using base::LaneMask;
using base::Lanes;
using LaneVec = base::Vec<Lanes>;
using model::Tipo;

struct LaneQuadratic {
  Lanes A, B, C, D, s0, s1;
};

HWY_INLINE Lanes square(Lanes x) { return x * x; }
HWY_INLINE Lanes square(const LaneVec& x) { return dot(x, x); }

template <Tipo tipo>
HWY_INLINE LaneQuadratic quadratic_of(const LaneElement<tipo>& e, const LaneBeam& ray) {
  const LaneVec q0 = base::difference<Lanes>(ray.p, e.centro);
  const LaneVec& v = ray.v;
  if constexpr (tipo == Tipo::soy_esfera) {
    const Lanes A = square(v), r2 = square(e.radio);
    return {A, dot(q0, v), square(q0) - r2, r2 * A - square(cross(q0, v)), 0, 0};
  } else {
    const Lanes s0 = dot(q0, e.vector), s1 = dot(v, e.vector);
    const LaneVec a = across(v, s1, e.vector), b = across(q0, s0, e.vector);
    if constexpr (tipo == Tipo::soy_cilindro) {
      const Lanes A = square(a), r2 = square(e.radio);
      return {A, dot(b, a), square(b) - r2, r2 * A - square(cross(b, a)), s0, s1};
    } else {
      const Lanes k2 = square(e.proporcion), g = e.altura - s0;
      const Lanes D = k2 * square(combination(g, a, s1, b)) - square(cross(b, a));
      return {square(a) - k2 * square(s1), dot(b, a) + k2 * g * s1, square(b) - k2 * square(g), D, s0, s1};
    }
  }
}

template <Tipo tipo>
HWY_INLINE LaneMask within(const LaneQuadratic& f, Lanes altura, Lanes t) {
  if constexpr (tipo == Tipo::soy_esfera) return t > 0;
  const Lanes s = f.s0 + t * f.s1;
  return (t > 0) & (s >= 0) & (s <= altura);
}

template <Tipo tipo>
HWY_INLINE void first_of(const Pack& pack, Firsts& firsts) {
  firsts.hit = firsts.undecided = 0;
  for (std::size_t at = 0; at < Pack::size; at += base::lanes()) {
    const LaneElement<tipo> e = base::element<tipo>(pack, at);
    const LaneQuadratic f = quadratic_of(e, base::beam(pack, at));
    const Lanes S = sqrt(f.D);
    const Lanes q = -(f.B + choose(f.B < 0, -S, S));
    const Lanes one = q / f.A, other = f.C / q;
    const Lanes near = choose(one < other, one, other), far = choose(one < other, other, one);
    const LaneMask near_one = within<tipo>(f, e.altura, near), far_one = within<tipo>(f, e.altura, far);
    choose(near_one, near, far).store(&firsts.t[at]);
    const LaneMask special = (f.D >= 0) & ((f.A == 0) | (q == 0));
    firsts.undecided |= base::bits(special) << at;
    firsts.hit |= base::bits((f.D >= 0) & !special & (near_one | far_one)) << at;
  }
}

void first_pack(const Pack& pack, Tipo tipo, Firsts& firsts) {
  switch (tipo) {
    case Tipo::soy_esfera:
      return first_of<Tipo::soy_esfera>(pack, firsts);
    case Tipo::soy_cilindro:
      return first_of<Tipo::soy_cilindro>(pack, firsts);
    default:
      return first_of<Tipo::soy_cono>(pack, firsts);
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace durero::trace::plain
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace durero::trace::plain {
namespace {

HWY_EXPORT(first_pack);

struct Plain {
  using Findings = Firsts;
  struct Point {
    double t = no_limit;
    double low() const { return t; }
    double high() const { return t; }
  };

  static void triage(const Pack& pack, model::Tipo tipo, Firsts& firsts) { first(pack, tipo, firsts); }
  static Point point(const Firsts& firsts, std::size_t lane) { return {firsts.t[lane]}; }

  void hit(std::uint32_t ray, const Beam& beam, scene::ElementRef e, const Point& point) {
    scene::Hit& hit = hits[ray];
    hit.resultado = model::Resultado::hit;
    hit.t = point.t;
    hit.punto = beam.p + point.t * beam.v;
    hit.elementos.push_back(e);
  }

  void alone(std::uint32_t ray) {
    const scene::Query& query = queries[ray];
    hits[ray] = first_hit(tables, query.rayo, query.en);
  }

  const Tables& tables;
  std::span<const scene::Query> queries;
  std::span<scene::Hit> hits;
};

}  // namespace

void first(const Pack& pack, model::Tipo tipo, Firsts& firsts) { HWY_DYNAMIC_DISPATCH(first_pack)(pack, tipo, firsts); }

std::vector<scene::Hit> first_hits(const Tables& tables, std::span<const scene::Query> queries) {
  std::vector<scene::Hit> hits(queries.size());
  for_each_block(queries.size(), [&](std::size_t begin, std::size_t count) {
    const auto block = queries.subspan(begin, count);
    Plain engine{tables, block, std::span(hits).subspan(begin, count)};
    Batch(tables, block, engine).answer();
  });
  return hits;
}

}  // namespace durero::trace::plain
#endif
