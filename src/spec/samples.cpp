#include "durero/spec/samples.hpp"

#include <initializer_list>

#include "durero/model/malla.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/model/vista.hpp"
#include "durero/scene/retrieve.hpp"
#include "durero/scene/stage.hpp"
#include "durero/scene/tablas.hpp"
#include "durero/spec/spec.hpp"
#include "shape_samples.hpp"

namespace durero::spec {
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
  found.reserve(from.size());
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
struct EditedTables {
  std::vector<zed::Value> alone, with_scene;
  void add(const scene::Scene& scene) {
    Named both = components(tablas(scene));
    alone.push_back(binding(both));
    for (auto& component : components(retrieve(scene))) both.push_back(std::move(component));
    with_scene.push_back(binding(std::move(both)));
  }
};

EditedTables tables() {
  scene::Scene scene;
  EditedTables found;
  found.add(scene);
  for (const Operation& edit : edits()) {
    scene.apply(edit);
    found.add(scene);
  }
  return found;
}

/// A square of two faces, its points alone, a face with a corner twice, and one that names a point that there is not.
std::vector<Red> nets() {
  const std::vector<Punto> square{origin, Punto(2, 0, 0), Punto(2, 2, 0), Punto(0, 2, 0)};
  return {Red::of(square, {{0, 1, 2}, {0, 2, 3}}), Red::of(square, {}), Red::of(square, {{0, 1, 1}}),
          Red::of(square, {{0, 1, 4}})};
}

/// The meshes whose faces have names.
std::set<Elemento> mesh_names() { return {Elemento("a"), Elemento("e1"), Elemento("e2")}; }

/// Scenes with meshes: none, one, two and some beside other elements, and one whose vertex was moved.
std::vector<zed::Value> scenes_with_meshes() {
  Mallas s = Init_Mallas();
  std::vector<zed::Value> found;
  const auto keep = [&] { found.push_back(binding(components(s))); };
  keep();
  const std::vector<Red> some = nets();
  for (const MeshOperation& edit :
       std::vector<MeshOperation>{Agregar_Malla{Elemento("a"), some[0]}, Agregar_Malla{Elemento("e1"), some[1]},
                                  Mover_Vertice{Elemento("a"), 2, Punto(2, 2, 1)},
                                  Reemplazar_Malla{Elemento("e1"), some[0]}, Eliminar_Malla{Elemento("a")}}) {
    apply(s, edit);
    keep();
  }
  apply_total(s, Agregar_Esfera{Elemento("e1"), origin, 1});
  apply_total(s, Agregar_Triangulo{Elemento("a:0"), Terna{origin, aside, far_point}});
  keep();
  return found;
}

/// Scenes with looks: without any, with a material, with a group, and with both.
std::vector<zed::Value> scenes_with_looks() {
  Escena escena = Init();
  for (const Operation& edit : {edits()[0], edits()[2], edits()[3]}) apply(escena, edit);
  const Elemento e1("e1"), e3("e3"), e4("e4");
  const std::set<Nombre> grupos{"g1", "g2"}, materiales{"m1", "m2"};
  std::vector<zed::Value> found{binding(components(Vista{Init(), {}, {}, {}, {}}))};
  for (const Vista& s :
       {Vista{escena, grupos, materiales, {}, {}}, Vista{escena, grupos, materiales, {}, {{e1, "m1"}, {e4, "m2"}}},
        Vista{escena, grupos, materiales, {{e1, "g1"}, {e3, "g2"}}, {}},
        Vista{escena, grupos, materiales, {{e1, "g2"}, {e4, "g2"}}, {{e1, "m2"}, {e3, "m2"}}}})
    found.push_back(binding(components(s)));
  return found;
}

/// Pairs of triangles that share an edge across the third axis, or beside it: flat, and folded.
std::vector<zed::Value> neighbours() {
  const Punto left(-2, 0, 5), right(2, 0, 5), front(0, -3, 5), back(0, 3, 5), raised(0, 3, 7);
  const auto pair = [](const Punto& a, const Punto& b, const Punto& c, const Punto& d) {
    return zed::Value::pair(value(Terna{a, b, c}), value(Terna{b, a, d}));
  };
  return {pair(left, right, back, front), pair(right, left, front, raised), pair(front, back, left, right),
          pair(aside, right, back, front)};
}

std::vector<zed::Value> names() {
  std::vector<zed::Value> found;
  for (int i = 1; i <= 9; ++i) found.push_back(value(Elemento("e" + std::to_string(i))));
  for (const char* each : {"a", "a:0", "e1:1"}) found.push_back(value(Elemento(each)));
  return found;
}

/// With a unit vector, exactly, that is no axis: binary64 has none such.
zed::Value exact_vector(const zed::Real& x, const zed::Real& y, const zed::Real& z) {
  return zed::Value::point(zed::signature({{"x", ""}, {"y", ""}, {"z", ""}}), x, y, z);
}

/// With unit vectors, exactly, that are no axes: binary64 has none such. The last has 45 degrees to `up` and
/// `sideways`.
std::vector<zed::Value> vectors() {
  auto found = values<Vector>({up, sideways, Vector(0, 0, 2), Vector(0.6, 0, 0.8)});
  const zed::Real none(0), fifth = zed::Real(1) / zed::Real(5), slant = square_root(zed::Real(0.5));
  found.push_back(exact_vector(zed::Real(3) * fifth, none, zed::Real(4) * fifth));
  found.push_back(exact_vector(slant, none, slant));
  return found;
}

zed::Value value_of_name(const char* name) { return zed::Value::atom("Nombre", name); }

std::vector<zed::Value> numbers(std::initializer_list<double> from) {
  std::vector<zed::Value> found;
  for (const double each : from) found.emplace_back(zed::Real(each));
  return found;
}

struct LookCoefficients {
  double k_a, k_d, k_s, k_ps, k_t, C, M_PS, M_T, emisividad, A_G, e, indice;
};

/// Surfaces that are dull, without colour, without highlight, and that send on all of what they receive or more. The
/// exponents are such that a power has a name in our numbers.
constexpr LookCoefficients looks[] = {
    {0.25, 0.5, 0.25, 0.5, 0.5, 1, 1, 0.5, 0, 0.5, 2, 1.5},
    {0.5, 0.5, 0.5, 0, 0, 0, 1, 1, 0, 0, 4, 1},
    {0.5, 0.5, 0, 0.25, 0.25, 0.5, 1, 1, 2, 0.25, 1, 1.25},
    {0.5, 0, 0, 0, 1, 0.5, 0, 1, 1, 0.5, 0, 2},
    {0, 0.25, 1, 1, 1, 0, 1, 1, 0.5, 0, 1, 0.5},
    {1, 1, 1, 1, 0, 1, 1, 1, 0, 0, 3, 1.5},
};

zed::Value material(const LookCoefficients& m) {
  return binding({{{"k_a", ""}, zed::Real(m.k_a)},
                  {{"k_d", ""}, zed::Real(m.k_d)},
                  {{"k_s", ""}, zed::Real(m.k_s)},
                  {{"k_ps", ""}, zed::Real(m.k_ps)},
                  {{"k_t", ""}, zed::Real(m.k_t)},
                  {{"C", ""}, zed::Real(m.C)},
                  {{"M_PS", ""}, zed::Real(m.M_PS)},
                  {{"M_T", ""}, zed::Real(m.M_T)},
                  {{"emisividad", ""}, zed::Real(m.emisividad)},
                  {{"A_G", ""}, zed::Real(m.A_G)},
                  {{"e", ""}, zed::Real(m.e)},
                  {{"indice", ""}, zed::Real(m.indice)}});
}

std::vector<zed::Value> materials(bool (*admits)(const LookCoefficients&)) {
  std::vector<zed::Value> found;
  for (const LookCoefficients& look : looks)
    if (admits(look)) found.push_back(material(look));
  return found;
}

/// Windows of two by one, three by two and one by one pixels: upright before the eye, and slanting past it.
std::vector<zed::Value> windows() {
  const auto window = [](const Punto& ojo, const Punto& esquina, const Vector& ancho, const Vector& alto, int H,
                         int V) {
    return binding({{{"ojo", ""}, spec::value(ojo)},
                    {{"esquina", ""}, spec::value(esquina)},
                    {{"ancho", ""}, spec::value(ancho)},
                    {{"alto", ""}, spec::value(alto)},
                    {{"H", ""}, zed::Real(H)},
                    {{"V", ""}, zed::Real(V)}});
  };
  return {window(origin, Punto(-2, 1, 4), Vector(4, 0, 0), Vector(0, -2, 0), 2, 1),
          window(near_point, Punto(-3, 2, 5), Vector(6, 0, 0.5), Vector(0, -4, 1), 3, 2),
          window(aside, origin, sideways, up, 1, 1)};
}

/// Lights that are seen, and one that is not.
std::vector<zed::Value> lights() {
  const auto light = [](const Vector& l, double S, double V) {
    return binding({{{"l", ""}, spec::value(l)}, {{"S", ""}, zed::Real(S)}, {{"V", ""}, zed::Real(V)}});
  };
  return {light(up, 1, 1), light(sideways, 0.5, 1), light(Vector(0, 0, -1), 2, 0)};
}

}  // namespace

