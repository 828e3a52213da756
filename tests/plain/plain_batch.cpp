// The uncertified closed forms in lanes, and the batch over them.
#define HWY_TARGET_INCLUDE "plain/plain_batch.cpp"  // as seen from tests/
#include "lanes/for_each_target.hpp"
//
#include "durero/trace/candidates.hpp"
#include "plain/plain.hpp"
#include "trace/packet_lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::trace::plain {
namespace HWY_NAMESPACE {
namespace {

namespace base = durero::trace::HWY_NAMESPACE;
using base::LaneElement;
using base::LaneMask;
using base::LaneRay;
using base::Lanes;
using LaneVec = base::Vec<Lanes>;
using model::Tipo;

struct LaneQuadratic {
  Lanes A, B, C, D, s0, s1;
  Lanes margin = 0;
};

HWY_INLINE Lanes square(Lanes x) { return x * x; }
HWY_INLINE Lanes square(const LaneVec& x) { return dot(x, x); }
HWY_INLINE Lanes least(Lanes a, Lanes b) { return choose(a < b, a, b); }

HWY_INLINE LaneQuadratic quadratic_of(const LaneElement<Tipo::soy_triangulo>& e, const LaneRay& ray) {
  const auto& [a, b, c] = e.vertices;
  const LaneVec e1 = base::difference<Lanes>(b, a), e2 = base::difference<Lanes>(c, a);
  const LaneVec q0 = base::difference<Lanes>(ray.p, a), v_e2 = cross(ray.v, e2), q_e1 = cross(q0, e1);
  const Lanes det = dot(e1, v_e2), side = choose(det < 0, Lanes(-1), Lanes(1));
  const Lanes ca = side * dot(q0, v_e2), ab = side * dot(ray.v, q_e1);
  const Lanes B = det * -0.5;
  return {0, B, dot(e2, q_e1), square(B), 0, 0, least(least(ab, ca), abs(det) - ab - ca)};
}

template <Tipo tipo>
HWY_INLINE LaneQuadratic quadratic_of(const LaneElement<tipo>& e, const LaneRay& ray) {
  const LaneVec q0 = base::difference<Lanes>(ray.p, e.centro);
  const LaneVec& v = ray.v;
  if constexpr (tipo == Tipo::soy_esfera) {
    const Lanes A = square(v), r2 = square(e.radio);
    return {A, dot(q0, v), square(q0) - r2, r2 * A - square(cross(q0, v)), 0, 0};
  } else {
    const Lanes s0 = dot(q0, e.vector), s1 = dot(v, e.vector);
    const LaneVec a = across(v, s1, e.vector), b = across(q0, s0, e.vector);
    if constexpr (tipo == Tipo::soy_plano || tipo == Tipo::soy_disco) {
      const Lanes B = s1 * 0.5;
      const Lanes margin = tipo == Tipo::soy_plano ? Lanes(0) : e.radio * abs(s1) - length(combination(s1, q0, -s0, v));
      return {0, B, s0, square(B), 0, 0, margin};
    } else if constexpr (tipo == Tipo::soy_cilindro) {
      const Lanes A = square(a), r2 = square(e.radio);
      return {A, dot(b, a), square(b) - r2, r2 * A - square(cross(b, a)), s0, s1};
    } else if constexpr (tipo == Tipo::soy_tronco) {
      const Lanes rho = e.radio + e.proporcion * (e.altura - s0), slope = e.proporcion * s1;
      const Lanes D = square(combination(rho, a, slope, b)) - square(cross(b, a));
      return {square(a) - square(slope), dot(b, a) + rho * slope, square(b) - square(rho), D, s0, s1};
    } else {
      static_assert(tipo == Tipo::soy_cono);
      const Lanes k2 = square(e.proporcion), g = e.altura - s0;
      const Lanes D = k2 * square(combination(g, a, s1, b)) - square(cross(b, a));
      return {square(a) - k2 * square(s1), dot(b, a) + k2 * g * s1, square(b) - k2 * square(g), D, s0, s1};
    }
  }
}

template <Tipo tipo>
HWY_INLINE LaneMask within(const LaneQuadratic& f, Lanes altura, Lanes t) {
  if constexpr (tipo == Tipo::soy_esfera || base::is_linear(tipo)) return (t > 0) & (f.margin >= 0);
  const Lanes s = f.s0 + t * f.s1;
  return (t > 0) & (s >= 0) & (s <= altura);
}

template <Tipo tipo>
HWY_INLINE void first_of(const Packet& packet, Firsts& firsts) {
  firsts.hit = firsts.undecided = 0;
  for (std::size_t at = 0; at < Packet::size; at += base::lanes()) {
    const LaneElement<tipo> e = base::element<tipo>(packet, at);
    const LaneQuadratic f = quadratic_of(e, base::rays(packet, at));
    const Lanes S = sqrt(f.D);
    const Lanes q = -(f.B + choose(f.B < 0, -S, S));
    // Where A is 0 for every ray C/q is the one root.
    const Lanes of_C = f.C / q, of_A = base::is_linear(tipo) ? of_C : q / f.A;
    const Lanes near = choose(of_A < of_C, of_A, of_C), far = choose(of_A < of_C, of_C, of_A);
    const LaneMask at_near = within<tipo>(f, e.altura, near), at_far = within<tipo>(f, e.altura, far);
    choose(at_near, near, far).store(&firsts.t[at]);
    const LaneMask no_roots = q == 0;
    const LaneMask special = (f.D >= 0) & (base::is_linear(tipo) ? no_roots : no_roots | (f.A == 0));
    firsts.undecided |= base::bits(special) << at;
    firsts.hit |= base::bits((f.D >= 0) & !special & (at_near | at_far)) << at;
  }
}

void first_packet(const Packet& packet, Tipo tipo, Firsts& firsts) {
  scene::with_shape(tipo,
                    [&]<class Shape>(std::type_identity<Shape>) HWY_ATTR { first_of<Shape::tipo>(packet, firsts); });
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace durero::trace::plain
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace durero::trace::plain {
namespace {

HWY_EXPORT(first_packet);

struct Plain {
  using Findings = Firsts;
  struct Point {
    double t = no_limit;
    double low() const { return t; }
    double high() const { return t; }
  };

  static void triage(const Packet& packet, model::Tipo tipo, Firsts& firsts) { first(packet, tipo, firsts); }
  static std::pair<double, double> bounds(const Firsts& firsts, std::size_t lane) {
    return {firsts.t[lane], firsts.t[lane]};
  }
  static Point point(const Firsts& firsts, std::size_t lane) { return {firsts.t[lane]}; }

  void miss(std::uint32_t number) const { hits[number] = {}; }
  void hit(std::uint32_t number, const Ray& ray, const Tables& tables, scene::ElementRef own,
           const Point& point) const {
    scene::Hit& hit = hits[number];
    hit.resultado = model::Resultado::hit;
    hit.t = point.t;
    hit.punto = ray.p + point.t * ray.v;
    hit.elementos.push_back(tables.element(own));
  }

  std::span<scene::Hit> hits;
};

}  // namespace

void first(const Packet& packet, model::Tipo tipo, Firsts& firsts) {
  HWY_DYNAMIC_DISPATCH(first_packet)(packet, tipo, firsts);
}

std::vector<scene::Hit> first_hits(const Tables& tables, std::span<const scene::Query> queries) {
  std::vector<scene::Hit> hits(queries.size());
  for_each_block(queries.size(), [&](std::size_t begin, std::size_t count) {
    const auto block = queries.subspan(begin, count);
    Plain kernel{std::span(hits).subspan(begin, count)};
    Batch batch(tables, block, kernel);
    batch.answer();
    batch.for_each_alone(
        [&](std::uint32_t number) { hits[begin + number] = first_hit(tables, block[number].rayo, block[number].en); });
  });
  return hits;
}

}  // namespace durero::trace::plain
#endif
