#pragma once
/// A scene with one element of each type, and one operation of each kind.

#include "durero/model/escena.hpp"
#include "durero/model/operaciones.hpp"

namespace durero::test {

inline const model::Elemento esfera("esfera"), cilindro("cilindro"), cono("cono"), tronco("tronco"), plano("plano"),
    disco("disco"), triangulo("triangulo"), nuevo("nuevo");
inline const model::Punto origin(0, 0, 0), far(3, 4, 12);
inline const model::Vector axis(0, 0, 1), not_unit(0, 1, 1);

inline const model::Agregar_Esfera agregar_esfera{nuevo, far, 2};
inline const model::Agregar_Cilindro agregar_cilindro{nuevo, far, 2, axis, 5};
inline const model::Agregar_Cono agregar_cono{nuevo, far, 2, axis, 5};
inline const model::Agregar_Tronco agregar_tronco{nuevo, far, 3, 2, axis, 5};

inline const model::Agregar_Plano agregar_plano{nuevo, far, axis};
inline const model::Agregar_Disco agregar_disco{nuevo, far, 2, axis};

/// The right angle at the origin, and another triangle.
inline const model::Terna corners{origin, model::Punto(4, 0, 0), model::Punto(0, 4, 0)},
    other_corners{far, origin, model::Punto(0, 0, 1)};
/// On one line, exactly.
inline const model::Terna aligned{origin, model::Punto(1, 2, 3), model::Punto(-2, -4, -6)};
inline const model::Agregar_Triangulo agregar_triangulo{nuevo, other_corners};

inline model::Escena one_of_each() {
  model::Escena escena = model::Init();
  model::apply(escena, model::Agregar_Esfera{esfera, origin, 1});
  model::apply(escena, model::Agregar_Cilindro{cilindro, origin, 1, axis, 3});
  model::apply(escena, model::Agregar_Cono{cono, origin, 0.5, axis, 3});
  model::apply(escena, model::Agregar_Tronco{tronco, origin, 1, 0.5, axis, 3});
  model::apply(escena, model::Agregar_Plano{plano, origin, axis});
  model::apply(escena, model::Agregar_Disco{disco, origin, 1, axis});
  model::apply(escena, model::Agregar_Triangulo{triangulo, corners});
  return escena;
}

}  // namespace durero::test