zed::Samples samples() {
  const std::vector<Rayo> rays = {{origin, up},
                                  {near_point, up},
                                  {high_point, Vector(-3, -4, -1)},
                                  {origin, Vector(1, 0, 5)},
                                  {Punto(1, 0, -2), up},
                                  {Punto(5, 0, 5), Vector(-1, 0, 0)}};
  EditedTables of_edits = tables();
  zed::Samples all = {
      {"Escena", scenes()},
      {"Mallas", scenes_with_meshes()},
      {"Vista", scenes_with_looks()},
      {"Nombre", {value_of_name("g1"), value_of_name("g2"), value_of_name("m1"), value_of_name("m2")}},
      {"Red", values(nets())},
      {"Vecinos", neighbours()},
      {"Init_Tablas", {of_edits.alone.front()}},
      {"Tablas", std::move(of_edits.alone)},
      {"Retrieve", std::move(of_edits.with_scene)},
      {"Elemento", names()},
      {"Rayo", values(rays)},
      {"Punto", values<Punto>({near_point, far_point, aside, origin, high_point, Punto(0, 0, 8)})},
      {"Vector", vectors()},
      {"Terna", values<Terna>({{origin, aside, high_point}, {origin, near_point, far_point}})},
      {"ℝ", numbers({1, 0.5, 3, 2, 0, -2})},
      {"ℤ", numbers({0, 1, 2})},
      {"Rmas", numbers({4, 1, 6, 2, 0.5, 7})},
      {"Parte", numbers({0, 0.25, 0.5, 1})},
      {"Cantidad", numbers({0, 0.5, 1, 2, 5})},
      {"Material", materials([](const LookCoefficients&) { return true; })},
      {"conserva",
       materials([](const LookCoefficients& m) { return m.k_ps * m.M_PS + m.k_t * m.M_T <= 1; })},  // exact: eighths
      {"Fuente", lights()},
      {"Ventana", windows()},
  };
  add_lifted_samples(edits(), all);
  return all;
}

zed::Valuation sample_constants() { return {{{"nombre_cara", ""}, names_of_faces(mesh_names(), 2)}}; }

}  // namespace durero::spec
