#include "durero/model/tipo/cono.hpp"

#include "model/sampling.hpp"

namespace durero::model {

Surd potencia_cono(const ExactPoint& w, const Punto& centro, const Rmas& prop, const Vector& dir, const Rmas& h) {
  const Surd s = avance(w, centro, dir);
  return alejamiento(w, centro, dir) - cuadrado(prop.value() * s - Surd(h.value()) * prop.value());
}

Puntos puntos_cono(const Punto& centro, const Rmas& prop, const Vector& dir, const Rmas& h) {
  return axial_points([=](const ExactPoint& w) { return potencia_cono(w, centro, prop, dir, h); }, centro, dir, h);
}

Potencia Cono::potencia(const Escena& s, const Elemento& e) {
  return [centro = s.mi_centro.at(e), prop = s.mi_proporcion.at(e), dir = s.mi_vector.at(e),
          h = s.mi_altura.at(e)](const ExactPoint& w) { return potencia_cono(w, centro, prop, dir, h); };
}

Puntos Cono::puntos(const Escena& s, const Elemento& e) {
  return puntos_cono(s.mi_centro.at(e), s.mi_proporcion.at(e), s.mi_vector.at(e), s.mi_altura.at(e));
}

}  // namespace durero::model
