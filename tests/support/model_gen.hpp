#pragma once
/// RapidCheck generators for the model: elements of few names, so that they meet; operations that hold and that do not.

#include <rapidcheck.h>

#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include "durero/model/operaciones.hpp"

namespace durero::test {

/// Few names, some too long to lie inside a std::string.
inline rc::Gen<model::Elemento> any_element() {
  return rc::gen::map(rc::gen::inRange(0, 8), [](int i) {
    return model::Elemento(i < 4 ? std::string(1, static_cast<char>('a' + i))
                                 : "an.element:with-a-long-name_" + std::to_string(i));
  });
}

/// A binary64 of a moderate size, often an integer or a quarter.
inline rc::Gen<double> any_coordinate() {
  return rc::gen::oneOf(rc::gen::map(rc::gen::inRange(-40, 41), [](int i) { return i / 4.0; }),
                        rc::gen::map(rc::gen::arbitrary<std::int32_t>(), [](std::int32_t i) { return i * 0x1p-24; }));
}

inline rc::Gen<model::Punto> any_point() {
  return rc::gen::apply([](double x, double y, double z) { return model::Punto(x, y, z); }, any_coordinate(),
                        any_coordinate(), any_coordinate());
}

inline rc::Gen<model::Vector> any_vector() {
  return rc::gen::apply([](double x, double y, double z) { return model::Vector(x, y, z); }, any_coordinate(),
                        any_coordinate(), any_coordinate());
}

inline model::Vector normalised(const model::Vector& v) {
  const double length = std::sqrt(v.x() * v.x() + v.y() * v.y() + v.z() * v.z());
  return {v.x() / length, v.y() / length, v.z() / length};
}

/// In Unitario.
inline rc::Gen<model::Vector> any_axis() {
  const auto not_null =
      rc::gen::suchThat(any_vector(), [](const model::Vector& v) { return v != model::Vector(0, 0, 0); });
  return rc::gen::oneOf(rc::gen::element(model::Vector(1, 0, 0), model::Vector(0, -1, 0), model::Vector(0, 0.6, 0.8)),
                        rc::gen::map(not_null, normalised));
}

/// In Rmas.
inline rc::Gen<double> any_length() {
  return rc::gen::oneOf(rc::gen::map(rc::gen::inRange(1, 40), [](int i) { return i / 4.0; }),
                        rc::gen::map(rc::gen::inRange<std::int64_t>(1, 1LL << 40),
                                     [](std::int64_t i) { return static_cast<double>(i) * 0x1p-32; }));
}

/// Mostly in Rmas.
inline rc::Gen<double> any_real() {
  return rc::gen::weightedOneOf<double>({{8, any_length()}, {1, rc::gen::element(0.0, -0.0, -1.0, INFINITY, NAN)}});
}

/// Mostly in Unitario.
inline rc::Gen<model::Vector> any_direction() {
  return rc::gen::weightedOneOf<model::Vector>({{8, any_axis()}, {1, any_vector()}});
}

/// Now and then on one line.
inline rc::Gen<model::Terna> any_terna() {
  const auto any = rc::gen::apply(
      [](model::Punto a, model::Punto b, model::Punto c) {
        return model::Terna{a, b, c};
      },
      any_point(), any_point(), any_point());
  const auto on_a_line = rc::gen::apply(
      [](model::Punto a, model::Punto b) {
        return model::Terna{a, b, model::Punto(2.0 * b.xyz() - a.xyz())};
      },
      any_point(), any_point());
  return rc::gen::weightedOneOf<model::Terna>({{8, any}, {1, on_a_line}});
}

inline rc::Gen<model::Tipo> any_type() {
  return rc::gen::map(rc::gen::inRange<std::size_t>(0, model::tipo_count),
                      [](std::size_t i) { return model::Tipo(i); });
}

/// Nearly always the type given.
inline rc::Gen<model::Tipo> nearly_always(model::Tipo t) {
  return rc::gen::weightedOneOf<model::Tipo>({{12, rc::gen::just(t)}, {1, any_type()}});
}

/// Any of the operations; its name may be taken or unknown, its lengths, axis or type may be wrong.
inline rc::Gen<model::Operation> any_operation() {
  using namespace model;
  using rc::gen::apply;
  const auto general = [](Elemento e, Tipo t, Punto p, double r, Vector v, double h, double k, Terna vertices) {
    return Operation(Agregar_Elemento{e, t, p, r, v, h, k, vertices});
  };
  const auto sphere = [](Elemento e, Punto p, double r, Tipo t) { return Operation(Agregar_Esfera{e, p, r, t}); };
  const auto cylinder = [](Elemento e, Punto p, double r, Vector v, double h, Tipo t) {
    return Operation(Agregar_Cilindro{e, p, r, v, h, t});
  };
  const auto cone = [](Elemento e, Punto p, double k, Vector v, double h, Tipo t) {
    return Operation(Agregar_Cono{e, p, k, v, h, t});
  };
  const auto truncated = [](Elemento e, Punto p, double r, double k, Vector v, double h, Tipo t) {
    return Operation(Agregar_Tronco{e, p, r, k, v, h, t});
  };
  const auto plane = [](Elemento e, Punto p, Vector v, Tipo t) { return Operation(Agregar_Plano{e, p, v, t}); };
  const auto disc = [](Elemento e, Punto p, double r, Vector v, Tipo t) {
    return Operation(Agregar_Disco{e, p, r, v, t});
  };
  const auto triangle = [](Elemento e, Terna v, Tipo t) { return Operation(Agregar_Triangulo{e, v, t}); };
  return rc::gen::weightedOneOf<Operation>({
      {3, apply(sphere, any_element(), any_point(), any_real(), nearly_always(Tipo::soy_esfera))},
      {3, apply(cylinder, any_element(), any_point(), any_real(), any_direction(), any_real(),
                nearly_always(Tipo::soy_cilindro))},
      {3,
       apply(cone, any_element(), any_point(), any_real(), any_direction(), any_real(), nearly_always(Tipo::soy_cono))},
      {3, apply(truncated, any_element(), any_point(), any_real(), any_real(), any_direction(), any_real(),
                nearly_always(Tipo::soy_tronco))},
      {3, apply(plane, any_element(), any_point(), any_direction(), nearly_always(Tipo::soy_plano))},
      {3, apply(disc, any_element(), any_point(), any_real(), any_direction(), nearly_always(Tipo::soy_disco))},
      {3, apply(triangle, any_element(), any_terna(), nearly_always(Tipo::soy_triangulo))},
      {3, apply(general, any_element(), any_type(), any_point(), any_real(), any_direction(), any_real(), any_real(),
                any_terna())},
      {2, rc::gen::map(any_element(), [](Elemento e) { return Operation(Eliminar_Esfera{e}); })},
      {2, rc::gen::map(any_element(), [](Elemento e) { return Operation(Eliminar_Cilindro{e}); })},
      {2, rc::gen::map(any_element(), [](Elemento e) { return Operation(Eliminar_Cono{e}); })},
      {2, rc::gen::map(any_element(), [](Elemento e) { return Operation(Eliminar_Tronco{e}); })},
      {2, rc::gen::map(any_element(), [](Elemento e) { return Operation(Eliminar_Plano{e}); })},
      {2, rc::gen::map(any_element(), [](Elemento e) { return Operation(Eliminar_Disco{e}); })},
      {2, rc::gen::map(any_element(), [](Elemento e) { return Operation(Eliminar_Triangulo{e}); })},
      {2, rc::gen::map(any_element(), [](Elemento e) { return Operation(Eliminar_Elemento{e}); })},
  });
}

inline rc::Gen<std::vector<model::Operation>> any_operations() {
  return rc::gen::container<std::vector<model::Operation>>(any_operation());
}

}  // namespace durero::test

