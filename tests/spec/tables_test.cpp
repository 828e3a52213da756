// spec/tablas.tex, evaluated on the tables of the program itself: after random edits they satisfy the invariant, stand
// for the scene that they are to stand for, and changed as the operation on them says. And each of its labels sees what
// breaks it.
#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "durero/model/operaciones.hpp"
#include "durero/scene/retrieve.hpp"
#include "durero/scene/tablas.hpp"
#include "durero/spec/spec.hpp"
#include "support/catch.hpp"
#include "support/model_gen.hpp"
#include "support/property.hpp"

namespace durero::spec {
namespace {

using model::Elemento;
using model::Operation;
using model::Punto;
using model::Rmas;
using model::Tipo;
using scene::ElementRef;
using scene::Tablas;
using zed::Truth;

Named with(Named all, Named more, const std::string& stroke = "") {
  for (auto& [name, value] : more) all.emplace_back(zed::Name{name.word, name.strokes + stroke}, std::move(value));
  return all;
}

/// The labels of the conjuncts that do not hold, and, where there are none, that the whole schema holds.
std::set<std::string> broken(const std::string& schema, const Named& values) {
  static const Judge judge;
  static std::map<std::string, zed::SchemaCheck> checks;
  const auto [at, fresh] = checks.try_emplace(schema, judge.evaluator().schema({schema, ""}));
  const auto ordered = in_order(at->second.components(), values);
  std::set<std::string> labels;
  for (const zed::ConjunctTruth& finding : at->second.findings(ordered))
    if (finding.truth != Truth::yes) labels.insert(finding.label + finding.strokes);
  CHECK(at->second.holds(ordered) == (labels.empty() ? Truth::yes : Truth::no));
  return labels;
}

std::set<std::string> broken(const Tablas& tables) { return broken("Tablas", components(tables)); }
std::set<std::string> broken(const model::Escena& escena, const Tablas& tables) {
  return broken("Retrieve", with(components(escena), components(tables)));
}
Named step(const Tablas& before, const Operation& operation, model::Respuesta r, const Tablas& after) {
  Named all = with(components(before), components(after), "'");
  all = with(std::move(all), inputs(operation));
  all.emplace_back(zed::Name{"r", "!"}, value(r));
  return all;
}
std::set<std::string> broken(const Tablas& before, const Operation& operation, model::Respuesta r,
                             const Tablas& after) {
  return broken(schema_name(operation) + "_Tablas", step(before, operation, r, after));
}
/// Whether the text speaks of such inputs: an infinity or a NaN denotes no number.
bool is_of_the_text(const Operation& operation) {
  try {
    return !inputs(operation).empty();
  } catch (const std::domain_error&) {
    return false;
  }
}
/// Whether the total operation on the tables may do that, and answer so.
bool is_total(const Tablas& before, const Operation& operation, model::Respuesta r, const Tablas& after) {
  return broken(total_name(operation) + "_Tablas", step(before, operation, r, after)).empty();
}

/// Of the general operations, that of the type.
std::optional<Operation> specific_operation(const Operation& operation) {
  if (std::holds_alternative<model::Eliminar_Elemento>(operation)) return std::nullopt;
  if (const auto* general = std::get_if<model::Agregar_Elemento>(&operation))
    return std::visit([](auto addition) { return Operation(std::move(addition)); }, model::specific(*general));
  return std::visit(
      [](auto in) {
        if constexpr (requires { in.t = in.tipo; }) in.t = in.tipo;
        return Operation(std::move(in));
      },
      operation);
}

const Punto origin(0, 0, 0);
const model::Vector axis(0, 0, 1);
const model::Terna corners{Punto(1, 0, 0), Punto(0, 1, 0), Punto(0, 0, 1)};
const ElementRef sphere{Tipo::soy_esfera, 0}, next_sphere{Tipo::soy_esfera, 1}, cone{Tipo::soy_tronco, 0},
    triangle{Tipo::soy_triangulo, 0};
const Elemento a("a"), b("b"), k("k"), t("t"), fresh("fresh");

scene::Scene some() {
  scene::Scene scene;
  scene.apply(model::Agregar_Esfera{a, origin, 1});
  scene.apply(model::Agregar_Esfera{b, Punto(4, 0, 0), 2});
  scene.apply(model::Agregar_Tronco{k, origin, 3, 0.5, axis, 2});
  scene.apply(model::Agregar_Triangulo{t, corners});
  return scene;
}

using Labels = std::set<std::string>;

}  // namespace

TEST_CASE("after any edits the tables are those of the text, and the edit is its operation on them") {
  test::property("any edits", [] {
    scene::Scene scene;
    for (const Operation& any : *test::any_operations()) {
      const auto operation = specific_operation(any);
      const Tablas before = tablas(scene);
      scene::Scene same = scene;
      const model::Answer of_any = same.apply_total(any);
      if (is_of_the_text(any)) RC_ASSERT(is_total(before, any, of_any.r, tablas(same)));
      if (!operation) continue;
      const model::Answer answer = scene.apply_total(*operation);
      const Tablas after = tablas(scene);
      if (is_of_the_text(*operation)) RC_ASSERT(is_total(before, *operation, answer.r, after));
      RC_ASSERT(broken(after).empty());
      RC_ASSERT(broken(retrieve(scene), after).empty());
      RC_ASSERT(scene.size() == after.nombres.size());
      if (answer.ok()) RC_ASSERT(broken(before, *operation, answer.r, after).empty());
      if (!answer.ok()) RC_ASSERT(before == after);
      const bool known = before.lugar.contains(std::visit([](const auto& in) { return in.e; }, *operation));
      RC_ASSERT(answer.r != model::Respuesta::elemento_ya_existe || known);
      RC_ASSERT(answer.r != model::Respuesta::elemento_no_existe || !known);
    }
  });
}

TEST_CASE("each invariant of the tables sees what breaks it") {
  const auto after = [](auto&& change) {
    Tablas tables = tablas(some());
    change(tables);
    return broken(tables);
  };
  CHECK(after([](Tablas&) {}).empty());
  CHECK(after([](Tablas& s) { ++s.cuantos[Tipo::soy_esfera]; }) == Labels{"Tablas.inv.1"});
  CHECK(after([](Tablas& s) { std::swap(s.nombres.at(sphere), s.nombres.at(next_sphere)); }) == Labels{"Tablas.inv.2"});
  CHECK(after([](Tablas& s) { s.centros.erase(sphere); }) == Labels{"Tablas.inv.3"});
  CHECK(after([](Tablas& s) { s.radios.emplace(triangle, Rmas(1)); }) == Labels{"Tablas.inv.4"});
  CHECK(after([](Tablas& s) { s.vectores.erase(cone); }) == Labels{"Tablas.inv.5"});
  CHECK(after([](Tablas& s) { s.alturas.emplace(sphere, Rmas(1)); }) == Labels{"Tablas.inv.6"});
  CHECK(after([](Tablas& s) { s.proporciones.clear(); }) == Labels{"Tablas.inv.7"});
  CHECK(after([](Tablas& s) { s.ternas.emplace(sphere, s.ternas.at(triangle)); }) == Labels{"Tablas.inv.8"});
  // No place is out of the tables (Lugar.def.1), and no two names have one.
  CHECK(after([](Tablas& s) { s.lugar.at(a) = s.lugar.at(b); }).contains("Tablas.inv.1"));
}

TEST_CASE("the retrieve schema sees a scene that is another") {
  const auto after = [](auto&& change) {
    const scene::Scene scene = some();
    model::Escena escena = retrieve(scene);
    change(escena);
    return broken(escena, tablas(scene));
  };
  CHECK(after([](model::Escena&) {}).empty());
  // The type of an element is the table that it is in: tabla.def.1.
  CHECK(after([](model::Escena& s) { s.de_que_tipo.at(a) = Tipo::soy_plano; }).contains("Retrieve.inv.1"));
  CHECK(after([](model::Escena& s) { s.mi_centro.at(a) = Punto(1, 0, 0); }) == Labels{"Retrieve.inv.2"});
  CHECK(after([](model::Escena& s) { s.mi_radio.at(b) = Rmas(1); }) == Labels{"Retrieve.inv.3"});
  CHECK(after([](model::Escena& s) { s.mi_vector.at(k) = model::Vector(1, 0, 0); }) == Labels{"Retrieve.inv.4"});
  CHECK(after([](model::Escena& s) { s.mi_altura.at(k) = Rmas(3); }) == Labels{"Retrieve.inv.5"});
  CHECK(after([](model::Escena& s) { s.mi_proporcion.at(k) = Rmas(3); }) == Labels{"Retrieve.inv.6"});
  CHECK(after([](model::Escena& s) {
          s.mi_vertices.at(t) = model::Vertices(model::Terna{corners.b, corners.a, corners.c});
        }) == Labels{"Retrieve.inv.7"});
}

TEST_CASE("each operation on the tables holds of what the program does, and of nothing else") {
  const std::map<std::string, Operation> additions{
      {"Agregar_Esfera_Tablas.def.1", model::Agregar_Esfera{fresh, origin, 1}},
      {"Agregar_Cilindro_Tablas.def.1", model::Agregar_Cilindro{fresh, origin, 1, axis, 2}},
      {"Agregar_Cono_Tablas.def.1", model::Agregar_Cono{fresh, origin, 1, axis, 2}},
      {"Agregar_Tronco_Tablas.def.1", model::Agregar_Tronco{fresh, origin, 1, 2, axis, 2}},
      {"Agregar_Plano_Tablas.def.1", model::Agregar_Plano{fresh, origin, axis}},
      {"Agregar_Disco_Tablas.def.1", model::Agregar_Disco{fresh, origin, 1, axis}},
      {"Agregar_Triangulo_Tablas.def.1", model::Agregar_Triangulo{fresh, corners}}};
  const std::map<std::string, Operation> removals{
      {"Eliminar_Esfera_Tablas.def.1", model::Eliminar_Esfera{fresh}},
      {"Eliminar_Cilindro_Tablas.def.1", model::Eliminar_Cilindro{fresh}},
      {"Eliminar_Cono_Tablas.def.1", model::Eliminar_Cono{fresh}},
      {"Eliminar_Tronco_Tablas.def.1", model::Eliminar_Tronco{fresh}},
      {"Eliminar_Plano_Tablas.def.1", model::Eliminar_Plano{fresh}},
      {"Eliminar_Disco_Tablas.def.1", model::Eliminar_Disco{fresh}},
      {"Eliminar_Triangulo_Tablas.def.1", model::Eliminar_Triangulo{fresh}}};
  const Tablas before = tablas(some());
  for (const auto& [label, addition] : additions) {
    INFO(label);
    CHECK(schema_name(addition) + "_Tablas.def.1" == label);
    scene::Scene scene = some();
    const model::Respuesta r = scene.apply(addition);
    const Tablas with_it = tablas(scene);
    CHECK(broken(before, addition, r, with_it).empty());
    CHECK_FALSE(broken(before, addition, r, before).empty());
    CHECK_FALSE(broken(before, addition, model::Respuesta::elemento_agregado, with_it).empty());
    for (const auto& [other, removal] : removals) {
      INFO(other);
      const bool same = other.substr(other.find('_')) == label.substr(label.find('_'));
      scene::Scene less = scene;
      const model::Answer answer = less.apply_total(removal);
      CHECK(answer.ok() == same);
      CHECK(broken(with_it, removal, answer.r, tablas(less)).empty() == same);
    }
  }
}

TEST_CASE("each total operation on the tables answers as the program does, and refuses no other way") {
  const double none = 0;
  const model::Vector longer(0, 0, 2);
  const model::Terna line{origin, Punto(1, 0, 0), Punto(2, 0, 0)};
  using R = model::Respuesta;
  struct Case {
    const char* label;
    Operation done;
    std::vector<std::pair<Operation, R>> refused;
  };
  const std::vector<Case> additions{
      {"Agregar_Esfera_Total_Tablas.def.1",
       model::Agregar_Esfera{fresh, origin, 1},
       {{model::Agregar_Esfera{a, origin, 1}, R::elemento_ya_existe},
        {model::Agregar_Esfera{fresh, origin, none}, R::radio_no_positivo}}},
      {"Agregar_Cilindro_Total_Tablas.def.1",
       model::Agregar_Cilindro{fresh, origin, 1, axis, 2},
       {{model::Agregar_Cilindro{a, origin, 1, axis, 2}, R::elemento_ya_existe},
        {model::Agregar_Cilindro{fresh, origin, none, axis, 2}, R::radio_no_positivo},
        {model::Agregar_Cilindro{fresh, origin, 1, longer, 2}, R::vector_no_unitario},
        {model::Agregar_Cilindro{fresh, origin, 1, axis, none}, R::altura_no_positiva}}},
      {"Agregar_Cono_Total_Tablas.def.1",
       model::Agregar_Cono{fresh, origin, 1, axis, 2},
       {{model::Agregar_Cono{a, origin, 1, axis, 2}, R::elemento_ya_existe},
        {model::Agregar_Cono{fresh, origin, none, axis, 2}, R::proporcion_no_positiva},
        {model::Agregar_Cono{fresh, origin, 1, longer, 2}, R::vector_no_unitario},
        {model::Agregar_Cono{fresh, origin, 1, axis, none}, R::altura_no_positiva}}},
      {"Agregar_Tronco_Total_Tablas.def.1",
       model::Agregar_Tronco{fresh, origin, 1, 2, axis, 2},
       {{model::Agregar_Tronco{a, origin, 1, 2, axis, 2}, R::elemento_ya_existe},
        {model::Agregar_Tronco{fresh, origin, none, 2, axis, 2}, R::radio_no_positivo},
        {model::Agregar_Tronco{fresh, origin, 1, none, axis, 2}, R::proporcion_no_positiva},
        {model::Agregar_Tronco{fresh, origin, 1, 2, longer, 2}, R::vector_no_unitario},
        {model::Agregar_Tronco{fresh, origin, 1, 2, axis, none}, R::altura_no_positiva}}},
      {"Agregar_Plano_Total_Tablas.def.1",
       model::Agregar_Plano{fresh, origin, axis},
       {{model::Agregar_Plano{a, origin, axis}, R::elemento_ya_existe},
        {model::Agregar_Plano{fresh, origin, longer}, R::vector_no_unitario}}},
      {"Agregar_Disco_Total_Tablas.def.1",
       model::Agregar_Disco{fresh, origin, 1, axis},
       {{model::Agregar_Disco{a, origin, 1, axis}, R::elemento_ya_existe},
        {model::Agregar_Disco{fresh, origin, none, axis}, R::radio_no_positivo},
        {model::Agregar_Disco{fresh, origin, 1, longer}, R::vector_no_unitario}}},
      {"Agregar_Triangulo_Total_Tablas.def.1",
       model::Agregar_Triangulo{fresh, corners},
       {{model::Agregar_Triangulo{a, corners}, R::elemento_ya_existe},
        {model::Agregar_Triangulo{fresh, line}, R::vertices_alineados}}}};
  const auto with_one = [](const Operation& addition) {
    scene::Scene scene = some();
    scene.apply(addition);
    return scene;
  };
  const auto of = [](const char* type) { return std::string(type).substr(std::string("Agregar_").size()); };
  const std::vector<Operation> removals{model::Eliminar_Esfera{fresh},   model::Eliminar_Cilindro{fresh},
                                        model::Eliminar_Cono{fresh},     model::Eliminar_Tronco{fresh},
                                        model::Eliminar_Plano{fresh},    model::Eliminar_Disco{fresh},
                                        model::Eliminar_Triangulo{fresh}};
  const std::set<R> answers{R::esfera_agregada,   R::elemento_ya_existe, R::elemento_no_existe,
                            R::radio_no_positivo, R::vector_no_unitario, R::altura_no_positiva,
                            R::tipo_incorrecto,   R::vertices_alineados, R::proporcion_no_positiva};
  const auto refuses_so_alone = [&](const scene::Scene& scene, const Operation& operation, R answer) {
    const Tablas before = tablas(scene), other = tablas(scene::Scene());
    scene::Scene edited = scene;
    CHECK(edited.apply_total(operation).r == answer);
    for (const R each : answers) {
      INFO(total_name(operation) << " " << model::name(each));
      CHECK(is_total(before, operation, each, before) == (each == answer));
      CHECK_FALSE(is_total(before, operation, each, other));
    }
  };
  for (const auto& [label, done, refused] : additions) {
    INFO(label);
    CHECK(total_name(done) + "_Tablas.def.1" == label);
    const scene::Scene edited = with_one(done);
    scene::Scene scene = some();
    CHECK(is_total(tablas(some()), done, scene.apply_total(done).r, tablas(edited)));
    for (const auto& [operation, answer] : refused) refuses_so_alone(some(), operation, answer);
    // Eliminar_Esfera_Total_Tablas.def.1, Eliminar_Cilindro_Total_Tablas.def.1, Eliminar_Cono_Total_Tablas.def.1,
    // Eliminar_Tronco_Total_Tablas.def.1, Eliminar_Plano_Total_Tablas.def.1, Eliminar_Disco_Total_Tablas.def.1 and
    // Eliminar_Triangulo_Total_Tablas.def.1: of its own type it is removed, of another it is not.
    for (const Operation& removal : removals) {
      refuses_so_alone(some(), removal, R::elemento_no_existe);
      const bool same = total_name(removal).substr(std::string("Eliminar_").size()) + "_Tablas.def.1" == of(label);
      if (!same) refuses_so_alone(edited, removal, R::tipo_incorrecto);
      scene::Scene less = edited;
      const R r = less.apply_total(removal).r;
      if (same) CHECK(is_total(tablas(edited), removal, r, tablas(less)));
      if (same) CHECK_FALSE(is_total(tablas(edited), removal, R::tipo_incorrecto, tablas(edited)));
    }
  }
}

TEST_CASE("the general operations on the tables, and each of their refusals by its own name") {
  using R = model::Respuesta;
  const Operation remove = model::Eliminar_Elemento{a}, absent = model::Eliminar_Elemento{fresh};
  const Operation sphere_of_none = model::Agregar_Esfera{fresh, origin, 0};
  const Tablas before = tablas(some());
  scene::Scene scene = some();
  const model::Answer removed = scene.apply_total(remove);
  CHECK(removed.r == R::elemento_eliminado);
  // Eliminar_Elemento_Total_Tablas.def.1 and Elemento_Eliminado_Tablas.def.1.
  CHECK(is_total(before, remove, removed.r, tablas(scene)));
  CHECK(broken("Elemento_Eliminado_Tablas", step(before, remove, removed.r, tablas(scene))).empty());
  CHECK_FALSE(is_total(before, remove, R::esfera_eliminada, tablas(scene)));
  CHECK(is_total(before, absent, R::elemento_no_existe, before));
  CHECK_FALSE(is_total(before, absent, R::elemento_eliminado, before));
  // Agregar_Elemento_Total_Tablas.def.1 and Elemento_Agregado_Tablas.def.1.
  model::Agregar_Elemento any{fresh, Tipo::soy_disco, origin, 1, axis, 0, 0, corners};
  scene::Scene more = some();
  const model::Answer added = more.apply_total(any);
  CHECK(added.r == R::elemento_agregado);
  CHECK(is_total(before, any, added.r, tablas(more)));
  CHECK(broken("Elemento_Agregado_Tablas", step(before, any, added.r, tablas(more))).empty());
  CHECK_FALSE(is_total(before, any, R::altura_no_positiva, before));
  any.t = Tipo::soy_cilindro;
  CHECK(is_total(before, any, R::altura_no_positiva, before));
  CHECK_FALSE(is_total(before, any, R::proporcion_no_positiva, before));

  // Elemento_Ya_Existe_Tablas.def.1, Elemento_No_Existe_Tablas.def.1, Radio_No_Positivo_Tablas.def.1,
  // Vector_No_Unitario_Tablas.def.1, Altura_No_Positiva_Tablas.def.1, Proporcion_No_Positiva_Tablas.def.1,
  // Vertices_Alineados_Tablas.def.1 and De_Otra_Tabla.def.1 say why, and that nothing changes.
  const auto says = [&](const char* schema, const Operation& operation, R r, const Tablas& after) {
    return broken(schema, step(before, operation, r, after)).empty();
  };
  const Tablas other = tablas(scene::Scene());
  const Operation bad = model::Agregar_Elemento{
      fresh, Tipo::soy_tronco, origin, 0, model::Vector(0, 0, 2), 0, 0, model::Terna{origin, origin, origin}};
  const Operation good = model::Agregar_Elemento{a, Tipo::soy_tronco, origin, 1, axis, 1, 1, corners};
  struct Refusal {
    const char* schema;
    Operation refused, taken;
    R r;
  };
  for (const auto& [schema, refused, taken, r] :
       {Refusal{"Elemento_Ya_Existe_Tablas", good, bad, R::elemento_ya_existe},
        Refusal{"Elemento_No_Existe_Tablas", bad, good, R::elemento_no_existe},
        Refusal{"Radio_No_Positivo_Tablas", bad, good, R::radio_no_positivo},
        Refusal{"Vector_No_Unitario_Tablas", bad, good, R::vector_no_unitario},
        Refusal{"Altura_No_Positiva_Tablas", bad, good, R::altura_no_positiva},
        Refusal{"Proporcion_No_Positiva_Tablas", bad, good, R::proporcion_no_positiva},
        Refusal{"Vertices_Alineados_Tablas", bad, good, R::vertices_alineados},
        Refusal{"De_Otra_Tabla", good, model::Agregar_Elemento{k, Tipo::soy_tronco, origin, 1, axis, 1, 1, corners},
                R::tipo_incorrecto}}) {
    INFO(schema);
    CHECK(says(schema, refused, r, before));
    CHECK_FALSE(says(schema, taken, r, before));
    CHECK_FALSE(says(schema, refused, R::elemento_agregado, before));
    CHECK_FALSE(says(schema, refused, r, other));
  }
  CHECK(is_total(before, sphere_of_none, R::radio_no_positivo, before));
}

TEST_CASE("a column that an addition leaves is the column that there was") {
  // Centros.def.1, Radios.def.1, Vectores.def.1, Alturas.def.1, Proporciones.def.1, Ternas.def.1: of each column, an
  // operation that does not name it, and tables whose row of another element has another value there.
  const Operation add_triangle = model::Agregar_Triangulo{fresh, corners};
  const Operation add_sphere = model::Agregar_Esfera{fresh, origin, 1};
  const auto holds = [&](const Operation& operation, auto&& change) {
    scene::Scene edited = some();
    const model::Respuesta r = edited.apply(operation);
    Tablas after = tablas(edited);
    change(after);
    return broken(tablas(some()), operation, r, after).empty();
  };
  CHECK(holds(add_triangle, [](Tablas&) {}));
  CHECK(holds(add_sphere, [](Tablas&) {}));
  CHECK_FALSE(holds(add_triangle, [](Tablas& s) { s.centros.at(sphere) = Punto(1, 0, 0); }));
  CHECK_FALSE(holds(add_triangle, [](Tablas& s) { s.radios.at(sphere) = Rmas(7); }));
  CHECK_FALSE(holds(add_sphere, [](Tablas& s) { s.vectores.at(cone) = model::Vector(1, 0, 0); }));
  CHECK_FALSE(holds(add_sphere, [](Tablas& s) { s.alturas.at(cone) = Rmas(7); }));
  CHECK_FALSE(holds(add_sphere, [](Tablas& s) { s.proporciones.at(cone) = Rmas(7); }));
  CHECK_FALSE(holds(add_sphere, [](Tablas& s) {
    s.ternas.at(triangle) = model::Vertices(model::Terna{corners.b, corners.a, corners.c});
  }));
}

TEST_CASE("each clause of an operation on the tables sees what breaks it") {
  const scene::Scene scene = some();
  const Operation add = model::Agregar_Esfera{fresh, origin, 1}, remove = model::Eliminar_Esfera{a};
  const auto after = [&](const Operation& operation, auto&& change) {
    scene::Scene edited = scene;
    const model::Respuesta r = edited.apply(operation);
    Tablas before = tablas(scene), tables = tablas(edited);
    change(before, tables);
    return broken(before, operation, r, tables);
  };
  const auto moved = [](Tablas& s) { s.nombres = {}, s.lugar.at(k) = ElementRef{Tipo::soy_tronco, 5}; };
  CHECK(after(add, [](Tablas&, Tablas&) {}).empty());
  CHECK(after(add, [](Tablas& s, Tablas&) { s.lugar.emplace(fresh, next_sphere); }).contains("Agregar_Fila.pre.1"));
  CHECK(after(add, [&](Tablas&, Tablas& s) { moved(s); }).contains("Agregar_Fila.post.1"));
  CHECK(after(add, [](Tablas&, Tablas& s) { ++s.cuantos[Tipo::soy_plano]; }).contains("Agregar_Fila.post.2"));

  CHECK(after(remove, [](Tablas&, Tablas&) {}).empty());
  CHECK(after(remove, [](Tablas& s, Tablas&) { s.lugar.erase(a); }).contains("Quitar_Fila.pre.1"));
  // The last row goes into the gap (mudanza.def.1), in the index and in every column.
  CHECK(after(remove, [&](Tablas&, Tablas& s) { moved(s); }).contains("Quitar_Fila.post.1"));
  CHECK(after(remove, [](Tablas&, Tablas& s) { ++s.cuantos[Tipo::soy_plano]; }).contains("Quitar_Fila.post.2"));
  CHECK(after(remove, [](Tablas&, Tablas& s) { s.centros.at(sphere) = origin; }) == Labels{"Quitar_Fila.post.3"});
  CHECK(after(remove, [](Tablas&, Tablas& s) { s.radios.at(sphere) = Rmas(1); }) == Labels{"Quitar_Fila.post.4"});
  CHECK(after(remove, [](Tablas&, Tablas& s) { s.vectores.at(cone) = model::Vector(1, 0, 0); }) ==
        Labels{"Quitar_Fila.post.5"});
  CHECK(after(remove, [](Tablas&, Tablas& s) { s.alturas.at(cone) = Rmas(1); }) == Labels{"Quitar_Fila.post.6"});
  CHECK(after(remove, [](Tablas&, Tablas& s) { s.proporciones.at(cone) = Rmas(1); }) == Labels{"Quitar_Fila.post.7"});
  CHECK(after(remove, [](Tablas&, Tablas& s) {
          s.ternas.at(triangle) = model::Vertices(model::Terna{corners.b, corners.a, corners.c});
        }) == Labels{"Quitar_Fila.post.8"});
}

TEST_CASE(
    "the closed form of the text: its coefficients are those of the power, and its roots are where that is zero") {
  const Judge judge;
  const auto of = [&](const char* function, std::vector<zed::Value> arguments) {
    return judge.evaluator().apply(judge.evaluator().value(zed::Name{function, ""}),
                                   zed::Value::tuple(std::move(arguments)));
  };
  const auto real = [](double x) { return zed::Value(zed::Real(x)); };
  const auto contains = [&](const zed::Value& set, double x) { return judge.evaluator().contains(set, real(x)); };
  const auto same = [&](const zed::Value& x, const zed::Value& y) {
    return judge.evaluator().contains(zed::Value::set({x}), y) == Truth::yes;
  };
  const auto part = [](const zed::Value& binding, std::size_t at) { return binding.binding()->values[at]; };
  const zed::Value ray = value(model::Rayo(Punto(0, 0.5, -3), model::Vector(0.25, 0, 2)));
  const zed::Value centre = value(Punto(0.5, 0.25, 1)), tilted = value(model::Vector(0.6, 0, 0.8));

  // producto.def.1, desde.def.1 and punto_en.def.1, by numbers that one can add up.
  CHECK(same(of("producto", {value(model::Vector(1, 2, 3)), value(model::Vector(4, 5, 6))}), real(32)));
  CHECK(same(of("desde", {value(Punto(1, 2, 3)), value(Punto(4, 6, 8))}), value(Punto(3, 4, 5))));
  CHECK(same(of("punto_en", {ray, real(2)}), value(Punto(0.5, 0.5, 1))));

  // cuadratica_esfera.def.1 and cuadratica_tronco.def.1: a·t² + 2b·t + c is the power of the point at t.
  const zed::Value sphere_form = of("cuadratica_esfera", {ray, centre, real(2)});
  const zed::Value cone_form = of("cuadratica_tronco", {ray, centre, real(1), real(0.5), tilted, real(4)});
  const auto at = [&](const zed::Value& form, double x) {
    const auto number = [&](std::size_t i) { return *part(form, i).get<zed::Real>(); };
    return zed::Value(number(0) * zed::Real(x * x) + number(1) * zed::Real(2 * x) + number(2));
  };
  for (const double x : {-1.0, 0.0, 0.5, 2.0, 3.0}) {
    const zed::Value point = of("punto_en", {ray, real(x)});
    CHECK(same(at(sphere_form, x), of("potencia_esfera", {point, centre, real(2)})));
    CHECK(same(at(cone_form, x), of("potencia_tronco", {point, centre, real(1), real(0.5), tilted, real(4)})));
    // recorte.def.1: what the advance of the point says.
    const auto inside = [&](double h) { return contains(of("recorte", {ray, centre, tilted, real(h)}), x); };
    const zed::Real advance = *of("avance", {point, centre, tilted}).get<zed::Real>();
    for (const double h : {1.0, 3.0})
      CHECK((inside(h) == Truth::yes) == (advance >= zed::Real(0) && advance <= zed::Real(h)));
  }

  // raices.def.1: two roots, one, none, the whole line.
  const auto roots = [&](double qa, double qb, double qc) {
    const zed::Value form =
        binding({{zed::Name{"a", ""}, real(qa)}, {zed::Name{"b", ""}, real(qb)}, {zed::Name{"c", ""}, real(qc)}});
    return judge.evaluator().apply(judge.evaluator().value(zed::Name{"raices", ""}), form);
  };
  const auto among = [&](const zed::Value& set) {
    std::set<double> found;
    for (const double x : {-2.0, -1.0, 0.0, 1.0, 2.0, 3.0})
      if (contains(set, x) == Truth::yes) found.insert(x);
    return found;
  };
  CHECK(among(roots(1, -2, 3)) == std::set{1.0, 3.0});
  CHECK(among(roots(-1, 2, -3)) == std::set{1.0, 3.0});
  CHECK(among(roots(1, -2, 4)) == std::set{2.0});
  CHECK(among(roots(1, 0, 1)).empty());
  CHECK(among(roots(0, 1, -2)) == std::set{1.0});
  CHECK(among(roots(0, 0, 1)).empty());
  CHECK(among(roots(0, 0, 0)).size() == 6);
}

}  // namespace durero::spec
