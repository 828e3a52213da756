#pragma once
/// RapidCheck generators of meshes and of operations on scenes with them. Points, numbers and names are few, so that
/// faces without points, on one line or with a name in use come up often.

#include "durero/model/malla.hpp"
#include "durero/model/operaciones.hpp"
#include "support/model_gen.hpp"

namespace durero::test {

/// A point of a small grid.
inline rc::Gen<model::Punto> any_grid_point() {
  const auto coordinate = rc::gen::element(0.0, 1.0, 2.0);
  return rc::gen::apply([](double x, double y, double z) { return model::Punto(x, y, z); }, coordinate, coordinate,
                        coordinate);
}

/// Points and faces that need be no mesh.
inline rc::Gen<model::Red> any_red() {
  const auto number = rc::gen::map(rc::gen::inRange(0, 5), [](int n) { return static_cast<model::Ordinal>(n); });
  const auto face = rc::gen::apply(
      [](model::Ordinal i, model::Ordinal j, model::Ordinal k) {
        return model::Cara{i, j, k};
      },
      number, number, number);
  return rc::gen::apply(
      [](const std::vector<model::Punto>& puntos, const std::vector<model::Cara>& caras) {
        return model::Red::of(puntos, caras);
      },
      rc::gen::mapcat(rc::gen::inRange<std::size_t>(3, 6),
                      [](std::size_t n) { return rc::gen::container<std::vector<model::Punto>>(n, any_grid_point()); }),
      rc::gen::mapcat(rc::gen::inRange<std::size_t>(0, 4),
                      [=](std::size_t n) { return rc::gen::container<std::vector<model::Cara>>(n, face); }));
}

/// Points and faces that are a mesh: a fan about the first point, cut short where a face would lie on a line.
inline rc::Gen<model::Red> any_mesh() {
  return rc::gen::map(rc::gen::container<std::vector<model::Punto>>(5, any_grid_point()),
                      [](const std::vector<model::Punto>& puntos) {
                        std::vector<model::Cara> caras;
                        for (model::Ordinal n = 1; n + 1 < puntos.size(); ++n)
                          if (model::Vertices::contains({puntos[0], puntos[n], puntos[n + 1]}))
                            caras.push_back({0, n, n + 1});
                        return model::Red::of(puntos, caras);
                      });
}

/// A mesh's name; the last has no room for a number.
inline rc::Gen<model::Elemento> any_mesh_name() {
  return rc::gen::weightedElement<model::Elemento>(
      {{6, model::Elemento("m")}, {3, model::Elemento("w")}, {1, model::Elemento(std::string(127, 'l'))}});
}

/// An operation on meshes, most of which can be done.
inline rc::Gen<model::MeshOperation> any_mesh_operation() {
  using Operation = model::MeshOperation;
  const auto red = rc::gen::weightedOneOf<model::Red>({{3, any_mesh()}, {1, any_red()}});
  const auto number = rc::gen::map(rc::gen::inRange(0, 6), [](int n) { return static_cast<model::Ordinal>(n); });
  return rc::gen::oneOf(
      rc::gen::apply(
          [](const model::Elemento& m, const model::Red& r) {
            return Operation(model::Agregar_Malla{m, r});
          },
          any_mesh_name(), red),
      rc::gen::map(any_mesh_name(), [](const model::Elemento& m) { return Operation(model::Eliminar_Malla{m}); }),
      rc::gen::apply(
          [](const model::Elemento& m, const model::Red& r) {
            return Operation(model::Reemplazar_Malla{m, r});
          },
          any_mesh_name(), red),
      rc::gen::apply(
          [](const model::Elemento& m, model::Ordinal n, const model::Punto& p) {
            return Operation(model::Mover_Vertice{m, n, p});
          },
          any_mesh_name(), number, any_grid_point()));
}

/// An operation on one element, which may have the name of a face.
inline rc::Gen<model::Operation> any_single_operation() {
  const auto face =
      rc::gen::element(model::Elemento("m:0"), model::Elemento("m:1"), model::Elemento("w:0"), model::Elemento("m"));
  return rc::gen::oneOf(
      any_operation(),
      rc::gen::map(face, [](const model::Elemento& e) { return model::Operation(model::Eliminar_Elemento{e}); }),
      rc::gen::map(face, [](const model::Elemento& e) { return model::Operation(model::Eliminar_Triangulo{e}); }),
      rc::gen::map(face, [](const model::Elemento& e) { return model::Operation(model::Eliminar_Esfera{e}); }),
      rc::gen::map(face, [](const model::Elemento& e) {
        return model::Operation(model::Agregar_Esfera{e, model::Punto(0, 0, 0), 1});
      }));
}

/// A scene with meshes, after some operations of either kind.
inline model::Mallas any_scene_with_meshes() {
  model::Mallas s = model::Init_Mallas();
  const int count = *rc::gen::inRange(0, 8);
  for (int i = 0; i < count; ++i) {
    if (*rc::gen::inRange(0, 4) > 0)
      model::apply_total(s, *any_mesh_operation());
    else
      model::apply_total(s, *any_single_operation());
  }
  return s;
}

}  // namespace durero::test

namespace durero::model {

inline std::ostream& operator<<(std::ostream& out, const Red& red) {
  out << "points";
  for (const auto& [n, p] : red.puntos()) out << ' ' << n << '=' << p;
  out << " faces";
  for (const auto& [n, c] : red.caras()) out << ' ' << n << "=(" << c.i << ' ' << c.j << ' ' << c.k << ')';
  return out;
}
inline std::ostream& operator<<(std::ostream& out, const Agregar_Malla& in) {
  return out << "Agregar_Malla " << in.m.name() << ' ' << in.red;
}
inline std::ostream& operator<<(std::ostream& out, const Eliminar_Malla& in) {
  return out << "Eliminar_Malla " << in.m.name();
}
inline std::ostream& operator<<(std::ostream& out, const Reemplazar_Malla& in) {
  return out << "Reemplazar_Malla " << in.m.name() << ' ' << in.red;
}
inline std::ostream& operator<<(std::ostream& out, const Mover_Vertice& in) {
  return out << "Mover_Vertice " << in.m.name() << ' ' << in.n << ' ' << in.punto;
}
inline std::ostream& operator<<(std::ostream& out, const MeshOperation& operation) {
  return std::visit([&](const auto& in) -> std::ostream& { return out << in; }, operation);
}

}  // namespace durero::model
