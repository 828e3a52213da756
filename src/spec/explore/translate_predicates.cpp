/// Translates predicates and schema texts.
#include <algorithm>

#include "durero/zed/syntax/parser.hpp"
#include "search_plan.hpp"
#include "toolkit_operators.hpp"
#include "translator.hpp"

namespace durero::spec {

using zed::Kind;
using zed::Name;
using zed::Node;
using zed::Term;

TermTranslator::Translated<IdTest> TermTranslator::predicate_read(const Term& term, const FrameScope& scope) {
  return with_reads([&] { return predicate(term, scope); });
}

/// A predicate that is not translated, or cannot be decided here, is the evaluator's.
IdTest TermTranslator::predicate(const Term& term, const FrameScope& scope) {
  parts_.watch.count();
  IdTest test;
  try {
    test = translated_test(term, scope);
  } catch (const std::runtime_error&) {  // it is not served here, or a name in it has no value
    return asked_truth(term, scope);
  }
  IdTest asked = asked_truth(term, scope);
  return [test = std::move(test), asked = std::move(asked)](IdFrame frame) {
    try {
      return test(frame);
    } catch (const NotInterned&) {
      return asked(frame);
    }
  };
}

IdTest TermTranslator::translated_test(const Term& term, const FrameScope& scope) {
  const Node& node = *term;
  const auto part = [&](std::size_t i) { return predicate(node.children[i], scope); };
  switch (node.kind) {
    case Kind::truth:
      return [](IdFrame) { return true; };
    case Kind::falsity:
      return [](IdFrame) { return false; };
    case Kind::negation:
      return [a = part(0)](IdFrame frame) { return !a(frame); };
    case Kind::conjunction:
      return [a = part(0), b = part(1)](IdFrame frame) { return a(frame) && b(frame); };
    case Kind::disjunction:
      return [a = part(0), b = part(1)](IdFrame frame) { return a(frame) || b(frame); };
    case Kind::implication:
      return [a = part(0), b = part(1)](IdFrame frame) { return !a(frame) || b(frame); };
    case Kind::equivalence:
      return [a = part(0), b = part(1)](IdFrame frame) { return a(frame) == b(frame); };
    case Kind::relation:
      return relation(node, scope);
    case Kind::forall:
    case Kind::exists:
      return quantified(node, scope);
    case Kind::exists_one:  // as a schema it would be made of itself
      throw NotInterned("∃₁ is the evaluator's");
    case Kind::let: {
      FrameScope inner{&scope};
      std::vector<std::pair<unsigned, IdCode>> given;
      for (const zed::Declaration& declaration : node.text->declarations) {
        given.emplace_back(place(), expression(declaration.term, scope));
        inner.places[declaration.names.at(0)] = given.back().first;
      }
      return [given, body = predicate(node.children[0], inner)](IdFrame frame) {
        for (const auto& [at, code] : given) frame[at] = code(frame);
        return body(frame);
      };
    }
    case Kind::reference:
    case Kind::number:
    case Kind::set_extension:
    case Kind::comprehension:
    case Kind::tuple:
    case Kind::product:
    case Kind::power:
    case Kind::selection:
    case Kind::tuple_selection:
    case Kind::binding_extension:
    case Kind::theta:
    case Kind::application:
    case Kind::lambda:
    case Kind::mu:
    case Kind::conditional:
    case Kind::schema_text:
    case Kind::decoration:
    case Kind::renaming:
    case Kind::hiding:
    case Kind::composition:
    case Kind::piping:
    case Kind::projection:
    case Kind::precondition:
      break;
  }
  return schema_test(term, scope);
}

IdTest TermTranslator::relation(const Node& node, const FrameScope& scope) {
  if (node.children.size() < 2) throw NotInterned("a relation of one operand is the evaluator's");
  std::vector<IdTest> links;
  for (std::size_t i = 0; i < node.names.size(); ++i)
    links.push_back(link(node.names[i].text(), node.children[i], node.children[i + 1], scope));
  if (links.size() == 1) return links[0];
  return [links](IdFrame frame) {
    return std::all_of(links.begin(), links.end(), [&](const IdTest& holds) { return holds(frame); });
  };
}

IdTest TermTranslator::link(const std::string& word, const Term& left, const Term& right, const FrameScope& scope) {
  const bool member = word == "_∈_";
  if (member || word == "_∉_")
    return [value = expression(left, scope), set = domain(right, scope), member](IdFrame frame) {
      const ValueId of = value(frame);
      return of != 0 && set->has(of, frame) == member;
    };
  const BinaryRelation holds = is_global(Name{word, ""}) ? nullptr : binary_relation(word);
  if (!holds) throw NotInterned(word + " is the evaluator's");
  return [&values = values_, holds, a = expression(left, scope), b = expression(right, scope)](IdFrame frame) {
    const ValueId x = a(frame), y = b(frame);
    return x != 0 && y != 0 && holds(values, x, y);
  };
}

IdTest TermTranslator::quantified(const Node& node, const FrameScope& scope) {
  SoughtNames sought = this->sought(*node.text, scope);
  if (node.kind == Kind::exists) {
    add_facts(sought.facts, node.children[0]);
    const auto plan = planned_search(*this, sought);
    return [plan](IdFrame frame) { return !plan->each(frame, [] { return false; }); };
  }
  const auto plan = planned_search(*this, sought);
  return [plan, body = predicate(node.children[0], sought.scope)](IdFrame frame) {
    return plan->each(frame, [&] { return body(frame); });
  };
}

IdTest TermTranslator::schema_test(const Term& term, const FrameScope& scope) {
  const auto text = flat(term);
  if (!text) throw NotInterned("a predicate is the evaluator's");
  std::vector<Term> facts;
  add_facts(facts, term);
  std::vector<IdTest> tests;
  for (const Term& fact : facts) tests.push_back(predicate(fact, scope));
  return [tests](IdFrame frame) {
    return std::all_of(tests.begin(), tests.end(), [&](const IdTest& holds) { return holds(frame); });
  };
}

namespace {

bool may_be_schema(Kind kind) {
  switch (kind) {
    case Kind::reference:
    case Kind::schema_text:
    case Kind::decoration:
    case Kind::renaming:
    case Kind::hiding:
    case Kind::composition:
    case Kind::piping:
    case Kind::projection:
    case Kind::precondition:
      return true;
    case Kind::number:
    case Kind::set_extension:
    case Kind::comprehension:
    case Kind::tuple:
    case Kind::product:
    case Kind::power:
    case Kind::selection:
    case Kind::tuple_selection:
    case Kind::binding_extension:
    case Kind::theta:
    case Kind::application:
    case Kind::lambda:
    case Kind::mu:
    case Kind::let:
    case Kind::conditional:
    case Kind::negation:
    case Kind::conjunction:
    case Kind::disjunction:
    case Kind::implication:
    case Kind::equivalence:
    case Kind::forall:
    case Kind::exists:
    case Kind::exists_one:
    case Kind::truth:
    case Kind::falsity:
    case Kind::relation:
      break;
  }
  return false;
}

}  // namespace

Term member_of(const Name& name, const Term& set) {
  return zed::relation({{"_∈_", {}}}, {zed::reference(name, {}, set->place), set}, set->place);
}

bool TermTranslator::names_no_schema(const Name& name) const {
  const auto at = globals_.find(name);
  if (at == globals_.end()) return !name.word.starts_with("Δ") && !name.word.starts_with("Ξ");
  const zed::Global* global = parts_.typing.find(Machine::Parts::section_name, name);
  return !global || !global->scheme.type.is_schema_set() || std::holds_alternative<zed::Axiomatic>(at->second->form);
}

std::shared_ptr<const zed::SchemaText> TermTranslator::flat(const Term& schema) {
  if (schema->kind != Kind::reference || !schema->children.empty()) return flat_anew(schema);
  if (names_no_schema(schema->name)) return nullptr;
  const auto at = flat_.find(schema->name);
  return at != flat_.end() ? at->second : flat_.emplace(schema->name, flat_anew(schema)).first->second;
}

std::shared_ptr<const zed::SchemaText> TermTranslator::flat_anew(const Term& schema) {
  const auto type_of = [&]() -> std::optional<zed::Type> {
    if (schema->kind == Kind::reference)
      if (const zed::Global* global = parts_.typing.find(Machine::Parts::section_name, schema->name))
        return global->scheme.type;
    return parts_.typing.type_of(schema);
  };
  const auto carrier = [&](const Name& component) {
    const auto type = type_of();
    const zed::Type* of = type && type->is_schema_set() ? type->parts()[0].field(component) : nullptr;
    return of && of->is_known() ? zed::parse_unicode(of->settled().text(zed::Type::max_size)) : Term();
  };
  const auto text = unfolder_.unfolded(schema, carrier);
  return text ? (*text)->text : nullptr;
}

void TermTranslator::add_facts(std::vector<Term>& facts, const Term& fact) {
  const Node& node = *fact;
  const auto negated = [](const Term& term) { return zed::node(Kind::negation, {term}, term->place); };
  if (node.kind == Kind::truth) return;
  if (node.kind == Kind::conjunction) {
    for (const Term& child : node.children) add_facts(facts, child);
    return;
  }
  if (node.kind == Kind::relation && node.names.size() > 1) {
    for (std::size_t i = 0; i < node.names.size(); ++i)
      facts.push_back(
          zed::relation({node.names[i]}, {node.children[i], node.children[i + 1]}, node.children[i]->place));
    return;
  }
  if (node.kind == Kind::negation) {
    const Node& of = *node.children[0];
    if (of.kind == Kind::negation) return add_facts(facts, of.children[0]);
    if (of.kind == Kind::disjunction) {
      for (const Term& child : of.children) add_facts(facts, negated(child));
      return;
    }
    if (of.kind == Kind::implication) {
      add_facts(facts, of.children[0]);
      return add_facts(facts, negated(of.children[1]));
    }
  }
  const auto schema = may_be_schema(node.kind) ? flat(fact) : nullptr;
  if (!schema) return facts.push_back(fact);
  add_facts(facts, *schema);
}

void TermTranslator::add_facts(std::vector<Term>& facts, const zed::SchemaText& text) {
  for (const zed::Declaration& declaration : text.declarations)
    for (const Name& name : declaration.names) facts.push_back(member_of(name, declaration.term));
  for (const zed::Predicate& predicate : text.predicates) add_facts(facts, predicate.term);
}

SoughtNames TermTranslator::sought(const zed::SchemaText& text, const FrameScope& scope) {
  SoughtNames all{{}, {}, {}, FrameScope{&scope, {}}};
  const auto declare = [&](const Name& name, const Term& set, const FrameScope& of_set) {
    if (all.scope.places.contains(name)) return all.facts.push_back(member_of(name, set));
    const unsigned at = place();
    all.variables.emplace_back(at, set ? domain(set, of_set) : nullptr);
    all.names.emplace_back(name, at);
    all.scope.places.emplace(name, at);
  };
  const FrameScope nothing;
  for (const zed::Declaration& declaration : text.declarations) {
    if (declaration.form == zed::Declaration::Form::included) {
      const auto schema = flat(declaration.term);
      if (!schema) throw NotInterned("a schema is not written out");
      for (const zed::Declaration& each : schema->declarations)
        for (const Name& name : each.names) declare(name, each.term, nothing);
      for (const zed::Predicate& predicate : schema->predicates) add_facts(all.facts, predicate.term);
      continue;
    }
    const bool defined = declaration.form == zed::Declaration::Form::defined;
    for (const Name& name : declaration.names) declare(name, defined ? Term() : declaration.term, scope);
    if (defined)
      all.facts.push_back(
          zed::relation({{"_=_", {}}}, {zed::reference(declaration.names.at(0)), declaration.term}, declaration.place));
  }
  for (const zed::Predicate& predicate : text.predicates) add_facts(all.facts, predicate.term);
  return all;
}

}  // namespace durero::spec
