#include "durero/model/puntos.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "durero/model/type_list.hpp"
#include "sampling.hpp"

namespace durero::model {
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

Surd producto(const ExactPoint& u, const ExactPoint& v) { return u.x * v.x + u.y * v.y + u.z * v.z; }

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
  return with_type(s.de_que_tipo.at(e), [&]<class Type>(std::type_identity<Type>) { return Type::puntos(s, e); });
}

Puntos puntos_de_escena(const Escena& escena) {
  std::vector<Puntos> sets;
  sets.reserve(escena.elementos.size());
  for (const Elemento& e : escena.elementos) sets.push_back(puntos_de_elemento(escena, e));
  return big_union(std::move(sets));
}

}  // namespace durero::model
