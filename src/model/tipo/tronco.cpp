#include "durero/model/tipo/tronco.hpp"

#include "model/sampling.hpp"

namespace durero::model {

Surd potencia_tronco(const ExactPoint& w, const Punto& centro, const Rmas& radio, const Rmas& prop, const Vector& dir,
                     const Rmas& h) {
  const Surd s = avance(w, centro, dir);
  return alejamiento(w, centro, dir) - cuadrado(radio.value() + prop.value() * (h.value() - s));
}

Puntos puntos_tronco(const Punto& centro, const Rmas& radio, const Rmas& prop, const Vector& dir, const Rmas& h) {
  return axial_points([=](const ExactPoint& w) { return potencia_tronco(w, centro, radio, prop, dir, h); }, centro, dir,
                      h);
}

Potencia Tronco::potencia(const Escena& s, const Elemento& e) {
  return [centro = s.mi_centro.at(e), radio = s.mi_radio.at(e), prop = s.mi_proporcion.at(e), dir = s.mi_vector.at(e),
          h = s.mi_altura.at(e)](const ExactPoint& w) { return potencia_tronco(w, centro, radio, prop, dir, h); };
}

Puntos Tronco::puntos(const Escena& s, const Elemento& e) {
  return puntos_tronco(s.mi_centro.at(e), s.mi_radio.at(e), s.mi_proporcion.at(e), s.mi_vector.at(e),
                       s.mi_altura.at(e));
}

}  // namespace durero::model
