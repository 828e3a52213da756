#include "durero/model/haces.hpp"

#include <stdexcept>

#include "durero/model/escena.hpp"
#include "durero/model/interseccion.hpp"

namespace durero::model {
namespace {

/// m·d, of one row
Rational times(const Desvio& row, const Desvio& d) { return row.x * d.x + row.y * d.y + row.u * d.u + row.v * d.v; }

ExactVector exact(const Vector& v) { return ExactVector(v); }

ExactDirection direction(const Vector& v) {
  const ExactVector e = exact(v);
  return {Surd(e.x), Surd(e.y), Surd(e.z)};
}

}  // namespace

bool cono_de_rayos(const Rayo& eje, const Rayo& rayo, const Rational& c) {
  if (!(ExactPoint(rayo.p()) == ExactPoint(eje.p()))) return false;
  const ExactDirection v = direction(eje.v()), w = direction(rayo.v());
  const Surd along = producto(v, w);
  return along > 0 && cuadrado(along) >= Surd(c) * producto(v, v) * producto(w, w);
}

bool cubierto(const Escena& escena, const Rayo& eje, const Rayo& rayo, const Rational& c, const Elemento& e) {
  return cono_de_rayos(eje, rayo, c) && escena.elementos.contains(e) &&
         !alcance(escena, rayo, {}, e).parameters.is_empty();
}

bool haz(const Punto& o, const Escena& escena, const Elemento& e, const Rayo& rayo) {
  return ExactPoint(rayo.p()) == ExactPoint(o) && !alcance(escena, rayo, {}, e).parameters.is_empty();
}

bool seccion(const Punto& o, const Escena& escena, const Elemento& e, const Punto& a, const Vector& n, const Punto& w) {
  const Vector to(w.xyz() - o.xyz());
  const ExactPoint end(w);
  if (!(along(ExactPoint(o), exact(to), 1) == end))
    throw std::domain_error("the difference of two points is no stored vector; expected points of one scale");
  return avance(end, a, n) == 0 && to != Vector(0, 0, 0) && haz(o, escena, e, Rayo(o, to));
}

bool imagen(const Punto& a, const Vector& n, const ExactPoint& p, const ExactPoint& q) {
  const ExactDirection normal = direction(n);
  return producto(normal, normal) > 0 && image(a, n, p) == q;
}

ExactPoint image(const Punto& a, const Vector& n, const ExactPoint& p) {
  const ExactDirection normal = direction(n);
  return along(p, exact(n), Surd(-2) * avance(p, a, n) / producto(normal, normal));
}

Desvio aplicado(const Matriz& m, const Desvio& d) {
  return {times(m.x, d), times(m.y, d), times(m.u, d), times(m.v, d)};
}

Desvio traslado(const Rational& t, const Desvio& d) { return {d.x + t * d.u, d.y + t * d.v, d.u, d.v}; }

Desvio refraccion_paraxial(const Rational& r, const Rational& razon, const Desvio& d) {
  if (r == 0) throw std::domain_error("the radius is 0; expected another");
  return {d.x, d.y, razon * d.u + (razon - 1) * d.x / r, razon * d.v + (razon - 1) * d.y / r};
}

}  // namespace durero::model
