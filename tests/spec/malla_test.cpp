// spec/malla.tex, evaluated on the states of the model: after random operations on meshes and on single elements the
// states satisfy the invariant, and changed as the operation says. And each of its labels sees what breaks it.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "durero/model/malla_clauses.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/spec/spec.hpp"
#include "support/catch.hpp"
#include "support/clauses.hpp"
#include "support/mallas_gen.hpp"
#include "support/property.hpp"

namespace durero::spec {
namespace {

using model::Elemento;
using model::Mallas;
using model::MeshOperation;
using model::Operation;
using model::Respuesta;
using zed::Truth;

const Elemento m("m"), w("w"), long_name(std::string(127, 'l'));
constexpr model::Ordinal most_faces = 4;

/// The text, with the names of all faces that the generators make.
const zed::Evaluator& evaluator() {
  static const zed::Evaluator made(text().sections, {{{"nombre_cara", ""}, names_of_faces({m, w}, most_faces)}});
  return made;
}

Named with_stroke(Named parts) {
  for (auto& [name, value] : parts) name.strokes += "'";
  return parts;
}

Named together(Named all, Named more) {
  std::ranges::move(more, std::back_inserter(all));
  return all;
}

/// The labels of the conjuncts that do not hold, and, where there are none, that the whole schema holds.
std::set<std::string> broken(const std::string& schema, const Named& values) {
  static std::map<std::string, zed::SchemaCheck> checks;
  const auto [at, fresh] = checks.try_emplace(schema, evaluator().schema({schema, ""}));
  const auto ordered = in_order(at->second.components(), values);
  std::set<std::string> labels;
  for (const zed::ConjunctTruth& finding : at->second.findings(ordered))
    if (finding.truth != Truth::yes) labels.insert(finding.label + finding.strokes);
  CHECK(at->second.holds(ordered) == (labels.empty() ? Truth::yes : Truth::no));
  return labels;
}

std::set<std::string> broken(const Mallas& s) { return broken("Mallas", components(s)); }

template <class Any>
Named step(const Mallas& before, const Any& operation, Respuesta r, const Mallas& after) {
  Named all = together(components(before), with_stroke(components(after)));
  all = together(std::move(all), inputs(operation));
  all.emplace_back(zed::Name{"r", "!"}, value(r));
  return all;
}

std::string schema_of(const MeshOperation& operation) {
  return std::visit([](const auto& in) { return std::string(in.schema); }, operation);
}
std::string total_of(const MeshOperation& operation) {
  return std::visit([](const auto& in) { return std::string(in.total); }, operation);
}
/// Agregar_Esfera_Mallas of Agregar_Esfera_Total.
std::string beside_of(const Operation& operation) {
  const std::string total = total_name(operation);
  return total.substr(0, total.rfind('_')) + "_Mallas";
}

bool is_real(double x) { return std::isfinite(x); }
bool is_real(const std::optional<double>& x) { return !x || is_real(*x); }
bool is_real(const auto&) { return true; }

/// Whether every input is one of the text, which has no infinity and no NaN. The model refuses these by name.
bool has_real_inputs(const Operation& operation) {
  bool all = true;
  const auto look = [&](const auto& in) {
    model::for_each_attribute([&](const auto& attribute) {
      if constexpr (requires { attribute.input(in); }) all = all && is_real(attribute.input(in));
    });
  };
  std::visit(look, operation);
  return all;
}

bool holds(const std::string& schema, const Named& values) {
  static std::map<std::string, zed::SchemaCheck> checks;
  const auto [at, fresh] = checks.try_emplace(schema, evaluator().schema({schema, ""}));
  return at->second.holds(in_order(at->second.components(), values)) == Truth::yes;
}

/// The labels that hold of no precondition: what the model says of them.
std::set<std::string> broken_preconditions(const Mallas& before, const MeshOperation& operation) {
  std::set<std::string> labels;
  for (const model::MeshPrecondition& each : preconditions(before, operation))
    if (!each.judged.holds) labels.emplace(each.judged.what->label);
  return labels;
}

}  // namespace

TEST_CASE("after any operations the states with meshes are those of the text, and changed as it says") {
  test::property("operations on meshes", [] {
    Mallas s = test::any_scene_with_meshes();
    RC_ASSERT(broken(s).empty());
    const Mallas before = s;
    const MeshOperation operation = *test::any_mesh_operation();
    const model::Answer answer = model::apply_total(s, operation);
    RC_CLASSIFY(answer.ok(), "done");
    RC_ASSERT(holds(total_of(operation), step(before, operation, answer.r, s)));
    RC_ASSERT(holds(schema_of(operation), step(before, operation, answer.r, s)) == answer.ok());
    if (answer.ok()) RC_ASSERT(!holds(total_of(operation), step(before, operation, answer.r, before)) || s == before);
    RC_ASSERT(!holds(total_of(operation), step(before, operation, Respuesta::elemento_agregado, s)));
    if (!answer.ok()) {
      const auto labels = broken(schema_of(operation), step(before, operation, answer.r, s));
      for (const std::string& label : broken_preconditions(before, operation)) RC_ASSERT(labels.contains(label));
    }
  });
  test::property("operations on single elements", [] {
    Mallas s = test::any_scene_with_meshes();
    const Mallas before = s;
    const Operation operation = *test::any_single_operation();
    RC_PRE(has_real_inputs(operation));
    const model::Answer answer = model::apply_total(s, operation);
    RC_CLASSIFY(answer.r == Respuesta::es_de_malla, "of a mesh");
    RC_ASSERT(holds(beside_of(operation), step(before, operation, answer.r, s)));
    const Respuesta other = answer.r == Respuesta::es_de_malla ? Respuesta::elemento_eliminado : Respuesta::es_de_malla;
    RC_ASSERT(!holds(beside_of(operation), step(before, operation, other, s)));
  });
}

TEST_CASE("each invariant of a scene with meshes sees what breaks it, evaluated") {
  const std::vector<model::Punto> square{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
  const model::Red red = model::Red::of(square, {{0, 1, 2}, {0, 2, 3}});
  const auto after = [&](auto&& change) {
    Mallas s = model::Init_Mallas();
    model::apply(s, model::Agregar_Malla{m, red});
    change(s);
    return broken(s);
  };
  CHECK(after([](Mallas&) {}).empty());
  CHECK(after([&](Mallas& s) { s.mallas.emplace(long_name, model::Malla(red)); }).contains("Mallas.inv.1"));
  CHECK(after([&](Mallas& s) { s.mallas.emplace(w, model::Malla(red)); }).contains("Mallas.inv.2"));
  CHECK(after([](Mallas& s) {
          s.escena.mi_vertices.at(Elemento("m:1")) = s.escena.mi_vertices.at(Elemento("m:0"));
        }).contains("Mallas.inv.2"));
  CHECK(broken("Init_Mallas", with_stroke(components(model::Init_Mallas()))).empty());
  Mallas loose = model::Init_Mallas();
  model::apply(loose, model::Agregar_Malla{w, model::Red::of(square, {})});
  CHECK(broken("Init_Mallas", with_stroke(components(loose))) == std::set<std::string>{"Init_Mallas.post.1"});
}

TEST_CASE("points and faces are what the text says, evaluated") {
  const auto is_in = [](const char* set, const model::Red& red) {
    return evaluator().contains(evaluator().value(zed::Name{set, ""}), value(red)) == Truth::yes;
  };
  test::property("of any points and faces", [&] {
    const model::Red red = *test::any_red();
    RC_ASSERT(is_in("Red", red));
    RC_ASSERT(is_in("Completa", red) == model::is_complete(red));
    RC_ASSERT(is_in("Malla", red) == model::Malla::contains(red));
  });
}

TEST_CASE("giro, cruce and recta are those of the text, evaluated") {
  const auto of = [](const char* function, std::vector<zed::Value> arguments) {
    return evaluator().apply(evaluator().value(zed::Name{function, ""}), zed::Value::tuple(std::move(arguments)));
  };
  const auto same = [](const zed::Value& x, const number::Surd& y) {
    return evaluator().contains(zed::Value::set({x}), zed::Value(zed::Real(y))) == Truth::yes;
  };
  const model::Rayo rayo({0.5, -1, 2}, {1, 3, -0.25});
  const model::Terna v{{-1, 0, 0.5}, {3, 1, 1}, {2, -2, 4}};
  CHECK(same(of("giro", {value(rayo), value(v.a), value(v.b)}), model::giro(rayo, v.a, v.b)));
  CHECK(same(of("giro", {value(rayo), value(v.c), value(v.a)}), model::giro(rayo, v.c, v.a)));
  CHECK(same(of("cruce", {value(rayo), value(v)}), model::cruce(rayo, v)));
  const zed::Value line = evaluator().apply(evaluator().value(zed::Name{"recta", ""}), value(rayo));
  for (const model::Punto& p : {model::Punto(0.5, -1, 2), model::Punto(-0.5, -4, 2.25), model::Punto(1.5, 2, 2)})
    CHECK((evaluator().contains(line, value(p)) == Truth::yes) == model::recta(rayo).contains(p));
}

}  // namespace durero::spec
