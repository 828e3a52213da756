#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "durero/zed/syntax/defect.hpp"
#include "zed/coq/writer.hpp"
#include "zed/syntax/match.hpp"

namespace durero::zed::coq {
namespace {

/// Some functions the text describes by what they do, and Coq has by a name of its own. The description is exported as
/// a statement about any such function, to be proved of this one.
const std::unordered_map<std::string, std::string>& witnesses() {
  static const std::unordered_map<std::string, std::string> known = {{"raizcuadrada", "sqrt"}, {"elevado", "power_of"}};
  return known;
}

bool is_arrow(const Term& set, std::string_view arrow) {
  return set->kind == Kind::reference && set->name.word == arrow && set->children.size() == 2;
}

/// The sets of the arguments of a function from this set.
std::vector<Term> factors(const Term& from) {
  return from->kind == Kind::product ? from->children : std::vector<Term>{from};
}

/// The equation f(x, y) = E stands under ∀ x : S; y : T | P, where x and y are all the variables in their order.
struct DefiningEquation {
  Name function;
  const SchemaText* text = nullptr;
  Term argument, value;
};

std::vector<Name> variables(const SchemaText& text) {
  std::vector<Name> names;
  for (const Declaration& declaration : text.declarations)
    names.insert(names.end(), declaration.names.begin(), declaration.names.end());
  return names;
}

using match::application_of_name;
using match::is_equation;

std::optional<DefiningEquation> equation(const Term& term) {
  if (term->kind != Kind::forall || !is_equation(term->children[0])) return {};
  const Term& body = term->children[0];
  const Node* left = application_of_name(body->children[0]);
  if (!left) return {};
  const Term& argument = left->children[1];
  const std::vector<Term> parts = argument->kind == Kind::tuple ? argument->children : std::vector<Term>{argument};
  std::vector<Name> given;
  for (const Term& part : parts)
    if (part->kind == Kind::reference) given.push_back(part->name);
  if (given.size() != parts.size() || given != variables(*term->text)) return {};
  return DefiningEquation{left->children[0]->name, term->text.get(), argument, body->children[1]};
}

/// Returns f where the term is dom f = S.
std::optional<Name> stated_domain(const Term& term) {
  if (!is_equation(term)) return {};
  const Term* of = match::argument_of(term->children[0], "dom");
  if (!of || (*of)->kind != Kind::reference) return {};
  return (*of)->name;
}

/// Returns m / n where the term is c * n = m.
std::optional<std::string> solution(const Name& c, const Term& term) {
  if (!is_equation(term) || term->children[1]->kind != Kind::number) return {};
  const Node* factors = match::operands(term->children[0], "_*_");
  if (!factors || factors->children[0]->name != c || factors->children[1]->kind != Kind::number) return {};
  return term->children[1]->name.word + " / " + factors->children[1]->name.word;
}

}  // namespace

void CoqWriter::declare_axiom(const Declaration& declaration) {
  for (const Name& name : declaration.names) {
    CoqSymbol symbol;
    symbol.text = variable(name);
    if (is_arrow(declaration.term, "_→_")) {
      symbol.form = CoqSymbol::Form::function;
      symbol.type = in_.carrier(declaration.term->children[1]);
      symbol.arity = factors(declaration.term->children[0]).size();
    } else {
      symbol.type = in_.carrier(declaration.term);
    }
    in_.symbols[name] = symbol;
  }
}

// Each name is defined by an equation, by its domain and an equation on it, or by what is stated of it.
void CoqWriter::axiomatic(const Axiomatic& form, Place place) {
  if (!form.formals.empty()) uncovered(place, "a generic box");
  Declarations declared;
  std::map<Name, const Predicate*> domains;
  std::vector<const Predicate*> rest;
  for (const Declaration& declaration : form.text.declarations) {
    if (declaration.form != Declaration::Form::typed) uncovered(declaration.place, "this declaration");
    const bool known = std::any_of(declaration.names.begin(), declaration.names.end(),
                                   [&](const Name& name) { return in_.find(name); });
    if (known) continue;
    declare_axiom(declaration);
    for (const Name& name : declaration.names) declared.emplace(name, declaration.term);
  }
  for (const Predicate& predicate : form.text.predicates) {
    const auto of = stated_domain(predicate.term);
    if (of && declared.contains(*of)) domains[*of] = &predicate;
  }
  for (const Predicate& conjunct : form.text.predicates) {
    const auto of = stated_domain(conjunct.term);
    if (of && domains.contains(*of)) continue;
    const auto defining = equation(conjunct.term);
    if (defining && domains.contains(defining->function)) {
      if (!partial_definition(conjunct, declared, *domains[defining->function]))
        uncovered(conjunct.place, "this partial function");
      declared.erase(defining->function);
    } else if (defining && defining->text->predicates.empty() && explicit_definition(conjunct, declared)) {
      declared.erase(defining->function);
    } else {
      rest.push_back(&conjunct);
    }
  }
  if (declared.size() > 1) uncovered(place, "a box with several names that no equation defines");
  for (const auto& [name, set] : declared) implicit_definition(name, set, rest);
  if (!declared.empty()) return;
  for (const Predicate* predicate : rest) {
    if (predicate->label.empty()) uncovered(predicate->place, "an axiom without a label");
    sentence(fmt::format("Definition {} : Prop := {}.", identifier(predicate->label),
                         in_.predicate(predicate->term, {}).text),
             predicate->label);
  }
}

bool CoqWriter::explicit_definition(const Predicate& predicate, const Declarations& declared) {
  const DefiningEquation defining = *equation(predicate.term);
  const auto entry = declared.find(defining.function);
  if (entry == declared.end() || !is_arrow(entry->second, "_→_")) return false;
  CoqScope inside;
  const Signature slots = in_.declare(*defining.text, inside);
  std::string value;
  if (in_.is_set(defining.value)) {
    value = in_.set(defining.value, inside).text;
  } else {
    Frame frame;
    value = in_.term(defining.value, inside, frame).text;
    if (!frame.empty()) uncovered(predicate.place, "a total function that applies a partial one");
  }
  sentence(fmt::format("Definition {} {} : {} := {}.", variable(defining.function), binders(slots, false),
                       in_.symbols.at(defining.function).type.text(), value),
           predicate.label);
  return true;
}

bool CoqWriter::partial_definition(const Predicate& conjunct, const Declarations& declared, const Predicate& domain) {
  const DefiningEquation defining = *equation(conjunct.term);
  const Term& set = domain.term->children[1];
  const auto entry = declared.find(defining.function);
  if (entry == declared.end() || !is_arrow(entry->second, "_⇸_") || set->kind != Kind::comprehension ||
      !set->children.empty() || variables(*set->text) != variables(*defining.text))
    return false;
  CoqScope inside;
  const Signature slots = in_.declare(*set->text, inside);
  std::vector<Expr> conjuncts = in_.conditions(*set->text, slots, {}, inside);
  const std::string y = in_.fresh("y", inside);
  inside.variables.insert(y);
  const CoqSymbol& symbol = in_.symbols.at(defining.function);
  conjuncts.push_back(in_.is_value({y, atomic, symbol.type.element().parts.at(1)}, defining.value, inside));
  std::string arguments;
  for (const Slot& slot : slots) arguments += (arguments.empty() ? "" : ", ") + slot.variable;
  if (slots.size() > 1) arguments = "(" + arguments + ")";
  sentence(fmt::format("Definition {} : {} := fun '({}, {}) => {}.", symbol.text, symbol.type.text(), arguments, y,
                       all_of(conjuncts).text),
           domain.label + ", " + conjunct.label);
  return true;
}

void CoqWriter::implicit_definition(const Name& name, const Term& set, const std::vector<const Predicate*>& stated) {
  const std::string f = variable(name);
  std::string type, witness, declaration;
  CoqScope scope;
  scope.variables = {f};
  if (is_arrow(set, "_→_")) {
    std::string value = f, given;
    Signature arguments;
    for (const Term& part : factors(set->children[0])) {
      const std::string x = in_.fresh("x", scope);
      scope.variables.insert(x);
      const Carrier from = in_.carrier(part);
      type += from.text(true) + " -> ";
      value += " " + x;
      arguments.push_back({{x, {}}, x, from, false, {}});
      for (const Expr& asked : in_.constraint({x, atomic, from}, part, scope)) given += asked.at(implied - 1) + " -> ";
    }
    const Carrier to = in_.carrier(set->children[1]);
    type += to.text();
    const std::vector<Expr> right = in_.constraint({value, applied, to}, set->children[1], scope);
    if (!right.empty())
      declaration = fmt::format("forall {}, {}{}", binders(arguments, true), given, all_of(right).text);
  } else {
    const Carrier of = in_.carrier(set);
    type = of.text();
    if (!in_.whole(set)) declaration = in_.member({f, atomic, of}, set, scope).text;
  }
  if (const auto known = witnesses().find(f); known != witnesses().end()) witness = known->second;
  if (!declaration.empty())
    sentence(fmt::format("Definition {0}_decl ({0} : {1}) : Prop := {2}.", f, type, declaration));
  for (const Predicate* predicate : stated) {
    if (predicate->label.empty()) uncovered(predicate->place, "an axiom without a label");
    sentence(fmt::format("Definition {} ({} : {}) : Prop := {}.", identifier(predicate->label), f, type,
                         in_.predicate(predicate->term, scope).text),
             predicate->label);
    if (witness.empty()) witness = solution(name, predicate->term).value_or("");
  }
  if (witness.empty()) uncovered(set->place, "the implicit definition of " + f);
  sentence(fmt::format("Definition {} : {} := {}.", f, type, witness));
}

}  // namespace durero::zed::coq
