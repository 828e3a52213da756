#include "durero/model/tipo/disco.hpp"

#include "durero/model/tipo/esfera.hpp"
#include "durero/model/tipo/plano.hpp"
#include "model/sampling.hpp"

namespace durero::model {

Puntos puntos_disco(const Punto& centro, const Rmas& radio, const Vector& dir) {
  const auto of_ball = [=](const ExactPoint& w) { return potencia_esfera(w, centro, radio); };
  const auto member = [=](const ExactPoint& w) { return potencia_plano(w, centro, dir) == 0 && of_ball(w) <= 0; };
  // A line through the centre at a right angle to the axis meets the rim twice; the share of a radius by the sum of its
  // components, which is no less than its length, lies within.
  return Puntos(member, [=](Random& random) -> std::optional<ExactPoint> {
    const ExactVector aside = any_normal(dir, random);
    if (random() % 2 == 0) return any_crossing(of_ball, member, centro, aside, random);
    const Rational extent = abs(aside.x) + abs(aside.y) + abs(aside.z);
    return along(centro, aside, Surd(Rational(any_share(random) * number::exact(radio.value()) / extent)));
  });
}

Potencia Disco::potencia(const Escena& s, const Elemento& e) {
  return [centro = s.mi_centro.at(e), dir = s.mi_vector.at(e)](const ExactPoint& w) {
    return potencia_plano(w, centro, dir);
  };
}

Puntos Disco::puntos(const Escena& s, const Elemento& e) {
  return puntos_disco(s.mi_centro.at(e), s.mi_radio.at(e), s.mi_vector.at(e));
}

}  // namespace durero::model
