#include "machine_parts.hpp"

#include <algorithm>
#include <stdexcept>

#include "durero/spec/constants.hpp"
#include "durero/text/nearest.hpp"
#include "durero/zed/print/print.hpp"
#include "durero/zed/syntax/paragraphs.hpp"

namespace durero::spec {

using zed::Name;
using zed::Type;
using zed::Value;

namespace {

std::vector<Name> primed_names(std::vector<Name> names) {
  for (Name& name : names) name.strokes += "'";
  return names;
}

bool includes_all(const std::vector<Name>& names, const std::vector<Name>& wanted) {
  return std::all_of(wanted.begin(), wanted.end(),
                     [&](const Name& name) { return std::find(names.begin(), names.end(), name) != names.end(); });
}

bool is_operation_on(const std::vector<Name>& fields, const std::vector<Name>& of_state) {
  return includes_all(fields, of_state) && includes_all(fields, primed_names(of_state));
}

zed::Section section_that_sees_all(const zed::Specification& specification, const char* name) {
  zed::Section section;
  section.file = "RUN";
  section.name = name;
  for (const zed::Section& parent : specification.sections) section.parents.push_back(parent.name);
  return section;
}

/// Sets with all their subsets as samples have this many members at most.
constexpr std::size_t most_for_subsets = 4;
/// A tuple or a binding has this many samples at most.
constexpr std::size_t most_samples = 200;

}  // namespace

Machine::Parts::Parts(const zed::Specification& text, Setup how) : setup(std::move(how)), specification(text) {
  notation = notation_of(specification);
  specification.sections.push_back(section_that_sees_all(specification, section_name));
  typing = zed::check(specification);
  if (!typing.ok()) throw std::invalid_argument(typing.defects.front().text());
  declare_carriers();
  typing = zed::check(specification);
  const std::string section = section_name;
  const zed::Valuation constants = typed_constants(setup.constants, {specification, typing, section, given});
  given.insert(given.end(), constants.begin(), constants.end());
  evaluator = std::make_unique<zed::Evaluator>(specification.sections, given, &steps);
  take_constants();
  const Fields all = schemas();
  choose_state(all);
  choose_init(all);
  components = evaluator->schema(Name{state, ""}).components();
  add_types(state);
  if (!init.empty()) add_types(init);
  add_operations(all);
  add_claims();
}

void Machine::Parts::declare_carriers() {
  zed::Axiomatic box;
  for (const zed::Section& section : specification.sections)
    for (const zed::Paragraph& paragraph : section.paragraphs) {
      const auto* sets = std::get_if<zed::GivenTypes>(&paragraph.form);
      for (const Name& set : sets ? sets->names : std::vector<Name>()) {
        auto& words = carriers[set.text()];
        if (const auto chosen = setup.given.find(set.text()); chosen != setup.given.end()) words = chosen->second;
        for (std::size_t i = 1; words.size() < setup.members && !setup.given.contains(set.text()); ++i)
          if (const std::string word = set.text() + std::to_string(i); !typing.find(section_name, {word, ""}))
            words.push_back(word);
        zed::Declaration declared{zed::Declaration::Form::typed, {}, {}, zed::reference(set), {}};
        std::vector<Value> values;
        for (const std::string& word : words) {
          if (!zed::is_free_word(word) || typing.find(section_name, {word, ""}))
            throw GivenSetError(word + " cannot name a member of " + set.text() + "; expected a new word");
          declared.names.push_back({word, ""});
          declared.places.emplace_back();
          values.push_back(Value::atom(set.text(), word));
          given.emplace_back(Name{word, ""}, values.back());
        }
        if (!words.empty()) box.text.declarations.push_back(std::move(declared));
        given.emplace_back(set, Value::set(std::move(values)));
      }
    }
  for (const auto& [set, words] : setup.given)
    if (!carriers.contains(set)) refuse_given(set);
  if (!box.text.declarations.empty()) specification.sections.back().paragraphs.push_back({{}, std::move(box)});
}

/// Refuses members for a name that is no given set. A constant has one way to get a value, and it is another one.
void Machine::Parts::refuse_given(const std::string& set) const {
  const zed::Global* global = typing.find(section_name, {set, ""});
  if (global && global->form == zed::Global::Form::axiom && global->scheme.formals.empty())
    throw GivenSetError(set + " is a constant, and no given set; expected --let " + set + "=VALUE");
  std::vector<std::string> sets;
  for (const auto& [name, words] : carriers) sets.push_back(name);
  throw GivenSetError("the text has no given set " + set + "; expected " + text::nearest(set, sets).value_or("one"));
}

/// Asks for every constant, so that what is taken for some is known from the beginning.
void Machine::Parts::take_constants() {
  for (const Name& constant : evaluator->constants()) try {
      begin_question();
      evaluator->value(constant);
    } catch (const zed::EvaluationError&) {  // who needs it is told so
    } catch (const zed::StepsSpent&) {
    }
}

Machine::Parts::Fields Machine::Parts::schemas() const {
  Fields all;
  for (const zed::Section& section : specification.sections)
    for (const zed::Paragraph& paragraph : section.paragraphs) {
      const bool may_be = std::holds_alternative<zed::Schema>(paragraph.form) ||
                          std::holds_alternative<zed::Definition>(paragraph.form);
      for (const Name& name : may_be ? zed::names_of(paragraph) : std::vector<Name>()) {
        const zed::Global* global = typing.find(section_name, name);
        if (!global || !global->scheme.formals.empty() || !global->scheme.type.is_schema_set()) continue;
        all[name.text()] = global->scheme.type.parts()[0].fields();
      }
    }
  return all;
}

namespace {

std::vector<std::string> init_names(const std::string& state) {
  return {"Init" + state, state + "Init", "Init_" + state, state + "_Init", "Init", "Inic" + state};
}

bool begins(const std::vector<Name>& fields, const std::vector<Name>& of_state) {
  return !is_operation_on(fields, of_state) &&
         (includes_all(fields, of_state) || includes_all(fields, primed_names(of_state)));
}

}  // namespace

// A schema with an initial one is a state before one without; then the one with the most components; then the first
// by name.
void Machine::Parts::choose_state(const Fields& all) {
  if (!setup.state.empty()) {
    if (!all.contains(setup.state))
      throw std::invalid_argument("the text has no schema " + setup.state + "; expected one for --state");
    state = setup.state;
    return;
  }
  std::pair<bool, std::size_t> best{false, 0};
  for (const auto& [name, fields] : all) {
    const bool some = std::any_of(all.begin(), all.end(), [&, &of_state = fields](const auto& other) {
      return is_operation_on(other.second, of_state);
    });
    if (fields.empty() || !some) continue;
    bool has_init = false;
    for (const std::string& word : init_names(name))
      has_init = has_init || (all.contains(word) && begins(all.at(word), fields));
    const std::pair rank{has_init, fields.size()};
    if (rank > best) {
      best = rank;
      state = name;
    }
  }
  if (state.empty())
    throw std::invalid_argument(
        "the text has no state: no schema has the components of another, S, and of S ';"
        " expected operations");
}

void Machine::Parts::choose_init(const Fields& all) {
  const std::vector<Name>& of_state = all.at(state);
  for (const std::string& word : setup.init.empty() ? init_names(state) : std::vector{setup.init})
    if (init.empty() && all.contains(word) && begins(all.at(word), of_state)) init = word;
  if (init.empty() && !setup.init.empty())
    throw std::invalid_argument(setup.init + " is no initial schema of " + state + "; expected one for --init");
}

void Machine::Parts::add_types(const std::string& schema) {
  const Type& type = typing.find(section_name, {schema, ""})->scheme.type.parts()[0];
  for (std::size_t i = 0; i < type.fields().size(); ++i) types.emplace(type.fields()[i], type.parts()[i].settled());
}

void Machine::Parts::add_operations(const Fields& all) {
  for (const auto& [name, fields] : all) {
    if (!is_operation_on(fields, components)) continue;
    MachineOperation operation{name, {}, {}};
    for (const Name& field : fields) {
      if (field.strokes.ends_with("?")) operation.inputs.push_back(field);
      if (field.strokes.ends_with("!")) operation.outputs.push_back(field);
    }
    add_types(name);
    operations.push_back(std::move(operation));
  }
}

void Machine::Parts::add_claims() {
  for (const zed::Section& section : specification.sections)
    for (const zed::Paragraph& paragraph : section.paragraphs)
      if (const auto* conjecture = std::get_if<zed::Conjecture>(&paragraph.form))
        claims.push_back({conjecture->claim.term, zed::to_unicode(conjecture->claim.term),
                          section.file + ":" + std::to_string(conjecture->claim.place.line)});
}

const zed::SchemaCheck& Machine::Parts::check(const std::string& schema) const {
  const auto at = checks_.find(schema);
  if (at != checks_.end()) return at->second;
  return checks_.emplace(schema, evaluator->schema({schema, ""})).first->second;
}

const zed::Completion& Machine::Parts::completion(const std::string& schema, const std::vector<Name>& known) const {
  const std::pair key{schema, known};
  const auto at = completions_.find(key);
  if (at != completions_.end()) return at->second;
  return completions_.emplace(key, evaluator->completion({schema, ""}, known)).first->second;
}

zed::Valuation Machine::Parts::named(const zed::Valuation& before, const Transition& transition) const {
  zed::Valuation all = before;
  for (const auto& [name, value] : transition.after) all.emplace_back(Name{name.word, name.strokes + "'"}, value);
  all.insert(all.end(), transition.inputs.begin(), transition.inputs.end());
  all.insert(all.end(), transition.outputs.begin(), transition.outputs.end());
  return all;
}

bool Machine::Parts::has_numbers(const Type& type) const {
  if (type.is(Type::Kind::given)) return type.name().text() == "𝔸";
  return std::any_of(type.parts().begin(), type.parts().end(), [this](const Type& part) { return has_numbers(part); });
}

namespace {

/// Every choice of one value for each part, the last part's fastest, as many as there may be.
std::vector<std::vector<Value>> choices(const std::vector<std::vector<Value>>& of_parts) {
  std::vector<std::vector<Value>> rows{{}};
  for (const std::vector<Value>& values : of_parts) {
    std::vector<std::vector<Value>> longer;
    for (const auto& row : rows)
      for (const Value& value : values) {
        if (longer.size() == most_samples) break;
        longer.push_back(row);
        longer.back().push_back(value);
      }
    rows = std::move(longer);
  }
  return rows;
}

std::vector<Value> some_subsets(const std::vector<Value>& of) {
  std::vector<Value> sets{Value::set({})};
  if (of.size() > most_for_subsets) {
    for (const Value& member : of) sets.push_back(Value::set({member}));
    sets.push_back(Value::set(of));
    return sets;
  }
  for (std::size_t bits = 1; bits < std::size_t{1} << of.size(); ++bits) {
    std::vector<Value> some;
    for (std::size_t i = 0; i < of.size(); ++i)
      if ((bits >> i & 1U) != 0) some.push_back(of[i]);
    sets.push_back(Value::set(std::move(some)));
  }
  return sets;
}

}  // namespace

zed::Truth Machine::Parts::truth(const zed::Term& term, const zed::Valuation& locals, Claim& claim) const {
  begin_question();
  try {
    return evaluator->holds(term, locals);
  } catch (const zed::EvaluationError&) {
    return zed::Truth::open;
  } catch (const zed::StepsSpent&) {
    claim.truth = zed::Truth::open;  // in another state it would take as many
    return zed::Truth::open;
  }
}

std::vector<Value> Machine::Parts::samples(const Type& type) const {
  if (type.is(Type::Kind::power)) return some_subsets(samples(type.parts()[0]));
  if (type.is(Type::Kind::product) || type.is(Type::Kind::schema)) {
    std::vector<std::vector<Value>> of_parts;
    for (const Type& part : type.parts()) of_parts.push_back(samples(part));
    std::vector<Value> values;
    for (auto& row : choices(of_parts))
      values.push_back(type.is(Type::Kind::product) ? Value::tuple(std::move(row))
                                                    : Value::binding(zed::signature(type.fields()), std::move(row)));
    return values;
  }
  if (has_numbers(type)) {
    std::vector<Value> numbers{zed::Real(0)};
    for (int n = 1; n <= setup.numbers; ++n)
      for (const int number : {n, -n}) numbers.emplace_back(zed::Real(number));
    return numbers;
  }
  const Value all = evaluator->value(type.name());
  if (!all.set() || !all.set()->members()) return {};
  return *all.set()->members();
}

}  // namespace durero::spec
