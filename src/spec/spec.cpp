#include "durero/spec/spec.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <stdexcept>

#include "durero/model/malla.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/model/vista.hpp"

namespace durero::embedded {
const std::map<std::string, std::string>& z_text();
}

namespace durero::spec {
namespace {

using model::Operation;
using zed::Name;
using zed::Truth;
using zed::Value;

Named primed(Named named) {
  for (auto& component : named) component.first.strokes += "'";
  return named;
}

void append(Named& to, Named from) { std::move(from.begin(), from.end(), std::back_inserter(to)); }

bool decided(Truth truth, const std::string& what) {
  if (truth == Truth::open) throw zed::EvaluationError(what + " cannot be decided");
  return truth == Truth::yes;
}

}  // namespace

const std::map<std::string, std::string>& files() { return embedded::z_text(); }

const zed::Specification& text() {
  static const zed::Specification& read = [&]() -> const zed::Specification& {  // no end of the program takes it apart
    auto own = std::make_unique<zed::Specification>(zed::read_texts(files()));
    if (!own->ok()) throw std::logic_error("the program's own Z text: " + own->defects[0].text());
    return *own.release();
  }();
  return read;
}

std::vector<Value> in_order(const std::vector<Name>& components, const Named& named) {
  std::vector<Value> values(components.size(), zed::Open{});
  for (const auto& [name, value] : named) {
    const auto found = std::find(components.begin(), components.end(), name);
    if (found != components.end()) values[static_cast<std::size_t>(found - components.begin())] = value;
  }
  return values;
}

Named named(const OperationStep& step) {
  Named all = components(step.before);
  append(all, primed(components(step.after)));
  append(all, inputs(step.operation));
  all.emplace_back(Name{"r", "!"}, value(step.r));
  return all;
}

std::string schema_name(const Operation& operation) {
  return std::string(std::visit([](const auto& in) { return in.schema; }, operation));
}
std::string total_name(const Operation& operation) {
  return std::string(std::visit([](const auto& in) { return in.total; }, operation));
}

bool in_de_malla(const model::Elemento& e, const model::Mallas& s) {
  std::set<model::Elemento> meshes;
  model::Ordinal most = 0;
  for (const auto& [m, malla] : s.mallas) {
    meshes.insert(m);
    most = std::max(most, static_cast<model::Ordinal>(malla.red().caras().size()));
  }
  const zed::Evaluator evaluator(text().sections, {{{"nombre_cara", ""}, names_of_faces(meshes, most)}});
  const Value names = evaluator.apply(evaluator.value(Name{"de_malla", ""}), binding(components(s)));
  return decided(evaluator.contains(names, value(e)), "whether " + e.name() + " ∈ de_malla(θMallas)");
}

struct Judge::Schemas {
  zed::Evaluator evaluator{text().sections};
  std::map<std::string, zed::SchemaCheck> checks{};

  const zed::SchemaCheck& operator[](const std::string& name) {
    const auto found = checks.find(name);
    if (found != checks.end()) return found->second;
    return checks.emplace(name, evaluator.schema({name, ""})).first->second;
  }

