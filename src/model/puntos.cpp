#include "durero/model/puntos.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "sampling.hpp"

namespace durero::model {
namespace {

/// 0 ≤ avance(w, centro, dir) ≤ h
bool within(const ExactPoint& w, const Punto& centro, const Vector& dir, const Rmas& h) {
  const Surd s = avance(w, centro, dir);
  return s >= 0 && s <= Surd(h.value());
}

}  // namespace

Surd cuadrado(const Surd& r) { return r * r; }

Surd raizcuadrada(const Rational& r) { return {0, 1, r}; }

Surd avance(const ExactPoint& w, const Punto& centro, const Vector& dir) {
  return (w.x - centro.x()) * dir.x() + (w.y - centro.y()) * dir.y() + (w.z - centro.z()) * dir.z();
}

Surd alejamiento(const ExactPoint& w, const Punto& centro, const Vector& dir) {
  const Surd s = avance(w, centro, dir);
  return cuadrado(w.x - (centro.x() + s * dir.x())) + cuadrado(w.y - (centro.y() + s * dir.y())) +
         cuadrado(w.z - (centro.z() + s * dir.z()));
}

Surd potencia_esfera(const ExactPoint& w, const Punto& centro, const Rmas& radio) {
  return cuadrado(w.x - centro.x()) + cuadrado(w.y - centro.y()) + cuadrado(w.z - centro.z()) - cuadrado(radio.value());
}

Surd potencia_cilindro(const ExactPoint& w, const Punto& centro, const Rmas& radio, const Vector& dir) {
  return alejamiento(w, centro, dir) - cuadrado(radio.value());
}

Surd potencia_cono(const ExactPoint& w, const Punto& centro, const Rmas& prop, const Vector& dir, const Rmas& h) {
  const Surd s = avance(w, centro, dir);
  return alejamiento(w, centro, dir) - cuadrado(prop.value() * s - Surd(h.value()) * prop.value());
}

Puntos big_union(std::vector<Puntos> sets) {
  const auto shared = std::make_shared<const std::vector<Puntos>>(std::move(sets));
  const auto member = [=](const ExactPoint& w) {
    return std::any_of(shared->begin(), shared->end(), [&](const Puntos& set) { return set.contains(w); });
  };
  return Puntos(member, [=](Random& random) -> std::optional<ExactPoint> {
    if (shared->empty()) return std::nullopt;
    return (*shared)[random() % shared->size()].sample(random);
  });
}

Puntos puntos_esfera(const Punto& centro, const Rmas& radio) {
  const auto power = [=](const ExactPoint& w) { return potencia_esfera(w, centro, radio); };
  const auto member = [=](const ExactPoint& w) { return power(w) == 0; };
  // The centre is inside, so every line through it meets the sphere twice.
  return Puntos(member,
                [=](Random& random) { return any_crossing(power, member, centro, any_direction(random), random); });
}

Puntos puntos_cilindro(const Punto& centro, const Rmas& radio, const Vector& dir, const Rmas& h) {
  const auto power = [=](const ExactPoint& w) { return potencia_cilindro(w, centro, radio, dir); };
  const auto member = [=](const ExactPoint& w) { return power(w) == 0 && within(w, centro, dir, h); };
  // A line at a right angle to the axis keeps its advance. It meets the surface where the power of its point on the
  // axis is negative, as it is near the centre; far from it an axis that is not quite a unit vector has drifted.
  return Puntos(member, [=](Random& random) {
    const ExactVector normal = any_normal(dir, random);
    const auto drawn = any_crossing(power, member, any_on_axis(centro, dir, h, random), normal, random);
    return drawn ? drawn : any_crossing(power, member, centro, normal, random);
  });
}

Puntos puntos_cono(const Punto& centro, const Rmas& prop, const Vector& dir, const Rmas& h) {
  const auto power = [=](const ExactPoint& w) { return potencia_cono(w, centro, prop, dir, h); };
  const auto member = [=](const ExactPoint& w) { return power(w) == 0 && within(w, centro, dir, h); };
  return Puntos(member, [=](Random& random) {
    const ExactVector normal = any_normal(dir, random);
    const auto drawn = any_crossing(power, member, any_on_axis(centro, dir, h, random), normal, random);
    return drawn ? drawn : any_crossing(power, member, centro, normal, random);
  });
}

std::optional<Surd> parameter(const Rayo& ray, const ExactPoint& w) {
  // A component of v that is not zero gives the only parameter that can be.
  const auto of = [](const Surd& at, double p, double v) { return (at - p) / Surd(v); };
  const Vector& v = ray.v();
  const Punto& p = ray.p();
  const Surd t = v.x() != 0 ? of(w.x, p.x(), v.x()) : v.y() != 0 ? of(w.y, p.y(), v.y()) : of(w.z, p.z(), v.z());
  if (along(p, v, t) == w) return t;
  return std::nullopt;
}

Puntos puntos_de_rayo(const Rayo& ray) {
  const auto member = [=](const ExactPoint& w) {
    const auto t = parameter(ray, w);
    return t && *t > 0;
  };
  return Puntos(member, [=](Random& random) -> std::optional<ExactPoint> {
    const Rational share = any_share(random);  // t = 1/share − 1/2: from 1/2 upwards
    return along(ray.p(), ray.v(), share.is_zero() ? Surd(Rational(1, 4)) : Surd(Rational(1 / share - Rational(1, 2))));
  });
}

Puntos puntos_de_elemento(const Escena& s, const Elemento& e) {
  switch (s.de_que_tipo.at(e)) {
    case Tipo::soy_esfera:
      return puntos_esfera(s.mi_centro.at(e), s.mi_radio.at(e));
    case Tipo::soy_cilindro:
      return puntos_cilindro(s.mi_centro.at(e), s.mi_radio.at(e), s.mi_vector.at(e), s.mi_altura.at(e));
    case Tipo::soy_cono:
      return puntos_cono(s.mi_centro.at(e), s.mi_proporcion.at(e), s.mi_vector.at(e), s.mi_altura.at(e));
  }
  contract::unreachable();
}

Puntos puntos_de_escena(const Escena& escena) {
  std::vector<Puntos> sets;
  sets.reserve(escena.elementos.size());
  for (const Elemento& e : escena.elementos) sets.push_back(puntos_de_elemento(escena, e));
  return big_union(std::move(sets));
}

}  // namespace durero::model
