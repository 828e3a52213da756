#include "durero/model/instancias.hpp"

#include <utility>

namespace durero::model {
namespace {

/// u.x·m.x + u.y·m.y + u.z·m.z, by components, over the numbers of u.
template <class N, class Result, class Triple>
Result combined(const Mapa& m, const Triple& u) {
  return {u.x * N(m.x.x) + u.y * N(m.y.x) + u.z * N(m.z.x), u.x * N(m.x.y) + u.y * N(m.y.y) + u.z * N(m.z.y),
          u.x * N(m.x.z) + u.y * N(m.y.z) + u.z * N(m.z.z)};
}

/// a · (b × c), where one of the three has other numbers than the two others.
template <class N, class A, class B, class C>
N mixed_product(const A& a, const B& b, const C& c) {
  return N(a.x) * (N(b.y) * N(c.z) - N(b.z) * N(c.y)) + N(a.y) * (N(b.z) * N(c.x) - N(b.x) * N(c.z)) +
         N(a.z) * (N(b.x) * N(c.y) - N(b.y) * N(c.x));
}

/// The combination of the map's vectors that gives q, by Cramer's rule.
template <class N, class Result>
Result parts_of(const Mapa& m, const Result& q) {
  const N uno(mixto(m.x, m.y, m.z));
  return {mixed_product<N>(q, m.y, m.z) / uno, mixed_product<N>(m.x, q, m.z) / uno,
          mixed_product<N>(m.x, m.y, q) / uno};
}

bool same_vector(const ExactVector& a, const ExactVector& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

Mapa diagonal(const Rational& across, const Rational& along) {
  return {{0, 0, 0}, {across, 0, 0}, {0, across, 0}, {0, 0, along}};
}

}  // namespace

Rational mixto(const ExactVector& a, const ExactVector& b, const ExactVector& c) {
  return mixed_product<Rational>(a, b, c);
}

bool operator==(const Mapa& m, const Mapa& n) {
  return same_vector(m.centro, n.centro) && same_vector(m.x, n.x) && same_vector(m.y, n.y) && same_vector(m.z, n.z);
}

Judgements inv(const Mapa& m) { return {{&Mapa_inv_1, mixto(m.x, m.y, m.z) != 0}}; }

ExactPoint puesto(const Mapa& m, const ExactPoint& u) {
  const auto from_centro = combined<Surd, ExactPoint>(m, u);
  return {Surd(m.centro.x) + from_centro.x, Surd(m.centro.y) + from_centro.y, Surd(m.centro.z) + from_centro.z};
}

ExactVector dirigido(const Mapa& m, const ExactVector& u) { return combined<Rational, ExactVector>(m, u); }

ExactPoint visto(const Mapa& m, const ExactPoint& w) {
  return parts_of<Surd>(m, ExactPoint(w.x - Surd(m.centro.x), w.y - Surd(m.centro.y), w.z - Surd(m.centro.z)));
}

Puntos copia(const Mapa& m, const Puntos& ps) {
  return Puntos([=](const ExactPoint& w) { return ps.contains(visto(m, w)); },
                [=](Random& random) {
                  const auto u = ps.sample(random);
                  return u ? std::optional(puesto(m, *u)) : std::nullopt;
                });
}

ExactRay movido(const Mapa& m, const Rayo& rayo) {
  return {visto(m, rayo.p()), parts_of<Rational>(m, ExactVector(rayo.v()))};
}

Mapa compuesto(const Mapa& m, const Mapa& n) {
  const ExactVector c = dirigido(m, n.centro);
  return {{m.centro.x + c.x, m.centro.y + c.y, m.centro.z + c.z}, dirigido(m, n.x), dirigido(m, n.y), dirigido(m, n.z)};
}

bool identidad(const Mapa& m) { return m == identity(); }

Mapa identity() { return diagonal(1, 1); }

bool estirado(const Mapa& m, const Rmas& r, const Rmas& h) {
  Mapa stretched = diagonal(number::exact(r.value()), number::exact(h.value()));
  stretched.centro = m.centro;
  return m == stretched;
}

Puntos puntos_de_instancia(const Escena& escena, const Mapa& m, const Elemento& e) {
  return copia(m, puntos_de_elemento(escena, e));
}

Puntos instancia_desde(const Escena& escena, const Mapa& m, const Elemento& e, const ExactPoint& p) {
  return copia(m, puntos_desde(escena, e, visto(m, p)));
}

}  // namespace durero::model
