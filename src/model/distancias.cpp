#include "durero/model/distancias.hpp"

#include <algorithm>

#include "durero/model/escena.hpp"

namespace durero::model {

std::vector<ExactPoint> cercanos(std::span<const ExactPoint> ps, const Punto& p) {
  std::vector<ExactPoint> nearest;
  for (const ExactPoint& w : ps) {
    const auto order = nearest.empty() ? std::strong_ordering::less : distancia(w, p) <=> distancia(nearest[0], p);
    if (order < 0) nearest.clear();
    if (order <= 0 && std::ranges::find(nearest, w) == nearest.end()) nearest.push_back(w);
  }
  return nearest;
}

std::optional<Distancia> a_distancia(std::span<const ExactPoint> ps, const Punto& p) {
  const std::vector<ExactPoint> nearest = cercanos(ps, p);
  return nearest.empty() ? std::nullopt : std::optional(distancia(nearest.front(), p));
}

bool con_signo(const Escena& s, const Elemento& e, const Punto& p, const Surd& r, std::span<const ExactPoint> ps) {
  const auto d = a_distancia(ps, p);
  const bool is_inside = potencia(s, e, p) < 0;
  return s.de_que_tipo.at(e) == Tipo::soy_esfera && d && cuadrado(r) == d->square && (is_inside ? r <= 0 : r >= 0);
}

bool antes(const ExactPoint& a, const ExactPoint& b) {
  if (a.x != b.x) return a.x < b.x;
  return a.y != b.y ? a.y < b.y : a.z <= b.z;
}

bool mas_cercano(const Escena& s, const Punto& p, const Distancia& d, const ExactPoint& w, const std::set<Elemento>& en,
                 std::span<const ExactPoint> otros) {
  std::set<Elemento> attain = de_que_elemento(s, w);
  if (attain.empty() || distancia(w, p) != d) return false;
  for (const ExactPoint& otro : otros) {
    const auto order = distancia(otro, p) <=> d;
    if (order < 0 || (order == 0 && !antes(w, otro))) return false;
    if (order == 0) attain.merge(de_que_elemento(s, otro));
  }
  return attain == en;
}

}  // namespace durero::model
