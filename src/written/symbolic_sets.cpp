/// Predicates, and what it takes to be a member of a set.
#include <fmt/format.h>

#include "durero/zed/print/print.hpp"
#include "durero/zed/syntax/paragraphs.hpp"
#include "symbolic.hpp"

namespace durero::written {

using zed::Kind;
using zed::Name;
using zed::Term;

namespace {

constexpr const char* expected_predicate = "expected comparisons of polynomials, joined by ∧, ∨, ¬, ⇒ and ⇔";
constexpr const char* expected_set = "expected { w : Punto | … }, a schema, or ∪, ∩ and ∖ of such";

}  // namespace

Condition Symbolic::condition(const Term& term, const ScopePtr& scope) {
  steps_.take();
  const auto part = [&](std::size_t i) { return condition(term->children[i], scope); };
  switch (term->kind) {
    case Kind::truth:
    case Kind::falsity:
      return always(term->kind == Kind::truth);
    case Kind::negation:
      return negated(part(0));
    case Kind::conjunction:
      return both(part(0), part(1));
    case Kind::disjunction:
      return either(part(0), part(1));
    case Kind::implication:
      return either(negated(part(0)), part(1));
    case Kind::equivalence: {
      const Condition a = part(0), b = part(1);
      return both(either(negated(a), b), either(a, negated(b)));
    }
    case Kind::let:
      return condition(term->children[0], let_scope(term, scope));
    case Kind::relation: {
      if (term->children.size() != term->names.size() + 1) break;
      Condition all = always(true);
      for (std::size_t i = 0; i < term->names.size(); ++i)
        all = both(std::move(all), relation(term->names[i].word, term->children[i], term->children[i + 1], scope));
      return all;
    }
    default:
      break;
  }
  refuse(scope, term->place, zed::to_unicode(term) + " is not followed", expected_predicate);
}

Condition Symbolic::relation(const std::string& word, const Term& a, const Term& b, const ScopePtr& scope) {
  if (word == "_∈_") return member_of(value(a, scope), b, scope);
  if (word == "_∉_") return negated(member_of(value(a, scope), b, scope));
  const SymbolicValue left = value(a, scope), right = value(b, scope);
  if (word == "_=_") return equal(left, right, a, scope);
  if (word == "_≠_") return negated(equal(left, right, a, scope));
  static const std::map<std::string, Signs> orders{{"_<_", {true, false, false}},
                                                   {"_≤_", {true, true, false}},
                                                   {"_>_", {false, false, true}},
                                                   {"_≥_", {false, true, true}}};
  const auto order = orders.find(word);
  if (order == orders.end()) refuse(scope, a->place, word + " is not followed", expected_predicate);
  return compared(formula(left, a, scope) - formula(right, b, scope), order->second);
}

Condition Symbolic::equal(const SymbolicValue& a, const SymbolicValue& b, const Term& term,
                          const ScopePtr& scope) const {
  Condition all = always(true);
  if (const auto *const x = std::get_if<Formula>(&a.form), *const y = std::get_if<Formula>(&b.form); x && y)
    return compared(*x - *y, {false, true, false});
  if (const auto *const x = std::get_if<Tuple>(&a.form), *const y = std::get_if<Tuple>(&b.form); x && y) {
    for (std::size_t i = 0; i < x->size(); ++i) all = both(std::move(all), equal((*x)[i], (*y)[i], term, scope));
    return all;
  }
  if (const auto *const x = std::get_if<Fields>(&a.form), *const y = std::get_if<Fields>(&b.form); x && y) {
    for (const auto& [name, part] : *x) all = both(std::move(all), equal(part, y->at(name), term, scope));
    return all;
  }
  refuse(scope, term->place, zed::to_unicode(term) + " is no polynomial in the coordinates of the point",
         "expected sums, differences and products");
}

Condition Symbolic::member_of(const SymbolicValue& value, const Term& set, const ScopePtr& scope) {
  steps_.take();
  switch (set->kind) {
    case Kind::reference:
      return member_of_name(value, set, scope);
    case Kind::comprehension:
      if (set->children.empty()) return satisfies(value, *set->text, false, set, scope);
      break;
    case Kind::schema_text:
      return satisfies(value, *set->text, true, set, scope);
    case Kind::application:
      return member_of_application(value, set, scope);
    case Kind::conditional:
    case Kind::let: {
      const SymbolicValue known = this->value(set, scope);
      if (const auto* const other = std::get_if<Suspended>(&known.form)) return member(value, *other);
      break;
    }
    default:
      break;
  }
  refuse(scope, set->place, zed::to_unicode(set) + " is not followed", expected_set);
}

Condition Symbolic::member_of_name(const SymbolicValue& value, const Term& set, const ScopePtr& scope) {
  const zed::Global* const known = global(scope, set->name);
  const zed::Paragraph* const paragraph = known ? paragraph_of(*known) : nullptr;
  const bool is_number = std::holds_alternative<Formula>(value.form);
  if ((set->name.text() == "ℝ" || set->name.text() == "𝔸") && is_number) return always(true);
  if (paragraph != nullptr) {
    const ScopePtr there = std::make_shared<const SymbolicScope>(SymbolicScope{{}, nullptr, known->section});
    if (const auto* const schema = std::get_if<zed::Schema>(&paragraph->form); schema && schema->formals.empty())
      return satisfies(value, schema->text, true, set, there);
  }
  const SymbolicValue other = this->value(set, scope);
  if (const auto* const suspended = std::get_if<Suspended>(&other.form); suspended && suspended->term != set)
    return member(value, *suspended);
  refuse(scope, set->place, zed::to_unicode(set) + " is not followed", expected_set);
}

Condition Symbolic::member_of_application(const SymbolicValue& value, const Term& set, const ScopePtr& scope) {
  const Term& of = set->children[0];
  const Term& argument = set->children[1];
  if (of->kind == Kind::reference && argument->kind == Kind::tuple && argument->children.size() == 2) {
    const auto part = [&](std::size_t i) { return member_of(value, argument->children[i], scope); };
    if (of->name.word == "_∪_") return either(part(0), part(1));
    if (of->name.word == "_∩_") return both(part(0), part(1));
    if (of->name.word == "_∖_") return both(part(0), negated(part(1)));
  }
  const SymbolicValue known = this->value(set, scope);
  if (const auto* const other = std::get_if<Suspended>(&known.form); other && other->term != set)
    return member(value, *other);
  refuse(scope, set->place, zed::to_unicode(set) + " is not followed", expected_set);
}

Condition Symbolic::satisfies(const SymbolicValue& value, const zed::SchemaText& text, bool is_schema, const Term& set,
                              const ScopePtr& scope) {
  Fields names;
  const auto& first = text.declarations[0];
  const auto* const fields = std::get_if<Fields>(&value.form);
  const bool is_one = text.declarations.size() == 1 && first.names.size() == 1;
  if (is_schema && fields) {
    names = *fields;
  } else if (!is_schema && is_one) {
    names.emplace(first.names[0], value);
  } else {
    refuse(scope, set->place, zed::to_unicode(set) + " is not followed", expected_set);
  }
  Condition all = always(true);
  for (const zed::Declaration& declaration : text.declarations)
    all = both(std::move(all), declared(declaration, names, set, scope));
  const ScopePtr inner = std::make_shared<const SymbolicScope>(SymbolicScope{names, scope, scope->section});
  for (const zed::Predicate& predicate : text.predicates) all = both(std::move(all), condition(predicate.term, inner));
  return all;
}

Condition Symbolic::declared(const zed::Declaration& declaration, const Fields& names, const Term& set,
                             const ScopePtr& scope) {
  switch (declaration.form) {
    case zed::Declaration::Form::typed: {
      Condition all = always(true);
      for (const Name& name : declaration.names)
        all = both(std::move(all), member_of(names.at(name), declaration.term, scope));
      return all;
    }
    case zed::Declaration::Form::included:
      return member_of(SymbolicValue{names}, declaration.term, scope);
    case zed::Declaration::Form::defined:
      break;
  }
  refuse(scope, set->place, zed::to_unicode(set) + " is not followed", expected_set);
}

}  // namespace durero::written
