#include "zed/smt/smt_script.hpp"

#include <algorithm>

#include "zed/syntax/match.hpp"
#include "zed/value/small_members.hpp"

namespace durero::zed {
Term SmtSought::claim() const {
  Term claim = node(Kind::truth, {});
  const auto add = [&](const Term& term) {
    claim = claim->kind == Kind::truth ? term : node(Kind::conjunction, {claim, term}, term->place);
  };
  for (const Declaration& each : text.declarations) {
    if (each.form == Declaration::Form::included) add(each.term);
    const Name by{each.form == Declaration::Form::typed ? "_∈_" : "_=_", ""};
    for (const Name& name : each.names) add(relation({by}, {reference(name), each.term}, each.place));
  }
  for (const Predicate& each : text.predicates) add(each.term);
  add(body);
  return claim;
}

SmtSought sought_in(const Term& quantified) {
  const SchemaText& text = *quantified->text;
  const Term& body = quantified->children[0];
  if (quantified->kind == Kind::exists) return {text, body, "witness", Truth::yes};
  if (quantified->kind == Kind::exists_one) return {text, body, "two witnesses", Truth::no, 2};
  return {text, node(Kind::negation, {body}, body->place), "counter-example", Truth::no};
}

std::optional<SmtSought> sought_in_emptiness(const Term& relation, const Definitions& definitions) {
  if (!match::is_equation(relation) && !match::is_relation(relation, "_≠_")) return std::nullopt;
  const Term* set = match::comprehension_beside_empty(relation->children[0], relation->children[1],
                                                      [&](const Name& name) { return !definitions.find(name); });
  if (!set) return std::nullopt;
  Term last = node(Kind::truth, {});
  if (!(*set)->children.empty()) {  // the term has a value: it equals itself
    const Term& term = (*set)->children[0];
    last = zed::relation({{"_=_", ""}}, {term, term}, term->place);
  }
  return SmtSought{*(*set)->text, last, "member", Truth::no};
}

std::string SmtScript::text(const SmtSought& sought, const Valuation& locals) {
  SmtScope known;
  for (const auto& [name, value] : locals) known.names[name].value = value;
  std::vector<std::string> facts, differ;
  std::string symbols, declared;
  for (unsigned time = 0; time < sought.times; ++time) {
    SmtScope inner{&known};
    bound_.push_back(translator_.bind(sought.text, known, inner));
    for (const std::string& each : bound_.back().conditions) facts.push_back(each);
    facts.push_back(translator_.predicate(sought.body, inner));
    for (const SmtSymbol& each : bound_.back().symbols) {
      declared += smt_call("declare-fun", {each.name, "()", each.sort}) + "\n";
      symbols += (symbols.empty() ? "" : " ") + each.name;
    }
  }
  if (symbols.empty()) throw Untranslated("no variable is sought");
  if (sought.times == 2) {
    for (std::size_t i = 0; i < bound_[0].variables.size(); ++i)
      differ.push_back(smt_not(smt_equal(bound_[0].variables[i].second, bound_[1].variables[i].second)));
    facts.push_back(smt_any(differ));
  }
  std::string script = "(set-option :produce-models true)\n(set-logic ALL)\n" + declared + translator_.shared_texts();
  for (const std::string& fact : facts)
    if (fact != "true") script += smt_call("assert", {fact}) + "\n";
  return script + "(check-sat)\n(get-value (" + symbols + "))\n(exit)\n";
}

/// The set of the members that are present. What is declared as a sequence is written as one.
std::optional<Value> SmtScript::set_value(const SmtTerm& variable, const SmtVerdict& verdict) {
  std::vector<Value> members, items;
  for (std::size_t i = 0; i < variable.parts.size(); ++i) {
    const auto found = verdict.values.find(variable.present[i]);
    const std::string& present = found == verdict.values.end() ? variable.present[i] : found->second.word;
    if (present != "true" && present != "false") return std::nullopt;
    if (present == "false") continue;
    auto member = value(variable.parts[i], verdict);
    if (!member) return std::nullopt;
    if (variable.sequence && items.size() == i) items.push_back(member->tuple()->parts[1]);
    members.push_back(std::move(*member));
  }
  return variable.sequence && items.size() == members.size() ? sequence_of(items) : Value::set(std::move(members));
}

std::optional<Value> SmtScript::value(const SmtTerm& variable, const SmtVerdict& verdict) {
  if (variable.sort == SmtSort::set) return set_value(variable, verdict);
  if (auto known = translator_.constant(variable)) return known;
  if (variable.sort == SmtSort::tuple || variable.sort == SmtSort::binding) {
    std::vector<Value> parts;
    for (const SmtTerm& each : variable.parts) {
      auto part = value(each, verdict);
      if (!part) return std::nullopt;
      parts.push_back(std::move(*part));
    }
    if (variable.sort == SmtSort::tuple) return Value::tuple(std::move(parts));
    return Value::binding(signature(variable.names), std::move(parts));
  }
  const auto found = verdict.values.find(variable.text);
  const auto number = found == verdict.values.end() ? std::nullopt : number_of(found->second);
  if (!number) return std::nullopt;
  if (variable.sort == SmtSort::real) return Value(*number);
  if (!number->is_integer()) return std::nullopt;
  if (variable.sort == SmtSort::integer) return Value(*number);
  const std::vector<Value>& members = translator_.members(variable.type);
  for (std::size_t i = 0; i < members.size(); ++i)
    if (*number == Real(static_cast<int>(i))) return members[i];
  return std::nullopt;
}

std::string SmtScript::bounds() const {
  if (!translator_.is_bounded()) return "";
  return "whose sets have at most " + std::to_string(SmtTranslator::most_slots) + " members";
}

std::optional<std::vector<Valuation>> SmtScript::values(const SmtVerdict& verdict) {
  std::vector<Valuation> found;
  for (const SmtBound& bound : bound_) {
    Valuation& values = found.emplace_back(bound.known);
    for (const auto& [name, variable] : bound.variables) {
      auto each = value(variable, verdict);
      if (!each) return std::nullopt;
      values.emplace_back(name, std::move(*each));
    }
  }
  return found;
}

}  // namespace durero::zed
