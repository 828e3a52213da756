#include "durero/spec/spec.hpp"

#include <algorithm>
#include <map>

#include "durero/model/interseccion.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/model/operaciones_clauses.hpp"
#include "durero/model/operaciones_errors.hpp"
#include "durero/scene/retrieve.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"
#include "support/scenes.hpp"

namespace durero::spec {
namespace {

using model::Escena;
using model::Operation;
using test::Random;
using zed::Truth;

model::Elemento element(Random& random, std::uint64_t of) {
  return model::Elemento("e" + std::to_string(random.below(of)));
}

double length(Random& random) {
  const double some[] = {0.0, -1.0, 0x1p-1074, 0.5, 3.0};
  return random.below(4) == 0 ? some[random.below(5)] : random.uniform(0.1, 2);
}

model::Vector direction(Random& random) {
  return random.below(6) == 0 ? model::Vector(random.in_cube(1)) : random.axis();
}

model::Tipo type(Random& random, model::Tipo usual) {
  return random.below(8) == 0 ? static_cast<model::Tipo>(random.below(model::tipo_count)) : usual;
}

/// One in six on one line.
model::Terna corners(Random& random, const model::Punto& a) {
  const glm::dvec3 along = random.in_cube(1), b = a.xyz() + along;
  if (random.below(6) == 0) return {a, model::Punto(b), model::Punto(b)};
  const glm::dvec3 c = random.in_cube(1);
  return {a, model::Punto(b), model::Punto(c)};
}

/// Any operation, about an element e0 … e11, with inputs that are often outside its precondition.
Operation any_operation(Random& random) {
  const model::Elemento e = element(random, 12);
  const model::Punto centro(random.in_cube(4));
  switch (random.below(16)) {
    case 0:
      return model::Agregar_Esfera{e, centro, length(random), type(random, model::Tipo::soy_esfera)};
    case 1:
      return model::Agregar_Cilindro{
          e, centro, length(random), direction(random), length(random), type(random, model::Tipo::soy_cilindro)};
    case 2:
      return model::Agregar_Cono{
          e, centro, length(random), direction(random), length(random), type(random, model::Tipo::soy_cono)};
    case 3: {
      const double radio = length(random), altura = length(random), proporcion = length(random);
      const model::Tipo tipo = static_cast<model::Tipo>(random.below(model::tipo_count));
      const model::Vector vector = direction(random);
      return model::Agregar_Elemento{e, tipo, centro, radio, vector, altura, proporcion, corners(random, centro)};
    }
    case 4:
      return model::Eliminar_Esfera{e};
    case 5:
      return model::Eliminar_Cilindro{e};
    case 6:
      return model::Eliminar_Cono{e};
    case 7:
      return model::Eliminar_Tronco{e};
    case 8: {
      const double radio = length(random), proporcion = length(random);
      return model::Agregar_Tronco{
          e, centro, radio, proporcion, direction(random), length(random), type(random, model::Tipo::soy_tronco)};
    }
    case 11:
      return model::Eliminar_Disco{e};
    case 12: {
      const double radio = length(random);
      return model::Agregar_Disco{e, centro, radio, direction(random), type(random, model::Tipo::soy_disco)};
    }
    case 13:
      return model::Eliminar_Triangulo{e};
    case 14:
      return model::Agregar_Triangulo{e, corners(random, centro), type(random, model::Tipo::soy_triangulo)};
    case 9:
      return model::Eliminar_Plano{e};
    case 10:
      return model::Agregar_Plano{e, centro, direction(random), type(random, model::Tipo::soy_plano)};
    default:
      return model::Eliminar_Elemento{e};
  }
}

Escena any_scene(Random& random) {
  Escena escena = model::Init();
  const auto size = random.below(11);
  for (std::uint64_t i = 0; i < size; ++i) {
    model::apply_total(escena, test::random_addition(random, "e" + std::to_string(random.below(12))));
  }
  return escena;
}

template <class Map>
void change(Random& random, Map& map, const typename Map::mapped_type& other) {
  const model::Elemento e = element(random, 12);
  if (random.below(2) == 0) {
    map.erase(e);
  } else {
    map.insert_or_assign(e, other);
  }
}

/// Changes one component at one element.
void spoil(Random& random, Escena& escena) {
  switch (random.below(9)) {
    case 0:
      if (const auto e = element(random, 12); !escena.elementos.erase(e)) escena.elementos.insert(e);
      break;
    case 1:
      if (const auto t = static_cast<model::Tipo>(random.below(model::tipo_count)); !escena.tipos.erase(t))
        escena.tipos.insert(t);
      break;
    case 2:
      change(random, escena.de_que_tipo, static_cast<model::Tipo>(random.below(model::tipo_count)));
      break;
    case 3:
      change(random, escena.mi_centro, model::Punto(random.in_cube(1)));
      break;
    case 4:
      change(random, escena.mi_radio, model::Rmas(random.uniform(0.1, 2)));
      break;
    case 5:
      change(random, escena.mi_vector, direction(random));
      break;
    case 6:
      change(random, escena.mi_altura, model::Rmas(random.uniform(0.1, 2)));
      break;
    case 7: {
      const model::Terna v = corners(random, model::Punto(random.in_cube(1)));
      if (model::Vertices::contains(v)) change(random, escena.mi_vertices, model::Vertices(v));
      break;
    }
    default:
      change(random, escena.mi_proporcion, model::Rmas(random.uniform(0.1, 2)));
  }
}

/// The truth of each labelled conjunct, by label and state.
std::map<std::string, bool> truths(const std::vector<zed::ConjunctTruth>& findings) {
  std::map<std::string, bool> found;
  for (const zed::ConjunctTruth& one : findings) {
    if (one.label.empty()) continue;
    if (one.truth == Truth::open) throw std::logic_error(one.label + " is left open");
    found[one.label + one.strokes] = one.truth == Truth::yes;
  }
  return found;
}

void add(std::map<std::string, bool>& to, const model::Judgements& judgements, const char* strokes = "") {
  for (const model::Judgement& one : judgements) to[std::string(one.what->label) + strokes] = one.holds;
}

/// The operation of its type that a general operation stands for, and that one's answer.
struct Specific {
  Operation operation;
  model::Respuesta r;
};

/// Nothing for the removal of what is not there, which has no type, and for an operation of one type.
std::optional<Specific> specific(const Escena& before, const Operation& operation) {
  const auto of = [](const auto& one) { return Specific{one, one.answer}; };
  if (const auto* in = std::get_if<model::Agregar_Elemento>(&operation)) return std::visit(of, model::specific(*in));
  const auto* in = std::get_if<model::Eliminar_Elemento>(&operation);
  if (in == nullptr || !before.elementos.contains(in->e)) return {};
  return std::visit(of, model::specific(before, *in));
}

/// What the contracts say of a transition.
std::map<std::string, bool> contracts(const OperationStep& step) {
  std::map<std::string, bool> said;
  add(said, model::inv(step.before));
  add(said, model::inv(step.after), "'");
  const model::Judgements pre = model::pre(step.before, step.operation);
  add(said, pre);
  // A removal of what is not there has no type, so no postcondition to speak of.
  if (std::holds_alternative<model::Eliminar_Elemento>(step.operation) && !pre.front().holds) return said;
  add(said, model::post(step.before, step.operation, step.after, step.r, contract::cost::audit));
  return said;
}

/// What the text says of a transition. Of a general operation: what its schema adds to those of the types, which it
/// joins by ∨, and the predicates of that of its own type, whose answer it hides.
std::map<std::string, bool> text_says(const Judge& judge, const OperationStep& step) {
  const auto one_type = specific(step.before, step.operation);
  if (!one_type) return truths(judge.findings(step));
  auto said = truths(judge.findings(OperationStep{step.before, one_type->operation, one_type->r, step.after}));
  for (const auto& [label, holds] : truths(judge.findings(step))) {
    if (label.starts_with("Elemento_")) said[label] = holds;  // Elemento_Agregado, Elemento_Eliminado
  }
  return said;
}

/// The labels that the contracts judge, and the text otherwise or not at all.
std::string different_labels(const std::map<std::string, bool>& said, const std::map<std::string, bool>& contracted) {
  std::string differ;
  for (const auto& [label, kept] : contracted) {
    const auto found = said.find(label);
    if (found == said.end() || found->second != kept) differ += " " + label;
  }
  return differ;
}

struct Counts {
  std::map<std::string, std::size_t> broken;
  std::size_t valid = 0, refused = 0;
};

/// One transition: what the operation makes of the scene, or the scene as it was where it is refused, one time in two
/// spoiled in one place; the answer now and then another one.
void judge_one(Random& random, const Judge& judge, Counts& counts) {
  const Escena before = any_scene(random);
  const Operation operation = any_operation(random);
  Escena after = before;
  model::Answer answer = model::apply_total(after, operation);
  counts.refused += answer.ok() ? 0 : 1;
  const bool honest = random.below(2) == 0;
  if (!honest && random.below(8) == 0)
    answer.r = static_cast<model::Respuesta>(random.below(model::respuesta_names.size()));
  if (!honest) spoil(random, after);
  const OperationStep step{before, operation, answer.r, after};
  if (honest) {
    CHECK(judge.holds_total(step));
    CHECK_FALSE(judge.difference(before, operation, answer, after));
  }
  const auto said = text_says(judge, step), contracted = contracts(step);
  const bool holds = std::all_of(contracted.begin(), contracted.end(), [](auto& one) { return one.second; });
  CHECK(judge.holds(step) == holds);
  counts.valid += holds ? 1 : 0;
  const std::string differ = different_labels(said, contracted);
  if (!differ.empty()) FAIL_CHECK(schema_name(operation) + ":" + differ);  // a message for each label would take longer
  for (const auto& [label, kept] : contracted) counts.broken[label] += kept ? 0 : 1;
}

void judge_many(std::uint64_t seed, std::size_t transitions) {
  CAPTURE(seed);
  Random random(seed);
  const Judge judge;
  Counts counts;
  for (std::size_t i = 0; i < transitions; ++i) judge_one(random, judge, counts);
  CHECK(counts.valid > transitions / 20);
  CHECK(counts.refused > transitions / 20);
  // Every predicate was seen broken.
  const Escena empty = model::Init();
  for (const char* schema : {"Agregar_Esfera", "Agregar_Cilindro", "Agregar_Cono", "Agregar_Tronco", "Eliminar_Esfera",
                             "Eliminar_Cilindro", "Eliminar_Cono", "Eliminar_Tronco", "Agregar_Plano", "Eliminar_Plano",
                             "Agregar_Disco", "Eliminar_Disco", "Agregar_Triangulo", "Eliminar_Triangulo", "Escena"}) {
    const zed::SchemaCheck check = judge.evaluator().schema({schema, ""});
    const std::vector<zed::Value> open(check.components().size(), zed::Open{});
    for (const zed::ConjunctTruth& one : check.findings(open)) {
      CAPTURE(one.label);
      // The before-state was always a scene.
      if (!one.label.empty() && !(one.label.starts_with("Escena.") && one.strokes.empty())) {
        CHECK(counts.broken[one.label + one.strokes] > 0);
      }
    }
  }
  for (const char* label : {"Elemento_Agregado.post.1", "Elemento_Eliminado.post.1"}) CHECK(counts.broken[label] > 0);
}

TEST_CASE("a difference between contracts and text is told with the predicate") {
  const Judge judge;
  const model::Elemento a("a"), b("b");
  Escena before = model::Init();
  model::apply(before, model::Agregar_Esfera{a, model::Punto(0, 0, 0), 1});
  const Operation addition = model::Agregar_Esfera{b, model::Punto(0, 0, 5), 1};
  Escena after = before;
  const model::Answer done = model::apply_total(after, addition);
  CHECK_FALSE(judge.difference(before, addition, done, after));
  // A program that forgets the radius.
  Escena forgetful = after;
  forgetful.mi_radio.erase(b);
  CHECK(judge.difference(before, addition, done, forgetful).value().find("Escena.inv.3") != std::string::npos);
  // That gives the wrong answer; that refuses a right operation; that refuses and changes the scene all the same.
  const model::Answer wrong{model::Respuesta::cono_agregado};
  CHECK(judge.difference(before, addition, wrong, after).value().find("Agregar_Esfera.post.7") != std::string::npos);
  const model::Answer refusal{model::Respuesta::elemento_ya_existe, &model::Agregar_Elemento_pre_1};
  CHECK(judge.difference(before, addition, refusal, before).value() ==
        "the contracts refuse what the text accepts: Agregar_Elemento.pre.1 (e? ∉ elementos)");
  const Operation again = model::Agregar_Esfera{a, model::Punto(0, 0, 5), 1};
  CHECK_FALSE(judge.difference(before, again, refusal, before));
  CHECK(judge.difference(before, again, refusal, after).value().find("Agregar_Esfera_Total") != std::string::npos);
}

TEST_CASE("each total operation of the text takes what the model answers, done or refused, and nothing else") {
  struct Row {
    const char* definition;
    Operation done, refused;
  };
  const model::Elemento s("s"), c("c"), k("k"), f("f"), p("p"), d("d"), t("t"), nuevo("nuevo");
  const model::Punto o(0, 0, 0);
  const model::Vector z(0, 0, 1), wrong(0, 0, 2);
  const model::Terna corners{o, {1, 0, 0}, {0, 1, 0}}, on_a_line{o, {1, 0, 0}, {2, 0, 0}};
  const Row rows[] = {
      {"Agregar_Esfera_Total.def.1", model::Agregar_Esfera{nuevo, o, 1}, model::Agregar_Esfera{nuevo, o, 0}},
      {"Agregar_Cilindro_Total.def.1", model::Agregar_Cilindro{nuevo, o, 1, z, 1},
       model::Agregar_Cilindro{nuevo, o, 1, wrong, 1}},
      {"Agregar_Cono_Total.def.1", model::Agregar_Cono{nuevo, o, 1, z, 1}, model::Agregar_Cono{nuevo, o, 1, z, -1}},
      {"Agregar_Tronco_Total.def.1", model::Agregar_Tronco{nuevo, o, 1, 1, z, 1},
       model::Agregar_Tronco{nuevo, o, 0, 1, z, 1}},
      {"Agregar_Elemento_Total.def.1", model::Agregar_Elemento{nuevo, model::Tipo::soy_cono, o, 0, z, 1, 1},
       model::Agregar_Elemento{s, model::Tipo::soy_esfera, o, 1, z, 1, 1}},
      {"Eliminar_Esfera_Total.def.1", model::Eliminar_Esfera{s}, model::Eliminar_Esfera{c}},
      {"Eliminar_Cilindro_Total.def.1", model::Eliminar_Cilindro{c}, model::Eliminar_Cilindro{nuevo}},
      {"Eliminar_Cono_Total.def.1", model::Eliminar_Cono{k}, model::Eliminar_Cono{s}},
      {"Eliminar_Tronco_Total.def.1", model::Eliminar_Tronco{f}, model::Eliminar_Tronco{k}},
      {"Agregar_Plano_Total.def.1", model::Agregar_Plano{nuevo, o, z}, model::Agregar_Plano{nuevo, o, wrong}},
      {"Eliminar_Plano_Total.def.1", model::Eliminar_Plano{p}, model::Eliminar_Plano{k}},
      {"Agregar_Disco_Total.def.1", model::Agregar_Disco{nuevo, o, 1, z}, model::Agregar_Disco{nuevo, o, 0, z}},
      {"Eliminar_Disco_Total.def.1", model::Eliminar_Disco{d}, model::Eliminar_Disco{p}},
      {"Agregar_Triangulo_Total.def.1", model::Agregar_Triangulo{nuevo, corners},
       model::Agregar_Triangulo{nuevo, on_a_line}},
      {"Eliminar_Triangulo_Total.def.1", model::Eliminar_Triangulo{t}, model::Eliminar_Triangulo{p}},
      {"Agregar_Elemento_Total.def.1",
       model::Agregar_Elemento{.e = nuevo, .t = model::Tipo::soy_triangulo, .vertices = corners},
       model::Agregar_Elemento{.e = nuevo, .t = model::Tipo::soy_triangulo, .vertices = on_a_line}},
      {"Eliminar_Elemento_Total.def.1", model::Eliminar_Elemento{c}, model::Eliminar_Elemento{nuevo}},
  };
  const Judge judge;
  Escena before = model::Init();
  model::apply(before, model::Agregar_Esfera{s, o, 1});
  model::apply(before, model::Agregar_Cilindro{c, o, 1, z, 1});
  model::apply(before, model::Agregar_Cono{k, o, 1, z, 1});
  model::apply(before, model::Agregar_Tronco{f, o, 1, 1, z, 1});
  model::apply(before, model::Agregar_Plano{p, o, z});
  model::apply(before, model::Agregar_Disco{d, o, 1, z});
  model::apply(before, model::Agregar_Triangulo{t, corners});
  for (const Row& row : rows) {
    CAPTURE(row.definition);
    Escena after = before, same = before;
    const model::Answer done = model::apply_total(after, row.done), refused = model::apply_total(same, row.refused);
    CHECK(done.ok());
    CHECK_FALSE(refused.ok());
    CHECK(same == before);
    CHECK_FALSE(judge.difference(before, row.done, done, after));
    CHECK_FALSE(judge.difference(before, row.refused, refused, before));
    CHECK(judge.difference(before, row.done, done, before));       // the answer without the edit
    CHECK(judge.difference(before, row.refused, refused, after));  // the error and an edit
    CHECK(judge.difference(before, row.refused, done, before));    // the error not told
  }
}

TEST_CASE("the text finds the very preconditions that do not hold, over random operations and scenes") {
  Random random(20261129);
  const Judge judge;
  Escena before = model::Init();
  std::size_t broken = 0, several = 0;
  for (int i = test::fewer_when_sanitized(4000); i > 0; --i) {
    const Operation operation = any_operation(random);
    model::Judgements judged = model::pre(before, operation);
    const auto of_broken = std::ranges::count(judged, false, &model::Judgement::holds);
    broken += of_broken > 0 ? 1 : 0;
    several += of_broken > 1 ? 1 : 0;
    const auto difference = judge.difference(before, operation, judged);
    INFO(difference.value_or(""));
    CHECK_FALSE(difference);
    model::Judgement& one = judged[random.below(judged.size())];  // a judge that errs about one is seen
    one.holds = !one.holds;
    CHECK(judge.difference(before, operation, judged));
    one.holds = !one.holds;
    model::apply_total(before, operation);
  }
  CHECK(broken > 500);
  CHECK(several > 50);
}

TEST_CASE("a precondition that the contracts do not look at is seen by the text") {
  const Judge judge;
  const Escena before = model::Init();
  const model::Elemento e("e");
  const Operation operation = model::Agregar_Esfera{e, {0, 0, 0}, -1};
  model::Judgements judged = model::pre(before, operation);
  CHECK_FALSE(judge.difference(before, operation, judged));
  std::erase_if(judged, [](const model::Judgement& each) { return each.what->label == "Agregar_Esfera.pre.2"; });
  CHECK(judge.difference(before, operation, judged) ==
        "the text refuses what the contracts do not look at: Agregar_Esfera.pre.2 (radio? ∈ Rmas)");
  static constexpr contract::clause unknown{"Agregar_Esfera.pre.9", "radio? ∈ Rmas"};
  judged.push_back({&unknown, false});
  CHECK(judge.difference(before, operation, judged) ==
        "the contracts name no predicate of the text: Agregar_Esfera.pre.9");
}

TEST_CASE("the contracts and the Z text agree on every conjunct of 100000 random transitions") {
  judge_many(20260101, test::fewer_when_sanitized(100000));
}

TEST_CASE("the contracts and the Z text agree on every conjunct of a million transitions", "[long]") {
  judge_many(20260102, 1000000);
}

}  // namespace
}  // namespace durero::spec