namespace durero::model {

// How RapidCheck prints a counterexample.
inline std::ostream& operator<<(std::ostream& out, const Elemento& e) { return out << e.name(); }
inline std::ostream& operator<<(std::ostream& out, Tipo t) { return out << name(t); }
inline std::ostream& operator<<(std::ostream& out, Respuesta r) { return out << name(r); }
inline std::ostream& operator<<(std::ostream& out, const Punto& p) {
  return out << '(' << p.x() << ", " << p.y() << ", " << p.z() << ')';
}
inline std::ostream& operator<<(std::ostream& out, const Vector& v) {
  return out << '(' << v.x() << ", " << v.y() << ", " << v.z() << ')';
}
inline std::ostream& operator<<(std::ostream& out, const Terna& v) {
  return out << '(' << v.a << ", " << v.b << ", " << v.c << ')';
}
template <class Value>
  requires requires(std::ostream& out, const Value& x) { out << x; }
std::ostream& operator<<(std::ostream& out, const std::optional<Value>& x) {
  return x ? out << *x : out << "absent";
}
inline std::ostream& operator<<(std::ostream& out, const Operation& operation) {
  return std::visit(
      [&](const auto& in) -> std::ostream& {
        out << '#' << operation.index() << " e? = " << in.e;
        if constexpr (requires { in.t; }) out << " t? = " << in.t;
        if constexpr (requires { out << in.centro; }) out << " centro? = " << in.centro;
        if constexpr (requires { out << in.radio; }) out << " radio? = " << in.radio;
        if constexpr (requires { out << in.proporcion; }) out << " proporcion? = " << in.proporcion;
        if constexpr (requires { out << in.vector; }) out << " vector? = " << in.vector;
        if constexpr (requires { out << in.altura; }) out << " altura? = " << in.altura;
        if constexpr (requires { out << in.vertices; }) out << " vertices? = " << in.vertices;
        return out;
      },
      operation);
}

}  // namespace durero::model
