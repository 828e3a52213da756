#include "durero/model/distribuida.hpp"

#include <algorithm>

#include "durero/model/puntos.hpp"

namespace durero::model {
namespace {

Surd squared(const Surd& a) { return a * a; }

ExactPoint moved(const ExactPoint& p, const Surd& t, const ExactDirection& v) {
  return {p.x + t * v.x, p.y + t * v.y, p.z + t * v.z};
}

ExactDirection between(const ExactPoint& from, const ExactPoint& to) {
  return {to.x - from.x, to.y - from.y, to.z - from.z};
}

/// avance(w, l.ojo, l.eje)
Surd before(const Lente& l, const ExactPoint& w) { return producto(between(l.ojo, w), l.eje); }

}  // namespace

Judgements inv(const Sorteo& s) {
  const std::vector<Surd> chances(s.p.begin(), s.p.end());
  return {{&Sorteo_inv_1, !s.p.empty()},
          {&Sorteo_inv_2, std::ranges::all_of(s.p, [](const Rational& p) { return p >= 0; })},
          {&Sorteo_inv_3, acumulado(chances).back() == 1}};
}

Surd media(const Sorteo& s, std::span<const Surd> x) {
  std::vector<Surd> dada;
  for (std::size_t i = 0; i < s.p.size(); ++i) dada.push_back(Surd(s.p[i]) * x[i]);
  return acumulado(dada).back();
}

Surd de_luz_extensa(const Material& m, const ExactDirection& n, const ExactDirection& v, const Sorteo& s,
                    std::span<const Fuente> F) {
  std::vector<Surd> x;
  for (const Fuente& f : F) x.push_back(aportacion(m, n, v, f));
  return media(s, x);
}

Judgements inv(const Lente& l) {
  return {{&Lente_inv_1, producto(l.eje, l.eje) == 1},
          {&Lente_inv_2, Cantidad::contains(l.abertura).holds},
          {&Lente_inv_3, l.foco > 0}};
}

bool puntos_de_lente(const Lente& l, const ExactPoint& q) {
  const ExactDirection from = between(l.ojo, q);
  return before(l, q) == 0 && Surd(4) * producto(from, from) <= squared(Surd(l.abertura));
}

std::optional<ExactPoint> punto_en_foco(const Lente& l, const ExactDirection& v) {
  const Surd along = producto(v, l.eje);
  if (along <= 0) return std::nullopt;
  return moved(l.ojo, Surd(l.foco) / along, v);
}

bool rayo_de_lente(const Lente& l, const ExactDirection& v, const Rayo& rayo) {
  const auto f = punto_en_foco(l, v);
  return f && puntos_de_lente(l, rayo.p()) && puntos_de_rayo(rayo).contains(*f);
}

std::optional<ExactPoint> visto_en_foco(const Lente& l, const ExactPoint& q, const ExactPoint& w) {
  const Surd z = before(l, w);
  if (z <= 0) return std::nullopt;
  return moved(q, Surd(l.foco) / z, between(q, w));
}

Surd circulo_de_confusion(const Lente& l, const Surd& z) {
  return Surd(l.abertura) * mayor(z - Surd(l.foco), Surd(l.foco) - z) / z;
}

ExactPoint desplazado(const ExactPoint& p, const ExactDirection& v, const Rational& t) { return moved(p, Surd(t), v); }

bool repartida(const Repartida& r) {
  if (r.p.p.size() != r.q.p.size()) return false;
  for (std::size_t i = 0; i < r.p.p.size(); ++i) {
    const bool whole = r.w[i] + r.o[i] == 1;
    if (!whole || r.p.p[i] * r.x[i] != r.w[i] * r.f[i] || r.q.p[i] * r.y[i] != r.o[i] * r.f[i]) return false;
  }
  return true;
}

std::optional<Rational> ruleta(const Rational& c, const Rational& x) {
  if (c == 0) return std::nullopt;
  return x / c;
}

}  // namespace durero::model
