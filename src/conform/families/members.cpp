#include "conform/families/candidate.hpp"

namespace durero::conform {

using model::Resultado;
using number::sign;

bool hits(const AnsweredQuery& q) { return q.hit.resultado == Resultado::hit; }

bool hits_flat(const AnsweredQuery& q) {
  return any_hit_element(q, [](const ElementQuadratic& c) { return c.is_flat(); });
}

bool coincides(const AnsweredQuery& q) {
  if (q.hit.resultado == Resultado::no_minimum || tie(q)) return true;
  return any_element(q, [](const ElementQuadratic& c) {
    const surface::exact::Coefficients& f = c.f;
    if ((sign(f.A) == 0 && !c.is_flat()) || sign(f.B) == 0 || sign(f.C) == 0 || (c.is_axial() && sign(f.s1) == 0))
      return true;
    return sign(c.discriminant()) == 0 || any_root_ahead(c, [&](const Parameter& t) { return c.is_at_end(t); });
  });
}

}  // namespace durero::conform
