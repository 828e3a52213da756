#include <cmath>

#include "conform/families/candidate.hpp"
#include "conform/families/framed_shape.hpp"

namespace durero::conform {

using model::Resultado;
using number::sign;

bool mirrored_first(const AnsweredQuery& q) {
  if (q.hit.resultado == Resultado::no_minimum) return false;
  return any_element(q, [&](const ElementQuadratic& c) {
    return c.e.tipo == model::Tipo::soy_cono && any_root_ahead(c, [&](const Parameter& t) {
             const bool beyond = c.sign_beyond(t) > 0;
             return beyond && (!hits(q) || surface::exact::order(t, candidate(q, q.hit.elementos[0]).first()) < 0);
           });
  });
}

bool nearly_apex(const AnsweredQuery& q) {
  return any_element(q, [&](const ElementQuadratic& c) {
    if (!has_apex(c.e.tipo)) return false;
    const DyadicVector apex{Dyadic(c.centro.x) + Dyadic(c.altura) * Dyadic(c.vector.x),
                            Dyadic(c.centro.y) + Dyadic(c.altura) * Dyadic(c.vector.y),
                            Dyadic(c.centro.z) + Dyadic(c.altura) * Dyadic(c.vector.z)};
    const DyadicVector p = exact(q.query.rayo.p().xyz()), v = exact(q.query.rayo.v().xyz());
    const DyadicVector to{apex.x - p.x, apex.y - p.y, apex.z - p.z}, out = cross(to, v);
    return sign(dot(to, v)) > 0 && number::shifted(dot(out, out), 40) <= square(Dyadic(c.altura)) * dot(v, v);
  });
}

bool apex(const AnsweredQuery& q) {
  // On a cone with avance = altura the point is at the distance 0 from the axis.
  return any_hit_element(q,
                         [](const ElementQuadratic& c) { return has_apex(c.e.tipo) && c.sign_beyond(c.first()) == 0; });
}

bool nearly_rim(const AnsweredQuery& q) {
  return any_element(q, [](const ElementQuadratic& c) {
    return c.is_axial() && any_root_ahead(c, [&](const Parameter& t) {
             const double at = number::round_to_binary64(number::linear(c.f.s0, c.f.s1, t));
             const bool other_rim = !has_apex(c.e.tipo) && std::abs(c.altura - at) <= 0x1p-20 * c.altura;
             return std::abs(at) <= 0x1p-20 * c.altura || other_rim;
           });
  });
}

bool rim(const AnsweredQuery& q) {
  return any_hit_element(q, [&](const ElementQuadratic& c) { return c.is_at_end(c.first()) && !apex(q); });
}

bool inside(const AnsweredQuery& q) {
  return any_hit_element(q, [](const ElementQuadratic& c) { return is_inside(c); });
}

bool starts_on(const AnsweredQuery& q) {
  return !q.query.en.empty() || any_element(q, [](const ElementQuadratic& c) {
    return negligible(c.f.C, square(c.size)) && c.starts_between_ends();
  });
}

bool starts_exactly_on(const AnsweredQuery& q) {
  return any_element(
      q, [&](const ElementQuadratic& c) { return sign(candidate(q, c.e, false).f.C) == 0 && c.starts_between_ends(); });
}

bool nearly_tangent(const AnsweredQuery& q) {
  return any_element(q, [](const ElementQuadratic& c) {
    return sign(c.f.A) != 0 && sign(c.f.B * c.f.A) < 0 && negligible(c.discriminant(), square(c.f.B));
  });
}

bool tangent(const AnsweredQuery& q) {
  return any_hit_element(q, [](const ElementQuadratic& c) { return sign(c.f.A) != 0 && sign(c.discriminant()) == 0; });
}

bool nearly_zero_b(const AnsweredQuery& q) {
  return any_hit_element(
      q, [](const ElementQuadratic& c) { return number::shifted(square(c.f.B), 40) <= magnitude(c.f.A * c.f.C); });
}

bool zero_b(const AnsweredQuery& q) {
  return any_hit_element(q, [](const ElementQuadratic& c) { return sign(c.f.B) == 0; });
}

bool nearly_tie(const AnsweredQuery& q) {
  if (!hits(q)) return false;
  return any_element(q, [&](const ElementQuadratic& c) {
    if (c.e == q.hit.elementos[0]) return false;
    const surface::exact::Reach found = reach(c.f);
    return !found.empty() && !found.no_minimum() && number::round_to_binary64(found.first()) <= q.hit.t * (1 + 0x1p-20);
  });
}

bool tie(const AnsweredQuery& q) { return hits(q) && q.hit.elementos.size() > 1; }

}  // namespace durero::conform
