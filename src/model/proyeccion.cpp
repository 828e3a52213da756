#include "durero/model/proyeccion.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "durero/model/tipo/triangulo.hpp"

namespace durero::model {
namespace {

/// x + s·(y − x)
ExactPoint on_the_way(const ExactPoint& x, const ExactPoint& y, const Surd& s) {
  return {x.x + s * (y.x - x.x), x.y + s * (y.y - x.y), x.z + s * (y.z - x.z)};
}

/// Whether some 0 < s < 1 has from + s·(to − from) ≥ 0 for each of these pairs: they are bounds on s.
bool have_a_common_place(const std::array<std::pair<Surd, Surd>, 3>& ends) {
  Surd least = 0, greatest = 1;
  for (const auto& [from, to] : ends) {
    if (from == to && from < 0) return false;
    if (from == to) continue;
    const Surd at_zero = from / (from - to);
    if (from < to)
      least = std::max(least, at_zero);
    else
      greatest = std::min(greatest, at_zero);
  }
  return least <= greatest && least < 1 && greatest > 0;
}

/// Whether a triangle has a point between two points: the power and the sides grow evenly from one to the other.
bool stands_between(const Terna& v, const ExactPoint& x, const ExactPoint& y) {
  const Surd from = potencia_triangulo(x, v), to = potencia_triangulo(y, v);
  if (from == to && from != 0) return false;
  if (from != to) {
    const Surd s = from / (from - to);
    return s > 0 && s < 1 && prisma(v).contains(on_the_way(x, y, s));
  }
  return have_a_common_place({{{lado(x, v.a, v.b, v.c), lado(y, v.a, v.b, v.c)},
                               {lado(x, v.b, v.c, v.a), lado(y, v.b, v.c, v.a)},
                               {lado(x, v.c, v.a, v.b), lado(y, v.c, v.a, v.b)}}});
}

}  // namespace

bool entre(const ExactPoint& x, const ExactPoint& y, const ExactPoint& q) {
  if (x == y) return q == x;
  const Surd s = x.x != y.x   ? (q.x - x.x) / (y.x - x.x)
                 : x.y != y.y ? (q.y - x.y) / (y.y - x.y)
                              : (q.z - x.z) / (y.z - x.z);
  return s > 0 && s < 1 && q == on_the_way(x, y, s);
}

Puntos sombra(const ExactPoint& y, const Terna& triangle) {
  return Puntos([=](const ExactPoint& x) { return stands_between(triangle, x, y); });
}

Puntos iluminada(const ExactPoint& y, const Terna& triangle, const std::vector<Terna>& otros) {
  return Puntos([=](const ExactPoint& x) {
    return puntos_triangulo(triangle).contains(x) &&
           std::ranges::none_of(otros, [&](const Terna& other) { return sombra(y, other).contains(x); });
  });
}

std::optional<ExactPoint> proyectado(const ExactPoint& y, const ExactPoint& p, const Punto& centro, const Vector& dir) {
  const Surd from = avance(y, centro, dir), slope = avance(p, centro, dir) - from;
  if (slope == 0 && from == 0)
    throw std::domain_error(
        "the projection of a point in the plane from a point in it is asked for; expected one off it");
  if (slope == 0) return std::nullopt;
  const Surd t = -from / slope;
  if (t <= 0) return std::nullopt;
  return on_the_way(y, p, t);
}

std::optional<Distancia> profundidad(const Escena& escena, const Rayo& rayo) {
  const std::optional<Surd> t = reduccion(alcances(escena, rayo, {}));
  if (!t) return std::nullopt;
  return distancia(along(rayo.p(), rayo.v(), *t), rayo.p());
}

bool oscura(const Distancia& d, const ExactPoint& q, const ExactPoint& y) { return d < distancia(q, y); }

Surd mezcla(const Material& m, const Surd& propio, const Surd& I) { return propio + Surd(m.k_t * m.M_T) * I; }

}  // namespace durero::model
