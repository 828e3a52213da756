#include "durero/model/tipo/cilindro.hpp"

#include "model/sampling.hpp"

namespace durero::model {

Surd potencia_cilindro(const ExactPoint& w, const Punto& centro, const Rmas& radio, const Vector& dir) {
  return alejamiento(w, centro, dir) - cuadrado(radio.value());
}

Puntos puntos_cilindro(const Punto& centro, const Rmas& radio, const Vector& dir, const Rmas& h) {
  return axial_points([=](const ExactPoint& w) { return potencia_cilindro(w, centro, radio, dir); }, centro, dir, h);
}

Potencia Cilindro::potencia(const Escena& s, const Elemento& e) {
  return [centro = s.mi_centro.at(e), radio = s.mi_radio.at(e), dir = s.mi_vector.at(e)](const ExactPoint& w) {
    return potencia_cilindro(w, centro, radio, dir);
  };
}

Puntos Cilindro::puntos(const Escena& s, const Elemento& e) {
  return puntos_cilindro(s.mi_centro.at(e), s.mi_radio.at(e), s.mi_vector.at(e), s.mi_altura.at(e));
}

}  // namespace durero::model
