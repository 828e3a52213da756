#include "durero/oracle/samples.hpp"

#include "durero/model/operaciones.hpp"
#include "durero/oracle/spec.hpp"
#include "durero/scene/retrieve.hpp"

namespace durero::oracle::spec {
namespace {

using namespace model;

// Everything lies about the third axis, so that few small numbers make many meetings.
const Punto origin(0, 0, 0), near_point(0, 0, 4), far_point(0, 0, 6), aside(1, 0, 5), high_point(3, 4, 5);
const Vector up(0, 0, 1), sideways(1, 0, 0);

std::vector<Operation> edits() {
  const auto e = [](const char* name) { return Elemento(name); };
  return {
      Agregar_Esfera{e("e1"), Punto(0, 0, 5), 1},
      Agregar_Cilindro{e("e2"), origin, 1, up, 5},
      Agregar_Esfera{e("e3"), Punto(0, 0, 7), 1},
      Agregar_Cono{e("e4"), Punto(0, 0, 4), 1, up, 2},
      Agregar_Plano{e("e5"), near_point, up},
      Agregar_Disco{e("e6"), far_point, 5, up},
      Agregar_Tronco{e("e7"), origin, 3, 0.5, up, 4},
      Agregar_Triangulo{e("e8"), Terna{Punto(-2, -2, 6), Punto(4, 0, 6), Punto(0, 8, 6)}},
      Agregar_Plano{e("e9"), high_point, sideways},
      Eliminar_Esfera{e("e1")},
      Eliminar_Plano{e("e5")},
      Eliminar_Triangulo{e("e8")},
  };
}

template <class T>
std::vector<zed::Value> values(const std::vector<T>& from) {
  std::vector<zed::Value> found;
  for (const T& each : from) found.push_back(value(each));
  return found;
}

std::vector<zed::Value> scenes() {
  Escena escena = Init();
  std::vector<zed::Value> found = {value(escena)};
  for (const Operation& edit : edits()) {
    apply(escena, edit);
    found.push_back(value(escena));
  }
  return found;
}

/// The tables that the same edits make, and with the scenes that they stand for.
struct Tables {
  std::vector<zed::Value> alone, with_scene;
  void add(const scene::Scene& scene) {
    Named both = components(tablas(scene));
    alone.push_back(binding(both));
    for (auto& component : components(retrieve(scene))) both.push_back(std::move(component));
    with_scene.push_back(binding(std::move(both)));
  }
};

Tables tables() {
  scene::Scene scene;
  Tables found;
  found.add(scene);
  for (const Operation& edit : edits()) {
    scene.apply(edit);
    found.add(scene);
  }
  return found;
}

std::vector<zed::Value> names() {
  std::vector<zed::Value> found;
  for (int i = 1; i <= 9; ++i) found.push_back(value(Elemento("e" + std::to_string(i))));
  found.push_back(value(Elemento("a")));
  return found;
}

/// With a unit vector, exactly, that is no axis: binary64 has none such.
std::vector<zed::Value> vectors() {
  auto found = values<Vector>({up, sideways, Vector(0, 0, 2), Vector(0.6, 0, 0.8)});
  const auto fifths = [](int n) { return zed::Real(n) / zed::Real(5); };
  found.push_back(
      zed::Value::point(zed::signature({{"x", ""}, {"y", ""}, {"z", ""}}), fifths(3), fifths(0), fifths(4)));
  return found;
}

std::vector<zed::Value> lengths() {
  std::vector<zed::Value> found;
  for (const double length : {1.0, 0.5, 3.0, 0.0, -2.0}) found.emplace_back(zed::Real(length));
  return found;
}

std::vector<zed::Value> parameters() {
  std::vector<zed::Value> found;
  for (const double t : {4.0, 1.0, 6.0, 2.0, 0.5, 7.0}) found.emplace_back(zed::Real(t));
  return found;
}

}  // namespace

zed::Samples samples() {
  const std::vector<Rayo> rays = {{origin, up},
                                  {near_point, up},
                                  {high_point, Vector(-3, -4, -1)},
                                  {origin, Vector(1, 0, 5)},
                                  {Punto(1, 0, -2), up},
                                  {Punto(5, 0, 5), Vector(-1, 0, 0)}};
  Tables of_edits = tables();
  return {
      {"Escena", scenes()},
      {"Init_Tablas", {of_edits.alone.front()}},
      {"Tablas", std::move(of_edits.alone)},
      {"Retrieve", std::move(of_edits.with_scene)},
      {"Elemento", names()},
      {"Rayo", values(rays)},
      {"Punto", values<Punto>({near_point, far_point, aside, origin, high_point, Punto(0, 0, 8)})},
      {"Vector", vectors()},
      {"Terna", values<Terna>({{origin, aside, high_point}, {origin, near_point, far_point}})},
      {"ℝ", lengths()},
      {"Rmas", parameters()},
  };
}

}  // namespace durero::oracle::spec
