#include "zed/evaluate/constants.hpp"

#include <algorithm>
#include <exception>

#include "zed/evaluate/choice.hpp"
#include "zed/evaluate/compiler.hpp"
#include "zed/evaluate/describe.hpp"
#include "zed/syntax/match.hpp"

namespace durero::zed {
namespace {

const Axiomatic& box_of(const Meaning& constant) { return std::get<Axiomatic>(constant.paragraph->form); }

void add_conjuncts(const Predicate& predicate, std::vector<Predicate>& to) {
  if (predicate.term->kind != Kind::conjunction) return to.push_back(predicate);
  for (const Term& part : predicate.term->children) add_conjuncts({part, predicate.label, part->place}, to);
}

/// Says whether the predicate alone is one of those that define some function or set of the box.
bool defines(const Predicate& predicate, const Axiomatic& form, const Definitions& definitions) {
  const Axiomatic alone{form.formals, {form.text.declarations, {predicate}}};
  const Components names = components(form.text, definitions);
  return std::any_of(names.begin(), names.end(), [&](const Name& name) {
    return match::mentions(predicate.term, {name}) && is_by_cases(name, form) &&
           (is_by_cases(name, alone) || !is_by_cases(name, {form.formals, {form.text.declarations, {}}}));
  });
}

}  // namespace

void Constants::add_facts(const Axiomatic& form) {
  for (const Predicate& predicate : form.text.predicates) {
    if (defines(predicate, form, compiler_.definitions())) continue;
    std::vector<Predicate> conjuncts;
    add_conjuncts(predicate, conjuncts);
    for (Predicate& each : conjuncts) {
      Fact fact{std::move(each), {}};
      for (Meaning* constant : constants_)
        if (match::mentions(fact.predicate.term, {constant->name})) fact.constants.push_back(constant);
      if (!fact.constants.empty()) facts_.push_back(std::move(fact));
    }
  }
}

/// Adds the fact that a constant is in its set, which concerns the constants in the set too.
void Constants::add_declaration(Meaning& constant) {
  const Term& set = *declared_set(constant.name, box_of(constant));
  Fact fact{{zed::relation({{"_∈_", {}}}, {reference(constant.name, {}, set->place), set}), {}, set->place},
            {&constant}};
  for (Meaning* each : constants_)
    if (each != &constant && match::mentions(set, {each->name})) fact.constants.push_back(each);
  if (fact.constants.size() > 1) facts_.push_back(std::move(fact));
}

const std::vector<Constants::Fact>& Constants::facts() {
  if (has_facts_) return facts_;
  has_facts_ = true;
  std::vector<const Axiomatic*> boxes;
  for (const Section& section : compiler_.definitions().sections())
    for (const Paragraph& paragraph : section.paragraphs) {
      const auto* box = std::get_if<Axiomatic>(&paragraph.form);
      if (!box || !box->formals.empty()) continue;
      boxes.push_back(box);
      for (const Name& name : components(box->text, compiler_.definitions())) {
        Meaning* meaning = compiler_.definitions().find(name);
        if (name.text() == "ℝ") continue;  // the axioms of the reals are assumed
        if (meaning && meaning->paragraph == &paragraph && declared_set(name, *box) && !is_by_cases(name, *box))
          constants_.push_back(meaning);
      }
    }
  for (const Axiomatic* box : boxes) add_facts(*box);
  for (Meaning* constant : constants_) add_declaration(*constant);
  return facts_;
}

std::vector<Name> Constants::names() {
  facts();
  std::vector<Name> names;
  for (const Meaning* constant : constants_) names.push_back(constant->name);
  return names;
}

/// The value as it is written where it is declared from the constant's set.
Value Constants::as_declared(const Value& value, const Meaning& constant, Context& context) {
  const Term* set = value.set() || value.tuple() ? declared_set(constant.name, box_of(constant)) : nullptr;
  try {
    const Value declared = set ? compiler_.evaluated(*set, context) : Value();
    return declared.set() && declared.set()->declares_sequences() ? declared.set()->as_declared(value) : value;
  } catch (const EvaluationError&) {  // it is written as it was made
    return value;
  }
}

Value Constants::by_equation(const Meaning& constant, Context& context) {
  for (const Fact& fact : facts())
    if (const Term* value = other_side(fact.predicate.term, constant.name)) return compiler_.evaluated(*value, context);
  return Open{};
}

void Constants::check(const Meaning& constant, Context& context) {
  const auto refuse_false = [&](const Term& said, const std::string& text) {
    try {
      const Scope scope{.unit = std::make_shared<Unit>()};
      const Property property = compiler_.predicate(said, scope);
      Frame frame(scope.unit->size, context);
      if (evaluate(property, frame) != Truth::no) return;
    } catch (const Unsatisfied&) {
      throw;
    } catch (const EvaluationError&) {  // an undecided fact refutes nothing
      return;
    }
    throw Unsatisfied(constant.name.text() + " = " + constant.value->text() + " makes " + text + " false");
  };
  const auto is_known = [&](const Meaning* each) { return each->value || is_given_by_equation(*each); };
  if (const Term* set = declared_set(constant.name, box_of(constant))) {
    const Term declared = zed::relation({{"_∈_", {}}}, {reference(constant.name), *set});
    refuse_false(declared, describe(*declared));
  }
  for (const Fact& fact : facts()) {
    const auto& names = fact.constants;
    if (std::find(names.begin(), names.end(), &constant) == names.end()) continue;
    if (!std::all_of(names.begin(), names.end(), is_known)) continue;
    refuse_false(fact.predicate.term,
                 describe(*fact.predicate.term) + " (line " + std::to_string(fact.predicate.place.line) + ")");
  }
}

bool Constants::is_given_by_equation(const Meaning& constant) {
  return std::any_of(facts().begin(), facts().end(),
                     [&](const Fact& fact) { return other_side(fact.predicate.term, constant.name) != nullptr; });
}

/// Says whether the constant gets a value without the others that are sought; asks for that value where an equation
/// gives it.
bool Constants::is_known_apart(Meaning& constant, Context& context) {
  if (constant.value || constant.busy || !is_given_by_equation(constant)) return constant.value.has_value();
  try {
    compiler_.global(constant, context);
  } catch (const Unsatisfied&) {
    throw;
  } catch (const EvaluationError&) {  // the search for all may find it
  }
  return constant.value.has_value();
}

/// Returns the constant, and all constants without a value that facts relate to it.
std::vector<Meaning*> Constants::known_together(Meaning& constant, Context& context) {
  std::vector<Meaning*> all{&constant};
  const auto is_there = [&](Meaning* each) { return std::find(all.begin(), all.end(), each) != all.end(); };
  for (bool more = true; more;) {
    more = false;
    for (const Fact& fact : facts()) {
      if (std::none_of(fact.constants.begin(), fact.constants.end(), is_there)) continue;
      for (Meaning* each : fact.constants) {
        if (is_there(each) || is_known_apart(*each, context)) continue;
        all.push_back(each);
        more = true;
      }
    }
  }
  return all;
}

Value Constants::looked_for(Meaning& constant, Context& context) {
  const std::vector<Meaning*> sought = known_together(constant, context);
  if (constant.value) return *constant.value;  // it was found with another
  WitnessSearch choice(compiler_, context);
  for (const Meaning* each : sought) choice.add(each->name, *declared_set(each->name, box_of(*each)));
  for (const Fact& fact : facts()) {
    const auto is_sought = [&](Meaning* each) { return std::find(sought.begin(), sought.end(), each) != sought.end(); };
    if (std::any_of(fact.constants.begin(), fact.constants.end(), is_sought)) choice.require(fact.predicate);
  }
  const Truth found = choice.find();
  if (found == Truth::no)
    throw Unsatisfied("no value of " + choice.names_text() + " makes all true that is said of " +
                      (sought.size() == 1 ? "it" : "them"));
  if (found == Truth::open) throw Undetermined(constant.name.text());
  for (std::size_t i = 0; i < sought.size(); ++i) {
    sought[i]->value = as_declared(choice.values()[i], *sought[i], context);
    std::erase_if(taken_, [&](const auto& each) { return each.first == sought[i]->name; });
    if (choice.was_taken(i)) taken_.emplace_back(sought[i]->name, choice.values()[i]);
  }
  return *constant.value;
}

Value Constants::value(Meaning& constant, Context& context) {
  if (!declared_set(constant.name, box_of(constant))) throw Undetermined(constant.name.text());
  facts();
  Value given = Open{};
  std::exception_ptr why_not;
  try {
    given = by_equation(constant, context);
  } catch (const Unsatisfied&) {
    throw;
  } catch (const EvaluationError&) {
    why_not = std::current_exception();
  }
  if (given.is_undefined()) throw Undetermined(constant.name.text());
  if (given.is_open()) {
    try {
      return looked_for(constant, context);
    } catch (const Undetermined&) {
      if (why_not) std::rethrow_exception(why_not);
      throw;
    }
  }
  constant.value = as_declared(given, constant, context);
  try {
    check(constant, context);
  } catch (...) {
    constant.value.reset();
    throw;
  }
  return *constant.value;
}

}  // namespace durero::zed
