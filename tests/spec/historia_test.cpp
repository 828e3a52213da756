// The changes of spec/historia.tex: what the model does, the text evaluated says of it, and of nothing else.

#include "durero/model/historia.hpp"

#include <algorithm>
#include <iterator>
#include <map>

#include "durero/model/vista.hpp"
#include "durero/spec/spec.hpp"
#include "support/catch.hpp"
#include "support/model_gen.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::spec;
using model::AttributeChange;
using model::Elemento;
using model::Escena;
using model::LookChange;
using model::Respuesta;
using model::Vista;
using zed::Truth;

namespace {

Escena any_scene() {
  Escena escena = model::Init();
  for (const model::Operation& operation : *test::any_operations()) model::apply_total(escena, operation);
  return escena;
}

AttributeChange any_change() {
  const Elemento e = *test::any_element();
  const auto of_type = *rc::gen::element<std::optional<model::Tipo>>(std::nullopt, model::Tipo::soy_tronco);
  const double number = *rc::gen::element(-1.0, 0.0, 0.5, 3.0);
  return *rc::gen::element<AttributeChange>(
      model::Cambiar_Centro{e, *test::any_point(), of_type}, model::Cambiar_Radio{e, number, of_type},
      model::Cambiar_Vector{e, *test::any_vector(), of_type}, model::Cambiar_Vector{e, *test::any_axis(), of_type},
      model::Cambiar_Altura{e, number, of_type}, model::Cambiar_Proporcion{e, number, of_type},
      model::Cambiar_Vertices{e, *test::any_terna()});
}

Vista any_looks() {
  Vista s{any_scene(), {"pair", "rest"}, {"blue", "red"}, {}, {}};
  for (const Elemento& e : s.escena.elementos) {
    if (*rc::gen::arbitrary<bool>()) s.mi_grupo.emplace(e, *rc::gen::element<model::Nombre>("pair", "rest"));
    if (*rc::gen::arbitrary<bool>()) s.mi_material.emplace(e, *rc::gen::element<model::Nombre>("blue", "red"));
  }
  return s;
}

LookChange any_look_change() {
  const Elemento e = *test::any_element();
  return *rc::gen::element<LookChange>(model::Cambiar_Material{e, "blue"}, model::Cambiar_Material{e, "green"},
                                       model::Quitar_Material{e}, model::Cambiar_Grupo{e, "rest"},
                                       model::Cambiar_Grupo{e, "none"}, model::Quitar_Grupo{e});
}

bool holds(const Judge& judge, const std::string& schema, const Named& values) {
  static std::map<std::string, zed::SchemaCheck> checks;
  auto at = checks.find(schema);
  if (at == checks.end()) at = checks.emplace(schema, judge.evaluator().schema({schema, ""})).first;
  return at->second.holds(in_order(at->second.components(), values)) == Truth::yes;
}

Named step(const Vista& before, Named inputs, Respuesta r, const Vista& after) {
  Named all = components(before), primed = components(after);
  for (auto& [name, value] : primed) name.strokes += "'";
  std::ranges::move(primed, std::back_inserter(all));
  std::ranges::move(inputs, std::back_inserter(all));
  all.emplace_back(zed::Name{"r", "!"}, value(r));
  return all;
}

}  // namespace

TEST_CASE("the contracts of changes and the text agree, and the text refuses what was not done") {
  const Judge judge;
  test::property("over random scenes", [&] {
    const Escena before = any_scene();
    Escena after = before;
    const AttributeChange change = any_change();
    const model::Answer answer = model::apply_total(after, change);
    RC_CLASSIFY(answer.ok(), "done");
    RC_ASSERT(judge.change_difference(before, change, answer, after) == std::nullopt);
    // Faults: another answer, another after-state, a clause that holds.
    const model::Answer other{answer.ok() ? Respuesta::hecho : Respuesta::elemento_cambiado, answer.violated};
    RC_ASSERT(judge.change_difference(before, change, other, after).has_value());
    Escena spoiled = after;
    spoiled.elementos.insert(Elemento("spoiled"));
    RC_ASSERT(judge.change_difference(before, change, answer, spoiled).has_value());
    if (answer.ok()) {
      const model::Answer refusal{Respuesta::elemento_no_existe, &model::Cambiar_Elemento_pre_1};
      RC_ASSERT(judge.change_difference(before, change, refusal, before).has_value());
      // What undoes it leads back by the text, too.
      const auto back = std::get<AttributeChange>(model::inverse(before, change));
      RC_ASSERT(judge.change_difference(after, back, answer, before) == std::nullopt);
    } else {
      for (const auto& finding : judge.change_findings(before, change))
        if (finding.label == answer.violated->label) RC_ASSERT(finding.truth == Truth::no);
    }
  });
}

TEST_CASE("the contracts of looks and the text agree") {
  const Judge judge;
  test::property("over random scenes with looks", [&] {
    const Vista before = any_looks();
    Vista after = before;
    RC_ASSERT(holds(judge, "Vista", components(before)));
    const LookChange change = any_look_change();
    const model::Answer answer = model::apply_total(after, change);
    RC_CLASSIFY(answer.ok(), "done");
    const auto [partial, total] =
        std::visit([](const auto& in) { return std::pair(std::string(in.schema), std::string(in.total)); }, change);
    RC_ASSERT(holds(judge, total, step(before, change_inputs(change), answer.r, after)));
    RC_ASSERT(holds(judge, partial, step(before, change_inputs(change), answer.r, after)) == answer.ok());
    RC_ASSERT(!holds(judge, total, step(before, change_inputs(change), Respuesta::hecho, after)));
    Vista spoiled = after;
    spoiled.grupos.insert("spoiled");
    RC_ASSERT(!holds(judge, total, step(before, change_inputs(change), answer.r, spoiled)));
    RC_ASSERT(judge.change_difference(before, change, answer, after) == std::nullopt);
    RC_ASSERT(judge.change_difference(before, change, answer, spoiled).has_value());
    if (answer.ok()) {
      const model::Answer refusal{Respuesta::elemento_no_existe, pre(before, change).front().what};
      RC_ASSERT(judge.change_difference(before, change, refusal, before).has_value());
    }
  });

  test::property("an operation on elements leaves the looks of those that stay", [&] {
    const Vista before = any_looks();
    Vista after = before;
    const AttributeChange change = any_change();
    const model::Answer answer = model::apply_total(after, change);
    Named all = step(before, change_inputs(change), answer.r, after);
    RC_ASSERT(holds(judge, "Mismo_Aspecto", all));
    Vista spoiled = after;
    spoiled.mi_grupo.clear();
    RC_ASSERT(holds(judge, "Mismo_Aspecto", step(before, {}, answer.r, spoiled)) == before.mi_grupo.empty());
  });
}

TEST_CASE("the text knows a face of a mesh, and what is none") {
  model::Mallas s = model::Init_Mallas();
  const std::vector<model::Punto> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  model::apply(s, model::Agregar_Malla{Elemento("tent"), model::Red::of(points, {{0, 1, 2}})});
  model::apply_total(s, model::Operation(model::Agregar_Esfera{Elemento("tent:1"), points[0], 1}));
  CHECK(in_de_malla(Elemento("tent:0"), s));
  CHECK(!in_de_malla(Elemento("tent:1"), s));
  CHECK(!in_de_malla(Elemento("tent"), s));
}
