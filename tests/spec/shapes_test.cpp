// spec/promocion.tex, evaluated: the shapes of the program's own scenes are those of the text, both ways, and a lifted
// operation holds of what the program does and of nothing else.
#include <map>
#include <set>
#include <stdexcept>

#include "durero/model/operaciones.hpp"
#include "durero/scene/attributes.hpp"
#include "durero/scene/promocion.hpp"
#include "durero/scene/retrieve.hpp"
#include "durero/spec/spec.hpp"
#include "support/catch.hpp"
#include "support/model_gen.hpp"
#include "support/property.hpp"

namespace durero::spec {
namespace {

using model::Elemento;
using model::Operation;
using model::Punto;
using model::Tipo;
using scene::AnyShape;
using scene::Formas;
using zed::Truth;

const Judge& judge() {
  static const Judge only;
  return only;
}

zed::Value attribute(double x) { return zed::Value(zed::Real(x)); }
zed::Value attribute(const Punto& p) { return value(p); }
zed::Value attribute(const model::Vector& v) { return value(v); }
zed::Value attribute(const model::Terna& v) { return value(v); }

zed::Value applied(const char* function, const zed::Value& argument) {
  return judge().evaluator().apply(judge().evaluator().value(zed::Name{function, ""}), argument);
}

/// A shape in the text: its constructor, with the attributes that its type has.
zed::Value value_of(const AnyShape& any) {
  return std::visit(
      []<class Shape>(const Shape& shape) {
        Named parts;
        scene::for_each_attribute<Shape, model::Escena>([&]<class TableRow>(const TableRow& row) {
          const auto input = scene::input_of<typename TableRow::Input>(shape.*row.field);
          parts.emplace_back(zed::Name{std::string(row.word), ""}, attribute(input));
        });
        return applied(std::string(Shape::word).c_str(), binding(std::move(parts)));
      },
      any);
}

Named forma_of(const Formas& formas) {
  std::vector<zed::Value> members;
  for (const auto& [e, shape] : formas.forma) members.push_back(zed::Value::pair(value(e), value_of(shape)));
  return {{zed::Name{"forma", ""}, zed::Value::set(std::move(members))}};
}

Named with(Named all, Named more, const std::string& stroke = "") {
  for (auto& [name, of] : more) all.emplace_back(zed::Name{name.word, name.strokes + stroke}, std::move(of));
  return all;
}

/// The labels of the conjuncts that do not hold, and, where there are none, that the whole schema holds.
std::set<std::string> broken_of_shapes(const std::string& schema, const Named& values) {
  static std::map<std::string, zed::SchemaCheck> checks;
  const auto [at, fresh] = checks.try_emplace(schema, judge().evaluator().schema({schema, ""}));
  const auto ordered = in_order(at->second.components(), values);
  std::set<std::string> labels;
  for (const zed::ConjunctTruth& finding : at->second.findings(ordered))
    if (finding.truth != Truth::yes) labels.insert(finding.label + finding.strokes);
  CHECK(at->second.holds(ordered) == (labels.empty() ? Truth::yes : Truth::no));
  return labels;
}

bool is_portrait(const model::Escena& escena, const Formas& formas) {
  return broken_of_shapes("Retrato", with(components(escena), forma_of(formas))).empty();
}
std::set<std::string> broken_recovery(const model::Escena& escena, const Formas& formas) {
  return broken_of_shapes("Recobro", with(components(escena), forma_of(formas)));
}
/// Whether the lifted operation of that name makes the one of the other, and answers so.
bool is_lifted(const Formas& before, const Operation& operation, model::Respuesta r, const Formas& after) {
  Named all = with(forma_of(before), forma_of(after), "'");
  all = with(std::move(all), inputs(operation));
  all.emplace_back(zed::Name{"r", "!"}, value(r));
  return broken_of_shapes(schema_name(operation) + "_Formas", all).empty();
}

const Punto origin(0, 0, 0), elsewhere(1, 2, 3);
const model::Vector axis(0, 0, 1);
const model::Terna corners{Punto(1, 0, 0), Punto(0, 1, 0), Punto(0, 0, 1)};
const Elemento a("a"), fresh("fresh");

struct Kind {
  const char* word;
  Operation addition, removal;
};
/// Each shape, added and removed.
std::vector<Kind> kinds() {
  return {{"Esfera", model::Agregar_Esfera{fresh, origin, 1}, model::Eliminar_Esfera{fresh}},
          {"Cilindro", model::Agregar_Cilindro{fresh, origin, 1, axis, 2}, model::Eliminar_Cilindro{fresh}},
          {"Cono", model::Agregar_Cono{fresh, origin, 0.5, axis, 2}, model::Eliminar_Cono{fresh}},
          {"Tronco", model::Agregar_Tronco{fresh, origin, 1, 0.5, axis, 2}, model::Eliminar_Tronco{fresh}},
          {"Plano", model::Agregar_Plano{fresh, origin, axis}, model::Eliminar_Plano{fresh}},
          {"Disco", model::Agregar_Disco{fresh, origin, 1, axis}, model::Eliminar_Disco{fresh}},
          {"Triangulo", model::Agregar_Triangulo{fresh, corners}, model::Eliminar_Triangulo{fresh}}};
}
Formas one_sphere() {
  Formas formas;
  apply_lifted(formas, model::Agregar_Esfera{a, elsewhere, 2});
  return formas;
}
Formas after(const Operation& operation, Formas formas = one_sphere()) {
  apply_lifted(formas, operation);
  return formas;
}

}  // namespace

TEST_CASE("after any edits the shapes are those of the text, both ways, and each edit is lifted") {
  test::property("any edits", [] {
    scene::Scene scene;
    for (const Operation& operation : *test::any_operations()) {
      const Formas before = formas(scene);
      const model::Answer answer = scene.apply_total(operation);
      const Formas now = formas(scene);
      RC_ASSERT(is_portrait(retrieve(scene), now));
      RC_ASSERT(broken_recovery(retrieve(scene), now).empty());
      const bool general = std::holds_alternative<model::Agregar_Elemento>(operation) ||
                           std::holds_alternative<model::Eliminar_Elemento>(operation);
      if (answer.ok() && !general) RC_ASSERT(is_lifted(before, operation, answer.r, now));
    }
  });
}

TEST_CASE("each schema of a shape has the attributes of its type, and in their ranges") {
  // Esfera.def.1, Cilindro.def.1, Cono.def.1, Tronco.def.1, Plano.def.1, Disco.def.1, Triangulo.def.1
  for (const auto& [word, addition, removal] : kinds()) {
    INFO(word);
    const Formas shapes = after(addition, {});
    const zed::Value made = value_of(shapes.forma.at(fresh));
    CHECK(judge().evaluator().contains(judge().evaluator().value(zed::Name{"Forma", ""}), made) == Truth::yes);
    CHECK(broken_of_shapes("Una_Forma", {{zed::Name{"f", ""}, made}}).empty());  // Una_Forma.def.1
  }
  CHECK(applied("esfera", binding({{zed::Name{"centro", ""}, value(origin)}, {zed::Name{"radio", ""}, attribute(0.0)}}))
            .is_undefined());
  CHECK(applied("plano", binding({{zed::Name{"centro", ""}, value(origin)},
                                  {zed::Name{"vector", ""}, value(model::Vector(0, 0, 2))}}))
            .is_undefined());
}

TEST_CASE("a shape has a type, and an attribute where its type has it") {
  // tipo_de.def.1; centro_de.def.1, centro_de.def.2; radio_de.def.1, radio_de.def.2; vector_de.def.1, vector_de.def.2;
  // altura_de.def.1, altura_de.def.2; proporcion_de.def.1, proporcion_de.def.2; vertices_de.def.1, vertices_de.def.2
  const auto same = [](const zed::Value& x, const zed::Value& y) {
    return judge().evaluator().contains(zed::Value::set({x}), y) == Truth::yes;
  };
  for (const auto& [word, addition, removal] : kinds()) {
    INFO(word);
    const Formas shapes = after(addition, {});
    const zed::Value made = value_of(shapes.forma.at(fresh));
    const model::Escena escena = retrieve(shapes);
    CHECK(same(applied("tipo_de", made), value(escena.de_que_tipo.at(fresh))));
    const auto is = [&](const char* function, bool has, const zed::Value& of) {
      INFO(function);
      const zed::Value found = applied(function, made);
      CHECK(found.is_undefined() == !has);
      if (has) CHECK(same(found, of));
    };
    is("centro_de", escena.mi_centro.contains(fresh), value(origin));
    is("radio_de", escena.mi_radio.contains(fresh), attribute(1.0));
    is("vector_de", escena.mi_vector.contains(fresh), value(axis));
    is("altura_de", escena.mi_altura.contains(fresh), attribute(2.0));
    is("proporcion_de", escena.mi_proporcion.contains(fresh), attribute(0.5));
    is("vertices_de", escena.mi_vertices.contains(fresh), value(corners));
  }
}

TEST_CASE("the two ways see a scene that is another") {
  const Formas shapes = after(model::Agregar_Tronco{fresh, origin, 1, 0.5, axis, 2},
                              after(model::Agregar_Triangulo{Elemento("t"), corners}));
  const model::Escena escena = retrieve(shapes);
  // Formas.def.1, Retrato.inv.1
  CHECK(is_portrait(escena, shapes));
  CHECK_FALSE(is_portrait(escena, one_sphere()));
  const auto changed = [&](auto&& change) {
    model::Escena other = escena;
    change(other);
    CHECK_FALSE(is_portrait(other, shapes));
    return broken_recovery(other, shapes);
  };
  using Labels = std::set<std::string>;
  CHECK(broken_recovery(escena, shapes).empty());
  CHECK(changed([](model::Escena& s) { s.de_que_tipo.at(a) = Tipo::soy_plano; }).contains("Recobro.inv.1"));
  CHECK(changed([](model::Escena& s) { s.mi_centro.at(a) = origin; }) == Labels{"Recobro.inv.2"});
  CHECK(changed([](model::Escena& s) { s.mi_radio.at(a) = model::Rmas(1); }) == Labels{"Recobro.inv.3"});
  CHECK(changed([](model::Escena& s) { s.mi_vector.at(fresh) = model::Vector(1, 0, 0); }) == Labels{"Recobro.inv.4"});
  CHECK(changed([](model::Escena& s) { s.mi_altura.at(fresh) = model::Rmas(1); }) == Labels{"Recobro.inv.5"});
  CHECK(changed([](model::Escena& s) { s.mi_proporcion.at(fresh) = model::Rmas(1); }) == Labels{"Recobro.inv.6"});
  CHECK(changed([](model::Escena& s) {
          s.mi_vertices.at(Elemento("t")) = model::Vertices(model::Terna{corners.b, corners.a, corners.c});
        }) == Labels{"Recobro.inv.7"});
}

TEST_CASE("the first shapes are none") {
  const auto first = [](const Formas& shapes) {
    return broken_of_shapes("Init_Formas", with({}, forma_of(shapes), "'")).empty();
  };
  CHECK(first(Formas()));  // Init_Formas.def.1
  CHECK_FALSE(first(one_sphere()));
}

TEST_CASE("each lifted operation holds of what the program does, and of nothing else") {
  // Of an addition: Nueva_Esfera.def.1, Nuevo_Cilindro.def.1, Nuevo_Cono.def.1, Nuevo_Tronco.def.1, Nuevo_Plano.def.1,
  // Nuevo_Disco.def.1, Nuevo_Triangulo.def.1, lifted by Marco_Agregar.def.1. Of a removal: Vieja_Esfera.def.1,
  // Viejo_Cilindro.def.1, Viejo_Cono.def.1, Viejo_Tronco.def.1, Viejo_Plano.def.1, Viejo_Disco.def.1,
  // Viejo_Triangulo.def.1, lifted by Marco_Eliminar.def.1.
  const std::set<std::string> labels{
      "Agregar_Esfera_Formas.def.1",    "Agregar_Cilindro_Formas.def.1",  "Agregar_Cono_Formas.def.1",
      "Agregar_Tronco_Formas.def.1",    "Agregar_Plano_Formas.def.1",     "Agregar_Disco_Formas.def.1",
      "Agregar_Triangulo_Formas.def.1", "Eliminar_Esfera_Formas.def.1",   "Eliminar_Cilindro_Formas.def.1",
      "Eliminar_Cono_Formas.def.1",     "Eliminar_Tronco_Formas.def.1",   "Eliminar_Plano_Formas.def.1",
      "Eliminar_Disco_Formas.def.1",    "Eliminar_Triangulo_Formas.def.1"};
  const Formas before = one_sphere();
  for (const auto& [word, addition, removal] : kinds()) {
    INFO(word);
    CHECK(labels.contains(schema_name(addition) + "_Formas.def.1"));
    CHECK(labels.contains(schema_name(removal) + "_Formas.def.1"));
    Formas now = before;
    const auto r = apply_lifted(now, addition);
    REQUIRE(r);
    CHECK(is_lifted(before, addition, *r, now));
    CHECK_FALSE(is_lifted(before, addition, *r, before));
    CHECK_FALSE(is_lifted(before, addition, model::Respuesta::elemento_agregado, now));
    // A name that is in use, and a frame that moves another element.
    CHECK_FALSE(is_lifted(now, addition, *r, now));
    Formas moved = now;
    moved.forma.at(a) = now.forma.at(fresh);
    CHECK_FALSE(is_lifted(before, addition, *r, moved));
    for (const Kind& other : kinds()) {
      INFO(other.word);
      const bool same = std::string(other.word) == word;
      Formas less = now;
      const auto answer = apply_lifted(less, other.removal);
      CHECK(answer.has_value() == same);
      // The removal of the own type answers this, of what it would leave: no other type's removal does it.
      Formas without = now;
      without.forma.erase(fresh);
      scene::Scene scene;
      scene.apply(other.addition);
      const model::Respuesta removed = scene.apply(other.removal);
      CHECK(is_lifted(now, other.removal, removed, without) == same);
      CHECK_FALSE(is_lifted(now, other.removal, removed, now));
      CHECK_FALSE(is_lifted(before, other.removal, removed, before));
    }
  }
}

}  // namespace durero::spec
