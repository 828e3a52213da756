#include <cmath>

#include "conform/families/candidate.hpp"

namespace durero::conform {

using model::Tipo;
using number::sign;

bool nearly_axial(const AnsweredQuery& q) {
  return any_element(q, [&](const ElementQuadratic& c) {
    const DyadicVector v = exact(q.query.rayo.v().xyz()), out = cross(v, exact(c.vector));
    return c.e.tipo == Tipo::soy_cilindro && number::shifted(dot(out, out), 9) <= dot(v, v);
  });
}

bool axial(const AnsweredQuery& q) {
  return any_element(q, [&](const ElementQuadratic& c) {
    const DyadicVector out = cross(exact(q.query.rayo.v().xyz()), exact(c.vector));
    return c.e.tipo == Tipo::soy_cilindro && sign(dot(out, out)) == 0;
  });
}

bool perpendicular(const AnsweredQuery& q) {
  return any_hit_element(q, [](const ElementQuadratic& c) { return c.is_axial() && sign(c.f.s1) == 0; });
}

bool nearly_generator(const AnsweredQuery& q) {
  return any_element(q, [&](const ElementQuadratic& c) {
    return c.is_axial() && number::shifted(magnitude(c.f.A), 3) <= squared_length(q.query.rayo.v().xyz());
  });
}

bool generator(const AnsweredQuery& q) {
  return any_element(q, [](const ElementQuadratic& c) { return c.is_axial() && sign(c.f.A) == 0; });
}

bool nearly_parallel(const AnsweredQuery& q) {
  return any_element(q, [&](const ElementQuadratic& c) {
    const Dyadic slope = number::shifted(c.f.B, 1);
    return c.is_flat() && number::shifted(square(slope), 40) <= c.normal * squared_length(q.query.rayo.v().xyz());
  });
}

bool parallel(const AnsweredQuery& q) {
  return any_element(q, [](const ElementQuadratic& c) { return c.is_flat() && sign(c.f.B) == 0; });
}

bool hits_tilted(const AnsweredQuery& q) {
  return any_hit_element(
      q, [](const ElementQuadratic& c) { return (c.vector.x == 0) + (c.vector.y == 0) + (c.vector.z == 0) != 2; });
}

bool aligned(const AnsweredQuery& q) {
  const auto none = [](double x) { return std::abs(x) < 0x1p-126; };
  const glm::dvec3& v = q.query.rayo.v().xyz();
  return hits(q) && (none(v.x) || none(v.y) || none(v.z));
}

bool exactly_aligned(const AnsweredQuery& q) {
  const glm::dvec3& v = q.query.rayo.v().xyz();
  return hits(q) && (v.x == 0 || v.y == 0 || v.z == 0);
}

bool nearly_in_surface(const AnsweredQuery& q) {
  const Dyadic square_of_v = squared_length(q.query.rayo.v().xyz());
  return any_element(q, [&](const ElementQuadratic& c) {
    return c.is_axial() && negligible(c.f.A, square_of_v) &&
           number::shifted(square(c.f.B), 20) <= square_of_v * square(c.size) &&
           negligible(c.f.C, square(c.size) + square(c.f.s0));
  });
}

bool in_surface(const AnsweredQuery& q) {
  return q.hit.resultado == model::Resultado::no_minimum ||
         any_hit_element(q, [](const ElementQuadratic& c) { return reach(c.f).segment.has_value(); });
}

}  // namespace durero::conform
