#include "conform/families/candidate.hpp"

namespace durero::conform {
namespace {

using model::Tipo;
using number::shifted;

/// Whether |x| is in 2^−greatest … 2^−least of a whole that is not negative.
bool is_share(const Dyadic& x, const Dyadic& whole, int least, int greatest) {
  return shifted(magnitude(x), greatest) >= whole && shifted(magnitude(x), least) <= whole;
}

/// Whether the ray meets nothing before the root.
bool is_not_behind_hit(const AnsweredQuery& q, const Parameter& t) {
  return !hits(q) || surface::exact::order(t, candidate(q, q.hit.elementos[0]).first()) <= 0;
}

/// Whether the ray passes the limb of a sphere by such a share m of its radius: r² less the square of the distance from
/// its centre to the line is D/A, 2m·r² where that distance is (1 − m)·r.
bool is_beside_limb(const ElementQuadratic& c, int least, int greatest) {
  const bool is_ahead = number::sign(c.f.B) < 0;
  return c.e.tipo == Tipo::soy_esfera && is_ahead &&
         is_share(c.discriminant(), c.f.A * square(c.size), least - 1, greatest - 1);
}

/// Whether the ray passes an end of an element with an axis by such a share, measured along the axis.
bool is_beside_end(const AnsweredQuery& q, const ElementQuadratic& c, int least, int greatest) {
  return c.is_axial() && any_root_ahead(c, [&](const Parameter& t) {
           const auto from = [&](double end) {
             return Dyadic(number::round_to_binary64(number::linear(c.f.s0 - Dyadic(end), c.f.s1, t)));
           };
           const Dyadic altura(c.altura);
           return is_not_behind_hit(q, t) &&
                  (is_share(from(0), altura, least, greatest) || is_share(from(c.altura), altura, least, greatest));
         });
}

/// Whether the ray passes the rim of a disc or an edge of a triangle by such a share m. For a disc, r² less the square
/// of the distance from its centre is 2m·r² where that distance is (1 − m)·r. For a triangle, a barycentric coordinate
/// is the bound's share of the sum of the three, and no other is more negative.
bool is_beside_edge(const AnsweredQuery& q, const ElementQuadratic& c, int least, int greatest) {
  const bool is_disc = c.e.tipo == Tipo::soy_disco;
  return !c.f.bounds.empty() && any_root_ahead(c, [&](const Parameter& t) {
    Dyadic whole, lowest = c.f.bounds[0].C;
    for (const auto& bound : c.f.bounds) whole += bound.C, lowest = std::min(lowest, bound.C);
    if (is_disc) whole = square(c.size * shifted(c.f.B, 1));
    const int double_of = is_disc ? 1 : 0;
    return is_not_behind_hit(q, t) && is_share(lowest, whole, least - double_of, greatest - double_of);
  });
}

}  // namespace

bool beside_bound_by(const AnsweredQuery& q, int least, int greatest) {
  return any_element(q, [&](const ElementQuadratic& c) {
    return is_beside_limb(c, least, greatest) || is_beside_end(q, c, least, greatest) ||
           is_beside_edge(q, c, least, greatest);
  });
}

bool beside_bound(const AnsweredQuery& q) { return beside_bound_by(q, 7, 49); }

}  // namespace durero::conform
