#include "durero/model/luz.hpp"

#include <stdexcept>

#include "durero/model/escena.hpp"
#include "durero/model/interseccion.hpp"

namespace durero::model {
namespace {

constexpr int greatest_exponent = 1 << 20;

/// The ray from p in that direction; nothing where it is the null vector.
bool sees(const Punto& p, const Vector& v, const auto& is_occluded) {
  if (v == Vector(0, 0, 0)) return false;
  return !is_occluded(Rayo(p, v));
}

}  // namespace

Judgements inv(const Material& m) {
  return {
      {&Material_inv_1, Parte::contains(m.k_a).holds},           {&Material_inv_2, Parte::contains(m.k_d).holds},
      {&Material_inv_3, Parte::contains(m.k_s).holds},           {&Material_inv_4, Parte::contains(m.k_ps).holds},
      {&Material_inv_5, Parte::contains(m.k_t).holds},           {&Material_inv_6, Parte::contains(m.C).holds},
      {&Material_inv_7, Parte::contains(m.M_PS).holds},          {&Material_inv_8, Parte::contains(m.M_T).holds},
      {&Material_inv_9, Cantidad::contains(m.emisividad).holds}, {&Material_inv_10, Cantidad::contains(m.A_G).holds},
      {&Material_inv_11, Cantidad::contains(m.e).holds},         {&Material_inv_12, m.indice > 0}};
}

bool conserva(const Material& m) { return m.k_ps * m.M_PS + m.k_t * m.M_T <= 1; }

Judgements inv(const Fuente& f) {
  return {{&Fuente_inv_1, Cantidad::contains(f.S).holds}, {&Fuente_inv_2, f.V == 0 || f.V == 1}};
}

Surd mayor(const Surd& a, const Surd& b) { return a <= b ? b : a; }

Surd elevado(const Surd& x, const Rational& a) {
  if (x < 0 || a < 0) throw std::domain_error("the power of a negative number is asked for; expected one from 0");
  if (x == 1) return 1;
  if (denominator(a) != 1 || a > greatest_exponent)
    throw std::domain_error("a power is asked for that is not named; expected a whole exponent up to 2^20");
  Surd power = 1, square = x;
  for (auto left = numerator(a).convert_to<std::int64_t>(); left > 0; left /= 2) {
    if (left % 2 == 1) power = power * square;
    if (left > 1) square = square * square;
  }
  return power;
}

bool visible(const Escena& escena, const Punto& p, const Punto& q, const std::set<Elemento>& en) {
  const Vector to(q.xyz() - p.xyz());
  const bool is_exact = Surd(to.x()) == Surd(q.x()) - Surd(p.x()) && Surd(to.y()) == Surd(q.y()) - Surd(p.y()) &&
                        Surd(to.z()) == Surd(q.z()) - Surd(p.z());
  if (!is_exact)
    throw std::domain_error("the difference of two points is no stored vector; expected points of one scale");
  return sees(p, to, [&](const Rayo& rayo) { return occluded_segment(escena, rayo, en); });
}

bool visible_lejos(const Escena& escena, const Punto& p, const Vector& l, const std::set<Elemento>& en) {
  return sees(p, l, [&](const Rayo& rayo) { return occluded(escena, rayo, en); });
}

bool ante_lejos(const Escena& escena, const Rayo& rayo, const std::set<Elemento>& en, const Elemento& e,
                const ExactPoint& punto) {
  return escena.elementos.contains(e) && alcance(escena, rayo, en, e).puntos.contains(punto);
}

bool ante(const Escena& escena, const Rayo& rayo, const std::set<Elemento>& en, const Elemento& e,
          const ExactPoint& punto) {
  if (!ante_lejos(escena, rayo, en, e, punto)) return false;
  // The point is p + t·v, and t < 1 exactly where its product with v is less than that of p + v.
  const ExactDirection v{rayo.v().x(), rayo.v().y(), rayo.v().z()};
  const ExactDirection way{punto.x - Surd(rayo.p().x()), punto.y - Surd(rayo.p().y()), punto.z - Surd(rayo.p().z())};
  return producto(way, v) < producto(v, v);
}

std::optional<std::vector<Encuentro>> enumerado(const Escena& escena, const Rayo& rayo, const std::set<Elemento>& en,
                                                bool segment) {
  std::vector<Encuentro> all;
  for (const Elemento& e : escena.elementos) {
    const Parameters there = alcance(escena, rayo, en, e).parameters;
    if (there.interval && (!segment || there.any_below(1))) return std::nullopt;
    for (const Surd& t : there.points)
      if (!segment || t < Surd(1)) all.push_back({e, along(ExactPoint(rayo.p()), ExactVector(rayo.v()), t)});
  }
  return all;
}

std::vector<Rational> atenuado(std::span<const Rational> dada) {
  std::vector<Rational> resto{1};
  for (const Rational& each : dada) resto.push_back(resto.back() * each);
  return resto;
}

Rational transmitido(std::span<const Encuentro> c, const std::function<Rational(const Encuentro&)>& paso) {
  std::vector<Rational> dada;
  for (const Encuentro& each : c) dada.push_back(paso(each));
  return atenuado(dada).back();
}

Fuente menguada(const Fuente& f, const Rational& k) { return {f.l, k * f.S, f.V}; }

ExactDirection normal_suave(const ExactDirection& a, const ExactDirection& b, const ExactDirection& c, const Surd& u,
                            const Surd& v) {
  const Surd first = Surd(1) - u - v;
  return {first * a.x + u * b.x + v * c.x, first * a.y + u * b.y + v * c.y, first * a.z + u * b.z + v * c.z};
}

Judgements inv(const Cono_de_Luz& c) {
  return {{&Cono_de_Luz_inv_1, producto(c.eje, c.eje) == 1},
          {&Cono_de_Luz_inv_2, 0 < c.borde && c.borde <= c.pleno && c.pleno <= 1},
          {&Cono_de_Luz_inv_3, Cantidad::contains(c.estrechez).holds}};
}

Surd intensidad(const Cono_de_Luz& c, const ExactDirection& w) {
  const Surd cosine = producto(c.eje, w);
  if (cosine < Surd(c.borde)) return 0;
  const Surd narrowed = elevado(cosine, c.estrechez);
  if (cosine >= Surd(c.pleno)) return narrowed;
  const Surd x = (cosine - Surd(c.borde)) * Surd(1 / (c.pleno - c.borde));
  return narrowed * (x * x * (Surd(3) - Surd(2) * x));
}

Surd especular(const ExactDirection& l, const ExactDirection& n, const ExactDirection& v) {
  return Surd(2) * producto(l, n) * producto(v, n) - producto(l, v);
}

Surd directa(const Material& m, const ExactDirection& n, const ExactDirection& v, const ExactDirection& l) {
  const Surd cosine = producto(n, l);
  const Surd even = Surd(m.k_a * m.C) + Surd(m.k_d * m.C) * mayor(0, cosine);
  return cosine > 0 ? even + Surd(m.k_s) * elevado(mayor(0, especular(l, n, v)), m.e) : even;
}

Surd aportacion(const Material& m, const ExactDirection& n, const ExactDirection& v, const Fuente& f) {
  return Surd(f.V * f.S) * directa(m, n, v, f.l);
}

Surd indirecta(const Material& m, const Surd& r, const Surd& t) {
  return Surd(m.A_G) + Surd(m.k_ps * m.M_PS) * r + Surd(m.k_t * m.M_T) * t;
}

Surd radiancia(const Material& m, const Surd& suma, const Surd& r, const Surd& t) {
  return Surd(m.emisividad) + indirecta(m, r, t) + suma;
}

std::vector<Surd> acumulado(std::span<const Surd> dada) {
  std::vector<Surd> suma{0};
  for (const Surd& each : dada) suma.push_back(suma.back() + each);
  return suma;
}

std::vector<Surd> trazador(const Trazado& t, std::int64_t maximo, std::int64_t n) {
  std::vector<Surd> deeper(t.caminos.size());  // above the greatest depth all is black
  for (std::int64_t depth = maximo; depth >= n; --depth) {
    std::vector<Surd> here;
    here.reserve(deeper.size());
    for (const Trazado::Camino& c : t.caminos)
      here.push_back(c.llega ? radiancia(c.material, c.de_luces, deeper[c.reflejado], deeper[c.refractado]) : c.fondo);
    deeper = std::move(here);
  }
  return deeper;
}

Judgements inv(const Ventana& w) { return {{&Ventana_inv_1, w.H >= 1}, {&Ventana_inv_2, w.V >= 1}}; }

ExactPoint centro_de_pixel(const Ventana& w, std::int64_t x, std::int64_t y) {
  const Surd across(Rational(2 * x + 1) / Rational(2 * w.H)), down(Rational(2 * y + 1) / Rational(2 * w.V));
  return {w.esquina.x + across * w.ancho.x + down * w.alto.x, w.esquina.y + across * w.ancho.y + down * w.alto.y,
          w.esquina.z + across * w.ancho.z + down * w.alto.z};
}

bool rayo_de_pixel(const Ventana& w, std::int64_t x, std::int64_t y, const Rayo& rayo) {
  if (!(ExactPoint(rayo.p()) == w.ojo) || x < 0 || x >= w.H || y < 0 || y >= w.V) return false;
  return puntos_de_rayo(rayo).contains(centro_de_pixel(w, x, y));
}

}  // namespace durero::model
