#pragma once
/// A scene with a mesh of two faces that share an edge, one mesh without faces, and a sphere.

#include "durero/model/malla.hpp"
#include "durero/model/operaciones.hpp"

namespace durero::test {

inline const model::Elemento square_mesh("m"), loose_points("w"), fresh_mesh("x"), single_sphere("s"), face_zero("m:0"),
    face_one("m:1"), fresh_face("x:0"), endless(std::string(128, 'l'));
inline const std::vector<model::Punto> square_points{model::Punto(0, 0, 0), model::Punto(4, 0, 0),
                                                     model::Punto(4, 4, 0), model::Punto(0, 4, 0)};

/// The square, cut along a diagonal.
inline model::Red square() { return model::Red::of(square_points, {{0, 1, 2}, {0, 2, 3}}); }
/// One of its faces.
inline model::Red half_square() { return model::Red::of(square_points, {{0, 1, 2}}); }
/// A face that has a corner twice.
inline model::Red flat_face() { return model::Red::of(square_points, {{0, 1, 1}}); }
/// A face that names a point that there is not.
inline model::Red incomplete_face() { return model::Red::of(square_points, {{0, 1, 4}}); }

inline model::Mallas with_square() {
  model::Mallas s = model::Init_Mallas();
  model::apply_total(s, model::Agregar_Esfera{single_sphere, square_points[0], 1});
  model::apply(s, model::Agregar_Malla{square_mesh, square()});
  model::apply(s, model::Agregar_Malla{loose_points, model::Red::of(square_points, {})});
  return s;
}

}  // namespace durero::test
