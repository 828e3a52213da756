#include <algorithm>
#include <set>

#include "durero/zed/syntax/defect.hpp"
#include "zed/coq/terms.hpp"

namespace durero::zed::coq {

std::optional<Name> schema_name(const Term& schema) {
  if (schema->kind == Kind::reference) return schema->name;
  if (schema->kind != Kind::decoration || schema->children[0]->kind != Kind::reference) return {};
  const Name& base = schema->children[0]->name;
  return Name{base.word, base.strokes + schema->name.strokes};
}

void merge(Signature& to, const Signature& from) {
  for (const Slot& slot : from)
    if (std::none_of(to.begin(), to.end(), [&](const Slot& there) { return there.name == slot.name; }))
      to.push_back(slot);
  std::stable_partition(to.begin(), to.end(), [](const Slot& each) { return each.state; });
}

Slot Translator::state_slot(const Name& name, Place place) const {
  if (name.word != state || (!name.strokes.empty() && name.strokes != "'"))
    uncovered(place, "the inclusion of " + name.text());
  return {name, "s" + name.strokes, Carrier::named(state), true, {}};
}

void Translator::declare(const Slot& slot, CoqScope& scope) const {
  scope.variables.insert(slot.variable);
  if (!slot.state) {
    scope.names[slot.name] = {slot.variable, atomic, slot.type};
    return;
  }
  scope.states[slot.name] = {slot.variable, atomic, slot.type};
  for (const Slot& part : symbols.at({slot.name.word, {}}).signature)
    scope.names[{part.name.word, part.name.strokes + slot.name.strokes}] = {part.variable + " " + slot.variable,
                                                                            applied, part.type};
}

// Says whether a variable of this name would hide what is written under it: another variable, a component, a word of
// Coq.
bool Translator::taken(const std::string& variable, const CoqScope& scope) const {
  static const std::set<std::string> words = {
      "s",        "s'",    "R",     "Z",     "sqrt",  "set",    "rel",    "univ",   "dom",       "ran",
      "inverse",  "image", "ndres", "dres",  "graph", "is_mu",  "True",   "False",  "cartesian", "integers",
      "power_of", "Prop",  "Type",  "Set",   "fun",   "exists", "forall", "in",     "as",        "at",
      "if",       "then",  "else",  "match", "with",  "end",    "let",    "return", "fix",       "cofix"};
  if (words.contains(variable) || scope.variables.contains(variable)) return true;
  for (const auto& [name, symbol] : symbols)
    if (symbol.form == CoqSymbol::Form::carrier)
      for (const Slot& part : symbol.signature)
        if (part.variable == variable) return true;
  return false;
}

// The sets are those of the scope around: a schema text binds its names behind its declarations. A name that is in
// scope already gets another variable.
Signature Translator::declare(const SchemaText& text, CoqScope& scope) const {
  Signature slots;
  for (const Declaration& declaration : text.declarations) {
    if (declaration.form == Declaration::Form::defined) uncovered(declaration.place, "a declaration by ==");
    if (declaration.form == Declaration::Form::included) {
      if (!schema_name(declaration.term)) uncovered(declaration.place, "this inclusion");
      Signature included = signature(declaration.term);
      for (Slot& slot : included) slot.set = {};  // what the schema asks of them included() says
      merge(slots, included);
      continue;
    }
    for (const Name& name : declaration.names) {
      std::string v = variable(name);
      if (taken(v, scope)) v = fresh(v, scope);
      merge(slots, {{name, v, carrier(declaration.term, scope), false, declaration.term}});
    }
  }
  for (const Slot& slot : slots) declare(slot, scope);
  return slots;
}

std::vector<Expr> Translator::conditions(const SchemaText& text, const Signature& slots, const CoqScope& outer,
                                         const CoqScope& inner) const {
  std::vector<Expr> conjuncts;
  for (const Slot& slot : slots) {
    if (!slot.set) continue;
    CoqScope around = outer;
    around.variables = inner.variables;
    for (Expr& expr : constraint({slot.variable, atomic, slot.type}, slot.set, around))
      conjuncts.push_back(std::move(expr));
  }
  for (const Predicate& conjunct : text.predicates) {
    std::vector<Term> parts;
    flatten(Kind::conjunction, conjunct.term, parts);
    for (const Term& part : parts) conjuncts.push_back(predicate(part, inner));
  }
  return conjuncts;
}

Signature Translator::signature(const Term& schema) const {
  Signature out;
  switch (schema->kind) {
    case Kind::reference: {
      const std::string& word = schema->name.word;
      for (const std::string sign : {"Δ", "Ξ"})
        if (word == sign + state)
          return {state_slot({state, {}}, schema->place), state_slot({state, "'"}, schema->place)};
      const CoqSymbol* symbol = find(schema->name);
      if (symbol && symbol->form == CoqSymbol::Form::operation) return symbol->signature;
      return {state_slot(schema->name, schema->place)};
    }
    case Kind::decoration: {
      const auto name = schema_name(schema);
      if (!name) uncovered(schema->place, "this decoration");
      return {state_slot(*name, schema->place)};
    }
    case Kind::schema_text: {
      CoqScope scope;
      return declare(*schema->text, scope);
    }
    case Kind::hiding:
      for (const Slot& slot : signature(schema->children[0]))
        if (std::find(schema->names.begin(), schema->names.end(), slot.name) == schema->names.end())
          out.push_back(slot);
      return out;
    case Kind::negation:
    case Kind::conjunction:
    case Kind::disjunction:
    case Kind::implication:
    case Kind::equivalence:
      for (const Term& child : schema->children) merge(out, signature(child));
      return out;
    default:
      uncovered(schema->place, "this schema expression");
  }
}

Expr Translator::call(const Name& schema, const CoqScope& scope, Place place) const {
  const CoqSymbol* symbol = find(schema);
  std::string text;
  Signature slots;
  if (symbol && symbol->form == CoqSymbol::Form::operation) {
    text = symbol->text;
    slots = symbol->signature;
  } else {
    const bool change = schema.word == "Δ" + state, same = schema.word == "Ξ" + state;
    text = change ? "Delta_" + state : same ? "Xi_" + state : state + "_ok";
    if (change || same)
      slots = {state_slot({state, {}}, place), state_slot({state, "'"}, place)};
    else
      slots = {state_slot(schema, place)};
  }
  for (const Slot& slot : slots) {
    const auto& from = slot.state ? scope.states : scope.names;
    const auto entry = from.find(slot.name);
    if (entry == from.end()) uncovered(place, "the component " + slot.name.text() + " out of scope");
    text += " " + entry->second.at(applied - 1);
  }
  return {text, slots.empty() ? atomic : applied, {}};
}

// What the schemas say that a schema text includes. Its own declarations and predicates are conditions().
std::vector<Expr> Translator::included(const SchemaText& text, const CoqScope& scope) const {
  std::vector<Expr> said;
  for (const Declaration& declaration : text.declarations)
    if (declaration.form == Declaration::Form::included) said.push_back(predicate(declaration.term, scope));
  return said;
}

// What pre hides: the state after, and the outputs.
std::vector<Name> Translator::after(const Term& schema) const {
  std::vector<Name> names;
  for (const Slot& slot : signature(schema))
    if (slot.name.strokes.ends_with("'") || slot.name.strokes.ends_with("!")) names.push_back(slot.name);
  return names;
}

Expr Translator::without(const Term& schema, const std::vector<Name>& names, const CoqScope& scope) const {
  CoqScope inside = scope;
  Signature hidden;
  for (const Slot& slot : signature(schema))
    if (std::find(names.begin(), names.end(), slot.name) != names.end()) hidden.push_back(slot);
  for (const Slot& slot : hidden) declare(slot, inside);
  const Expr body = predicate(schema, inside);
  return {"exists " + binders(hidden, true) + ", " + body.text, binder, {}};
}

}  // namespace durero::zed::coq
