#include "durero/model/iluminacion.hpp"

#include <stdexcept>

#include "durero/model/puntos.hpp"

namespace durero::model {
namespace {

/// a·u + b·v
ExactDirection combination(const Surd& a, const ExactDirection& u, const Surd& b, const ExactDirection& v) {
  return {a * u.x + b * v.x, a * u.y + b * v.y, a * u.z + b * v.z};
}

}  // namespace

bool reflexion(const ExactDirection& v, const ExactDirection& n, const ExactDirection& r) {
  const Surd nn = producto(n, n);
  return nn > 0 && combination(nn, r, nn, v) == combination(Surd(2) * producto(v, n), n, 0, n);
}

ExactDirection reflected(const ExactDirection& v, const ExactDirection& n) {
  return combination(Surd(2) * producto(v, n) / producto(n, n), n, -1, v);
}

bool incidencia(const ExactDirection& i, const ExactDirection& n) {
  return producto(i, i) == 1 && producto(n, n) == 1 && producto(i, n) >= 0;
}

Surd coseno_cuadrado(const ExactDirection& i, const ExactDirection& n, const Rational& razon) {
  return Surd(1) - cuadrado(razon) * (Surd(1) - cuadrado(producto(i, n)));
}

bool reflexion_total(const ExactDirection& i, const ExactDirection& n, const Rational& razon) {
  return incidencia(i, n) && coseno_cuadrado(i, n, razon) < 0;
}

bool refraccion(const ExactDirection& i, const ExactDirection& n, const Rational& razon, const ExactDirection& t) {
  if (!incidencia(i, n)) return false;
  // t = (razon·(i·n) − root)·n − razon·i, and n is a unit vector: t·n = −root.
  const Surd root = -producto(t, n);
  return root >= 0 && cuadrado(root) == coseno_cuadrado(i, n, razon) &&
         t == combination(Surd(razon) * producto(i, n) - root, n, -Surd(razon), i);
}

std::optional<ExactDirection> refracted(const ExactDirection& i, const ExactDirection& n, const Rational& razon) {
  const Surd squared = coseno_cuadrado(i, n, razon);
  if (squared < 0) return std::nullopt;
  if (squared.y != 0) throw std::domain_error("the root of an irrational number is asked for; expected a rational one");
  const Surd root = raizcuadrada(squared.x);
  return combination(Surd(razon) * producto(i, n) - root, n, -Surd(razon), i);
}

}  // namespace durero::model
