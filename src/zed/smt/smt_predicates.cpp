/// Translates predicates.

#include "zed/smt/smt_slots.hpp"
#include "zed/smt/smt_translator.hpp"
#include "zed/syntax/match.hpp"

namespace durero::zed {
std::string smt_quantified(const std::string& by, const std::vector<SmtSymbol>& symbols, const std::string& body) {
  if (symbols.empty() || body == "true" || body == "false") return body;  // each sort has members
  std::string declared;
  for (const SmtSymbol& each : symbols) declared += (declared.empty() ? "(" : " (") + each.name + " " + each.sort + ")";
  return smt_call(by, {"(" + declared + ")", body});
}

std::string SmtTranslator::predicate(const Term& term, const SmtScope& scope) {
  count();
  std::string made = open_predicate(term, scope);
  written(made.size());
  return made;
}

/// Translates a predicate, whose text nobody has counted.
std::string SmtTranslator::open_predicate(const Term& term, const SmtScope& scope) {
  const auto part = [&](std::size_t i) { return predicate(term->children[i], scope); };
  switch (term->kind) {
    case Kind::truth:
      return "true";
    case Kind::falsity:
      return "false";
    case Kind::negation:
      return smt_not(part(0));
    case Kind::conjunction:
      return smt_all({part(0), part(1)});
    case Kind::disjunction:
      return smt_any({part(0), part(1)});
    case Kind::implication:
      return smt_any({smt_not(part(0)), part(1)});
    case Kind::equivalence:
      return smt_call("=", {part(0), part(1)});
    case Kind::forall:
    case Kind::exists:
      return quantified(term, scope);
    case Kind::exists_one:
      return exists_one(term, scope);
    case Kind::relation:
      return is_closed(term, scope) ? closed_relation(term, scope) : relation(term, scope);
    case Kind::let: {
      SmtScope inner{&scope};
      let(*term->text, scope, inner);
      return predicate(term->children[0], inner);
    }
    default:
      return schema(term, scope);
  }
}

std::string SmtTranslator::quantified(const Term& term, const SmtScope& scope) {
  const bool some = term->kind == Kind::exists;
  std::vector<std::string> cases;
  each_case(listing(*term->text, scope, false), scope, [&](const SmtScope& inner, const SmtBound& bound) {
    const std::string head = smt_all(bound.conditions), body = predicate(term->children[0], inner);
    cases.push_back(some ? smt_quantified("exists", bound.symbols, smt_all({head, body}))
                         : smt_quantified("forall", bound.symbols, smt_implied(head, body)));
  });
  return some ? smt_any(cases) : smt_all(cases);
}

/// ∃₁ x • P is ∃ x • P ∧ (∀ y • P[y/x] ⇒ y = x).
std::string SmtTranslator::exists_one(const Term& term, const SmtScope& scope) {
  if (auto written_out = exactly_one(term, scope)) return *std::move(written_out);
  const TemporaryCount inside(quantifiers_, quantifiers_ + 1);
  SmtScope one{&scope}, other{&scope};
  const SmtBound first = bind(*term->text, scope, one), second = bind(*term->text, scope, other);
  const std::string here = smt_all({smt_all(first.conditions), predicate(term->children[0], one)});
  const std::string there = smt_all({smt_all(second.conditions), predicate(term->children[0], other)});
  std::vector<std::string> equal;
  for (std::size_t i = 0; i < first.variables.size(); ++i)
    equal.push_back(smt_equal(first.variables[i].second, second.variables[i].second));
  const std::string only = smt_quantified("forall", second.symbols, smt_implied(there, smt_all(equal)));
  return smt_quantified("exists", first.symbols, smt_all({here, only}));
}

/// A schema holds where the names in scope are in the sets of its components and satisfy its predicates.
std::string SmtTranslator::schema(const Term& term, const SmtScope& scope) {
  count();
  const SchemaText text = schema_text(term);
  SmtScope inner{&global_};
  std::vector<std::string> facts;
  for (const Declaration& each : text.declarations)
    for (const Name& name : each.names) {
      const SmtMeaning* meaning = find(name, scope);
      if (!meaning || (!meaning->term && !meaning->value))
        refuse(term, "has the component " + name.text() + ", which is no variable here");
      const SmtTerm component = meaning->term ? *meaning->term : of_value(*meaning->value);
      inner.names[name].term = component;
      const SmtMembership in = member(component, each.term, global_);
      facts.push_back(smt_all({component.defined, in.defined, in.holds}));
    }
  for (const Predicate& each : text.predicates) facts.push_back(predicate(each.term, inner));
  return smt_all(facts);
}

/// A relation without variables is evaluated, as far as the evaluator decides it.
std::string SmtTranslator::closed_relation(const Term& term, const SmtScope& scope) {
  try {
    const Truth here = evaluator_.holds(term, known_values(scope));
    if (here != Truth::open) return here == Truth::yes ? "true" : "false";
  } catch (const EvaluationError&) {  // its parts may have values
  }
  return relation(term, scope);
}

std::string SmtTranslator::relation(const Term& term, const SmtScope& scope) {
  if (term->children.size() == 1 && term->names.size() == 1 && term->names[0].text() == "disjoint_") {
    const SmtTerm family = as_slots(expression(term->children[0], scope));
    return smt_all({family.defined, slots_are_disjoint(family)});
  }
  if (term->children.size() < 2) refuse(term, "is no comparison");
  std::vector<std::string> links;
  for (std::size_t i = 0; i < term->names.size(); ++i)
    links.push_back(related(term->names[i].text(), term->children[i], term->children[i + 1], scope));
  return smt_all(links);
}

/// A set without members is one of a comprehension that no values satisfy.
std::optional<std::string> SmtTranslator::emptiness(const Term& a, const Term& b, const SmtScope& scope) {
  const Term* set = match::comprehension_beside_empty(
      a, b, [&](const Name& name) { return !find(name, scope) && !definitions_.find(name); });
  if (!set) return std::nullopt;
  const SmtListing list = listing(*(*set)->text, scope, false);
  if (!list.sets.empty() && list.is_whole()) return std::nullopt;  // it is a set of few members
  std::vector<std::string> cases;
  each_case(list, scope, [&](const SmtScope& inner, const SmtBound& bound) {
    std::vector<std::string> facts = bound.conditions;
    if (!(*set)->children.empty()) facts.push_back(expression((*set)->children[0], inner).defined);
    cases.push_back(smt_quantified("exists", bound.symbols, smt_all(facts)));
  });
  return smt_not(smt_any(cases));
}

/// No relation holds of operands without values.
std::string SmtTranslator::related(const std::string& by, const Term& a, const Term& b, const SmtScope& scope) {
  if (by == "_∈_" || by == "_∉_") {
    const SmtTerm element = expression(a, scope);
    const SmtMembership in = member(element, b, scope);
    return smt_all({element.defined, in.defined, by == "_∈_" ? in.holds : smt_not(in.holds)});
  }
  const bool equal = by == "_=_", unequal = by == "_≠_";
  if (equal || unequal)
    if (const auto empty = emptiness(a, b, scope)) return equal ? *empty : smt_not(*empty);
  if (auto of_sets = set_relation(by, a, b, scope)) return *std::move(of_sets);
  static const std::map<std::string, std::string> orders = {{"_<_", "<"}, {"_≤_", "<="}, {"_>_", ">"}, {"_≥_", ">="}};
  const auto order = orders.find(by);
  if (!equal && !unequal && order == orders.end()) throw Untranslated("the relation " + by + " is not translated");
  SmtTerm left = expression(a, scope), right = expression(b, scope);
  if (equal || unequal) {
    const std::string same = smt_equal(left, right);
    return smt_all({left.defined, right.defined, equal ? same : smt_not(same)});
  }
  bring_together(left, right);
  return smt_all({left.defined, right.defined, smt_call(order->second, {left.text, right.text})});
}

}  // namespace durero::zed
