#include "durero/model/tipo/plano.hpp"

#include "model/sampling.hpp"

namespace durero::model {

Surd potencia_plano(const ExactPoint& w, const Punto& centro, const Vector& dir) { return avance(w, centro, dir); }

Puntos puntos_plano(const Punto& centro, const Vector& dir) {
  const auto member = [=](const ExactPoint& w) { return potencia_plano(w, centro, dir) == 0; };
  // Two steps at a right angle to the normal do not change the advance, which is 0 at the centre.
  return Puntos(member, [=](Random& random) -> std::optional<ExactPoint> {
    const ExactPoint aside = along(centro, any_normal(dir, random), Surd(any_share(random)));
    return along(aside, any_normal(dir, random), Surd(any_share(random)));
  });
}

Potencia Plano::potencia(const Escena& s, const Elemento& e) {
  return [centro = s.mi_centro.at(e), dir = s.mi_vector.at(e)](const ExactPoint& w) {
    return potencia_plano(w, centro, dir);
  };
}

Puntos Plano::puntos(const Escena& s, const Elemento& e) { return puntos_plano(s.mi_centro.at(e), s.mi_vector.at(e)); }

}  // namespace durero::model
