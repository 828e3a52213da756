#include "durero/model/interseccion.hpp"

#include <algorithm>

#include "durero/model/type_list.hpp"

namespace durero::model {
namespace {

/// w ↦ potencia(θEscena, e, w), as a value that outlives the scene.
Potencia power_of(const Escena& s, const Elemento& e) {
  return with_type(s.de_que_tipo.at(e), [&]<class Type>(std::type_identity<Type>) { return Type::potencia(s, e); });
}

/// What is not negative exactly where w ∈ tramo(θEscena, e): the two sides of each comparison of tramo.def.1. They
/// outlive the scene, and along a ray each is concave.
std::vector<Potencia> bounds_of_tramo(const Escena& s, const Elemento& e) {
  const Tipo tipo = s.de_que_tipo.at(e);
  std::vector<Potencia> all;
  if (const auto altura = s.mi_altura.find(e); altura != s.mi_altura.end()) {
    const Potencia advance = [centro = s.mi_centro.at(e), dir = s.mi_vector.at(e)](const ExactPoint& w) {
      return avance(w, centro, dir);
    };
    all.push_back(advance);
    all.push_back([advance, h = altura->second](const ExactPoint& w) { return h.value() - advance(w); });
  }
  if (tipo == Tipo::soy_disco)
    all.push_back([centro = s.mi_centro.at(e), radio = s.mi_radio.at(e)](const ExactPoint& w) {
      return -potencia_esfera(w, centro, radio);
    });
  if (const auto vertices = s.mi_vertices.find(e); vertices != s.mi_vertices.end()) {
    const auto [a, b, c] = vertices->second.terna();
    all.push_back([=](const ExactPoint& w) { return lado(w, a, b, c); });
    all.push_back([=](const ExactPoint& w) { return lado(w, b, c, a); });
    all.push_back([=](const ExactPoint& w) { return lado(w, c, a, b); });
  }
  return all;
}

/// The parameters of the points of the ray that lie on e, or where `desde` holds of those whose power is the origin's.
Parameters parameters_on(const Escena& s, const Rayo& rayo, const Elemento& e, bool desde) {
  const ExactVector v(rayo.v());
  RationalQuadratic q = restricted(power_of(s, e), rayo.p(), v);
  if (desde) q.c = 0;  // potencia(w) − potencia(p): the polynomial less its value at 0
  Interval within = all_positive();
  for (const Potencia& bound : bounds_of_tramo(s, e)) {
    const auto by_bound = not_negative(restricted(bound, rayo.p(), v));
    const auto both = by_bound ? intersection(within, *by_bound) : std::nullopt;
    if (!both) return {};
    within = *both;
  }
  return zeros(q, within);
}

}  // namespace

Puntos interseccion(const Puntos& ps, const Puntos& qs) {
  return Puntos([=](const ExactPoint& w) { return ps.contains(w) && qs.contains(w); });
}

Distancia distancia(const ExactPoint& a, const ExactPoint& b) {
  return {cuadrado(a.x - b.x) + cuadrado(a.y - b.y) + cuadrado(a.z - b.z)};
}

std::optional<ExactPoint> reduccion(std::span<const ExactPoint> ps, const Punto& ojo) {
  const ExactPoint* nearest = nullptr;
  bool unique = true;
  for (const ExactPoint& temp : ps) {
    const auto order = nearest ? distancia(temp, ojo) <=> distancia(*nearest, ojo) : std::strong_ordering::less;
    if (!nearest || order < 0) {
      nearest = &temp;
      unique = true;
    } else if (order == 0 && !(temp == *nearest)) {
      unique = false;
    }
  }
  return nearest && unique ? std::optional(*nearest) : std::nullopt;
}

std::set<Elemento> de_que_elemento(const Escena& escena, const ExactPoint& p) {
  std::set<Elemento> those;
  for (const Elemento& e : escena.elementos)
    if (puntos_de_elemento(escena, e).contains(p)) those.insert(e);
  return those;
}

Surd potencia(const Escena& s, const Elemento& e, const ExactPoint& w) { return power_of(s, e)(w); }

Puntos tramo(const Escena& s, const Elemento& e) {
  return Puntos([bounds = bounds_of_tramo(s, e)](const ExactPoint& w) {
    return std::all_of(bounds.begin(), bounds.end(), [&](const Potencia& bound) { return bound(w) >= 0; });
  });
}

Puntos puntos_desde(const Escena& s, const Elemento& e, const ExactPoint& p) {
  return Puntos([power = power_of(s, e), stretch = tramo(s, e), origin = potencia(s, e, p)](const ExactPoint& w) {
    return stretch.contains(w) && power(w) == origin;
  });
}

Alcance alcance(const Escena& s, const Rayo& rayo, const std::set<Elemento>& en, const Elemento& e) {
  const bool desde = en.contains(e);
  return {interseccion(puntos_de_rayo(rayo), desde ? puntos_desde(s, e, rayo.p()) : puntos_de_elemento(s, e)),
          parameters_on(s, rayo, e, desde)};
}

std::map<Elemento, Alcance> alcances(const Escena& s, const Rayo& rayo, const std::set<Elemento>& en) {
  std::map<Elemento, Alcance> all;
  for (const Elemento& e : s.elementos) all.emplace(e, alcance(s, rayo, en, e));
  return all;
}

std::optional<Surd> reduccion(const std::map<Elemento, Alcance>& all) {
  // Along a ray the distance from its origin is t·|v|, so the nearest point is the one of least parameter, and the
  // only one at its distance.
  std::optional<Surd> least;
  for (const auto& [e, reach] : all) {
    if (reach.parameters.is_empty()) continue;
    const auto minimum = reach.parameters.minimum();
    if (!minimum) return std::nullopt;
    if (!least || *minimum < *least) least = minimum;
  }
  return least;
}

bool occluded(const Escena& s, const Rayo& rayo, const std::set<Elemento>& en) {
  return std::any_of(s.elementos.begin(), s.elementos.end(),
                     [&](const Elemento& e) { return !alcance(s, rayo, en, e).parameters.is_empty(); });
}

bool occluded_segment(const Escena& s, const Rayo& rayo, const std::set<Elemento>& en) {
  return std::any_of(s.elementos.begin(), s.elementos.end(),
                     [&](const Elemento& e) { return alcance(s, rayo, en, e).parameters.any_below(1); });
}

}  // namespace durero::model
