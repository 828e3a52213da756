#include "durero/model/tipo/esfera.hpp"

#include "model/sampling.hpp"

namespace durero::model {

Surd potencia_esfera(const ExactPoint& w, const Punto& centro, const Rmas& radio) {
  return cuadrado(w.x - centro.x()) + cuadrado(w.y - centro.y()) + cuadrado(w.z - centro.z()) - cuadrado(radio.value());
}

Puntos puntos_esfera(const Punto& centro, const Rmas& radio) {
  const auto power = [=](const ExactPoint& w) { return potencia_esfera(w, centro, radio); };
  const auto member = [=](const ExactPoint& w) { return power(w) == 0; };
  // The centre is inside, so every line through it meets the sphere twice.
  return Puntos(member,
                [=](Random& random) { return any_crossing(power, member, centro, any_direction(random), random); });
}

Potencia Esfera::potencia(const Escena& s, const Elemento& e) {
  return [centro = s.mi_centro.at(e), radio = s.mi_radio.at(e)](const ExactPoint& w) {
    return potencia_esfera(w, centro, radio);
  };
}

Puntos Esfera::puntos(const Escena& s, const Elemento& e) { return puntos_esfera(s.mi_centro.at(e), s.mi_radio.at(e)); }

}  // namespace durero::model