  Value function(const char* name) const { return evaluator.value(Name{name, ""}); }
  bool contains(const Value& set, const Value& value) const {
    const Truth truth = evaluator.contains(set, value);  // spelled only where it is open: to spell a set may list it
    return decided(truth, truth == Truth::open ? "whether " + value.text() + " ∈ " + set.text() : "");
  }
};

Judge::Judge() : schemas_(std::make_unique<Schemas>()) {}
Judge::~Judge() = default;

const zed::Evaluator& Judge::evaluator() const { return schemas_->evaluator; }

bool Judge::holds(const OperationStep& step) const {
  const std::string name = schema_name(step.operation);
  const zed::SchemaCheck& schema = (*schemas_)[name];
  return decided(schema.holds(in_order(schema.components(), named(step))), name);
}

bool Judge::holds_total(const OperationStep& step) const {
  const std::string name = total_name(step.operation);
  const zed::SchemaCheck& schema = (*schemas_)[name];
  return decided(schema.holds(in_order(schema.components(), named(step))), name);
}

std::vector<zed::ConjunctTruth> Judge::findings(const OperationStep& step) const {
  const zed::SchemaCheck& schema = (*schemas_)[schema_name(step.operation)];
  return schema.findings(in_order(schema.components(), named(step)));
}

std::vector<zed::ConjunctTruth> Judge::findings(const model::Escena& before, const Operation& operation) const {
  const zed::SchemaCheck& schema = (*schemas_)[schema_name(operation)];
  Named all = components(before);
  append(all, inputs(operation));
  return schema.findings(in_order(schema.components(), all));
}

std::vector<zed::ConjunctTruth> Judge::change_findings(const model::Escena& before,
                                                       const model::AttributeChange& change) const {
  const zed::SchemaCheck& schema = (*schemas_)[model::schema_name(change)];
  Named all = components(before);
  append(all, change_inputs(change));
  return schema.findings(in_order(schema.components(), all));
}

std::vector<zed::ConjunctTruth> Judge::findings(const model::Escena& escena) const {
  const zed::SchemaCheck& schema = (*schemas_)["Escena"];
  return schema.findings(in_order(schema.components(), components(escena)));
}

namespace {

std::string told(const zed::ConjunctTruth& finding) {
  return (finding.label.empty() ? std::string() : finding.label + " ") + "(" + finding.predicate + ")";
}

/// The partial operation that a total one stands for. The total one hides t?, so a specific addition is that of its own
/// type; the general addition looks at the inputs of its type alone, as the schema of that type does.
Operation partial_of(const model::Agregar_Elemento& in) {
  return std::visit([](auto addition) { return Operation(std::move(addition)); }, model::specific(in));
}
template <class Op>
Operation partial_of(Op in) {
  if constexpr (requires { in.t; }) in.t = Op::tipo;
  return in;
}

const zed::ConjunctTruth* first(const std::vector<zed::ConjunctTruth>& findings, Truth truth) {
  const auto found =
      std::find_if(findings.begin(), findings.end(), [&](const auto& finding) { return finding.truth == truth; });
  return found == findings.end() ? nullptr : &*found;
}

/// What the text says otherwise than judgements of preconditions, and what it refuses that none of them looks at.
struct JudgedDifference {
  std::optional<std::string> otherwise, unseen;
};

JudgedDifference difference_of(const std::vector<zed::ConjunctTruth>& all, const model::Judgements& judged) {
  JudgedDifference difference;
  for (const auto& [what, holds] : judged) {
    const auto found = std::ranges::find(all, what->label, &zed::ConjunctTruth::label);
    if (found == all.end()) {
      difference.otherwise = "the contracts name no predicate of the text: " + std::string(what->label);
      return difference;
    }
    if (found->truth == (holds ? Truth::yes : Truth::no)) continue;
    difference.otherwise = std::string(holds ? "the text refuses" : "the text does not refuse") +
                           " what the contracts " + (holds ? "accept: " : "refuse: ") + told(*found);
    return difference;
  }
  const auto is_judged = [&](const zed::ConjunctTruth& finding) {
    return std::ranges::any_of(judged, [&](const model::Judgement& each) { return each.what->label == finding.label; });
  };
  const auto unseen = std::ranges::find_if(
      all, [&](const zed::ConjunctTruth& each) { return each.truth == Truth::no && !is_judged(each); });
  if (unseen != all.end()) difference.unseen = "the text refuses what the contracts do not look at: " + told(*unseen);
  return difference;
}

}  // namespace

/// A transition that contracts made or declined, as the text asks of it.
struct Judge::Transition {
  Named before, after;  ///< the components of the states
  const model::Answer& answer;
  std::string partial;  ///< the schema of the partial operation, whose preconditions are named
  std::string done;     ///< the schema that holds where the operation is done
  std::string total;    ///< the schema that holds of every answer
  Named partial_inputs, inputs;
};

std::optional<std::string> Judge::difference(const Transition& step) const {
  Named whole = step.before, known = step.before;
  append(whole, primed(step.after));
  append(whole, step.inputs);
  whole.emplace_back(Name{"r", "!"}, value(step.answer.r));
  append(known, step.partial_inputs);
  const auto holds_of = [&](const std::string& name) {
    const zed::SchemaCheck& schema = (*schemas_)[name];
    return decided(schema.holds(in_order(schema.components(), whole)), name);
  };
  const auto findings_of = [&](const std::string& name, const Named& named) {
    const zed::SchemaCheck& schema = (*schemas_)[name];
    return schema.findings(in_order(schema.components(), named));
  };
  if (step.answer.ok()) {
    if (!holds_of(step.done)) {
      const auto all = findings_of(step.done, whole);
      const zed::ConjunctTruth* broken = first(all, Truth::no);
      return "the contracts accept what the text refuses: " + (broken ? told(*broken) : step.done);
    }
  } else {
    const auto all = findings_of(step.partial, known);
    const auto named = std::find_if(all.begin(), all.end(),
                                    [&](const auto& finding) { return finding.label == step.answer.violated->label; });
    if (named == all.end())
      return "the contracts name no predicate of the text: " + std::string(step.answer.violated->label);
    if (named->truth != Truth::no) return "the contracts refuse what the text accepts: " + told(*named);
  }
  if (!holds_of(step.total)) return "the answer does not satisfy " + step.total;
  return std::nullopt;
}

std::optional<std::string> Judge::difference(const model::Escena& before, const Operation& operation,
                                             const model::Answer& answer, const model::Escena& after) const {
  const Operation partial = std::visit([](const auto& in) { return partial_of(in); }, operation);
  // The general addition differs from that of its type by its answer alone.
  const Operation& done = std::holds_alternative<model::Agregar_Elemento>(operation) ? operation : partial;
  return difference(Transition{components(before), components(after), answer, schema_name(partial), schema_name(done),
                               total_name(operation), spec::inputs(partial),
                               spec::inputs(answer.ok() ? done : operation)});
}

std::optional<std::string> Judge::change_difference(const model::Escena& before, const model::AttributeChange& change,
                                                    const model::Answer& answer, const model::Escena& after) const {
  const std::string partial = model::schema_name(change);
  const Named given = change_inputs(change);
  return difference(Transition{components(before), components(after), answer, partial, partial,
                               model::total_name(change), given, given});
}

std::optional<std::string> Judge::change_difference(const model::Vista& before, const model::LookChange& change,
                                                    const model::Answer& answer, const model::Vista& after) const {
  const std::string partial(std::visit([](const auto& in) { return in.schema; }, change));
  const std::string total(std::visit([](const auto& in) { return in.total; }, change));
  const Named given = change_inputs(change);
  return difference(Transition{components(before), components(after), answer, partial, partial, total, given, given});
}

std::optional<std::string> Judge::difference(const model::Escena& before, const Operation& operation,
                                             const model::Judgements& judged) const {
  const auto* const general = std::get_if<model::Agregar_Elemento>(&operation);
  const auto found = difference_of(findings(before, general != nullptr ? partial_of(*general) : operation), judged);
  if (found.otherwise) return found.otherwise;
  // The general removal is that of some type: it asks no more where there is the element, and has no type elsewhere.
  if (std::holds_alternative<model::Eliminar_Elemento>(operation) && !model::all_hold(judged)) return std::nullopt;
  return found.unseen;
}

std::optional<std::string> Judge::change_difference(const model::Escena& before, const model::AttributeChange& change,
                                                    const model::Judgements& judged) const {
  const auto found = difference_of(change_findings(before, change), judged);
  return found.otherwise ? found.otherwise : found.unseen;
}

bool Judge::in_puntos_de_rayo(const model::ExactPoint& p, const model::Rayo& rayo) const {
  return schemas_->contains(evaluator().apply(schemas_->function("puntos_de_rayo"), value(rayo)), value(p));
}

bool Judge::in_puntos_de_escena(const model::ExactPoint& p, const Value& escena) const {
  return schemas_->contains(evaluator().apply(schemas_->function("puntos_de_escena"), escena), value(p));
}

bool Judge::in_alcance(const model::ExactPoint& p, const Value& escena, const model::Rayo& rayo,
                       const std::set<model::Elemento>& en, const model::Elemento& e) const {
  std::vector<Value> origin;
  origin.reserve(en.size());
  for (const model::Elemento& start : en) origin.push_back(value(start));
  const Value argument = Value::tuple({escena, value(rayo), Value::set(std::move(origin)), value(e)});
  return schemas_->contains(evaluator().apply(schemas_->function("alcance"), argument), value(p));
}

std::set<model::Elemento> Judge::de_que_elemento(const Value& escena, const model::ExactPoint& p) const {
  const Value found = evaluator().apply(schemas_->function("de_que_elemento"), Value::pair(escena, value(p)));
  if (!found.set() || !found.set()->members()) throw zed::EvaluationError("de_que_elemento cannot be decided");
  std::set<model::Elemento> elements;
  for (const Value& element : *found.set()->members()) elements.emplace((*element.get<zed::Atom>())->text);
  return elements;
}

std::optional<Value> Judge::reduccion(std::span<const model::ExactPoint> ps, const model::Punto& ojo) const {
  std::vector<Value> points;
  for (const model::ExactPoint& p : ps) points.push_back(value(p));
  const Value argument = Value::pair(Value::set(std::move(points)), value(ojo));
  Value found = evaluator().apply(schemas_->function("reduccion"), argument);
  if (found.is_undefined()) return std::nullopt;
  return found;
}

}  // namespace durero::spec
