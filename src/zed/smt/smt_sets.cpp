/// Translates memberships.

#include <algorithm>

#include "zed/evaluate/describe.hpp"
#include "zed/smt/smt_slots.hpp"
#include "zed/smt/smt_translator.hpp"
#include "zed/smt/smt_values.hpp"
#include "zed/syntax/match.hpp"

namespace durero::zed {
namespace {

SmtMembership in_all(const SmtMembership& a, const SmtMembership& b) {
  return {smt_all({a.holds, b.holds}), smt_all({a.defined, b.defined})};
}

/// x ∈ S of a set of whole numbers: those that `bounds` says of it, beside being whole.
SmtMembership whole_number(const SmtTerm& element, const std::function<std::string(const std::string&)>& bounds) {
  const SmtTerm whole = as_integer(element);
  const std::string is_whole = element.sort == SmtSort::real ? smt_call("is_int", {element.text}) : std::string("true");
  return {smt_all({is_whole, bounds(whole.text)})};
}

}  // namespace

SmtMembership SmtTranslator::member(const SmtTerm& element, const Term& set, const SmtScope& scope) {
  count();
  if (const Term* of = abbreviated(set, scope)) return member(element, *of, global_);
  if (auto in = in_toolkit_set(element, set, scope)) return std::move(*in);
  if (auto in = in_family(element, set, scope)) return std::move(*in);
  switch (set->kind) {
    case Kind::set_extension: {
      std::vector<std::string> one, defined;
      for (const Term& each : set->children) {
        const SmtTerm other = expression(each, scope);
        one.push_back(smt_equal(element, other));
        defined.push_back(other.defined);
      }
      return {smt_any(one), smt_all(defined)};
    }
    case Kind::product: {
      if (element.parts.size() != set->children.size()) refuse(set, "is asked of what is no such tuple");
      SmtMembership in;
      for (std::size_t i = 0; i < element.parts.size(); ++i)
        in = in_all(in, member(element.parts[i], set->children[i], scope));
      return in;
    }
    case Kind::comprehension:
      return in_comprehension(element, set, scope);
    case Kind::reference:
    case Kind::application:
    case Kind::selection:
    case Kind::tuple_selection:
    case Kind::conditional:
    case Kind::lambda:
    case Kind::let:
      return in_value(element, set, scope);
    case Kind::schema_text:
    case Kind::decoration:
      return in_schema(element, set);
    default:
      refuse(set, "is not translated");
  }
}

std::optional<SmtMembership> SmtTranslator::in_toolkit_set(const SmtTerm& element, const Term& set,
                                                           const SmtScope& scope) {
  const auto at_least = [](const std::string& least) {
    return [least](const std::string& x) {
      return smt_constant(x) ? smt_compare("<=", least, x) : smt_call(">=", {x, least});
    };
  };
  if (is_toolkit(set, scope)) {
    const std::string word = set->name.text();
    if (word == "𝔸") return SmtMembership{};
    if (word == "ℤ") return whole_number(element, [](const std::string&) { return std::string("true"); });
    if (word == "ℕ") return whole_number(element, at_least("0"));
    if (word == "ℕ₁") return whole_number(element, at_least("1"));
    if (word == "ℤ₁")
      return whole_number(element, [](const std::string& x) {
        return smt_not(smt_equal({SmtSort::integer, x}, {SmtSort::integer, "0"}));
      });
    return std::nullopt;
  }
  const Node* application = match::application_of_name(set);
  if (!application || !is_toolkit(application->children[0], scope)) return std::nullopt;
  const Term& argument = application->children[1];
  const std::string by = application->children[0]->name.text();
  if (argument->kind != Kind::tuple || argument->children.size() != 2) return std::nullopt;
  const Term &a = argument->children[0], &b = argument->children[1];
  if (by == "_‥_") {
    const SmtTerm from = as_integer(expression(a, scope)), to = as_integer(expression(b, scope));
    SmtMembership in = whole_number(element, [&](const std::string& x) {
      return smt_all({smt_compare("<=", from.text, x), smt_compare("<=", x, to.text)});
    });
    in.defined = smt_all({from.defined, to.defined});
    return in;
  }
  if (by != "_∪_" && by != "_∩_" && by != "_∖_") return std::nullopt;
  const SmtMembership left = member(element, a, scope), right = member(element, b, scope);
  SmtMembership in = in_all(left, right);
  if (by == "_∪_") in.holds = smt_any({left.holds, right.holds});
  if (by == "_∖_") in.holds = smt_all({left.holds, smt_not(right.holds)});
  return in;
}

SmtMembership SmtTranslator::in_comprehension(const SmtTerm& element, const Term& set, const SmtScope& scope) {
  SmtScope inner{&scope};
  if (!set->children.empty()) {
    const SmtListing list = listing(*set->text, scope, false);
    if (!list.sets.empty() && list.is_whole()) {
      const SmtTerm slots = comprehension(set, scope);
      return {in_slots(element, slots), slots.defined};
    }
    std::vector<std::string> cases;
    each_case(list, scope, [&](const SmtScope& here, const SmtBound& bound) {
      const SmtTerm made = expression(set->children[0], here);
      const std::string facts = smt_all({smt_all(bound.conditions), made.defined, smt_equal(element, made)});
      cases.push_back(smt_quantified("exists", bound.symbols, facts));
    });
    return {smt_any(cases)};
  }
  std::vector<std::pair<Name, Term>> declared;
  for (const Declaration& each : set->text->declarations) {
    if (each.form != Declaration::Form::typed) refuse(set, "is not translated");
    for (const Name& name : each.names) declared.emplace_back(name, each.term);
  }
  if (declared.size() != 1 && element.parts.size() != declared.size()) refuse(set, "is asked of what is no such tuple");
  std::vector<std::string> facts;
  for (std::size_t i = 0; i < declared.size(); ++i) {
    const SmtTerm& part = declared.size() == 1 ? element : element.parts[i];
    const SmtMembership in = member(part, declared[i].second, scope);
    facts.push_back(smt_all({in.defined, in.holds}));
    inner.names[declared[i].first].term = part;
  }
  for (const Predicate& each : set->text->predicates) facts.push_back(predicate(each.term, inner));
  return {smt_all(facts)};
}

SmtMembership SmtTranslator::in_schema(const SmtTerm& element, const Term& set) {
  if (element.sort != SmtSort::binding) refuse(set, "is asked of what is no binding");
  SmtScope components;
  for (std::size_t i = 0; i < element.names.size(); ++i) components.names[element.names[i]].term = element.parts[i];
  return {schema(set, components)};
}

/// Membership in a given set, a free type, a schema, or a set whose members the evaluator lists.
SmtMembership SmtTranslator::in_value(const SmtTerm& element, const Term& set, const SmtScope& scope) {
  const bool global = set->kind == Kind::reference && !find(set->name, scope);
  const Meaning* meaning = global ? definitions_.find(set->name) : nullptr;
  if (meaning && meaning->kind == Meaning::Kind::schema) return in_schema(element, set);
  if (meaning && (meaning->kind == Meaning::Kind::given || meaning->kind == Meaning::Kind::free_type)) {
    const std::string last = std::to_string(members(set->name.text()).size());
    if (element.sort != SmtSort::atom) refuse(set, "is asked of what is none of its members");
    return {smt_all({smt_compare("<=", "0", element.text), smt_compare("<", element.text, last)})};
  }
  if (!is_closed(set, scope)) {
    const SmtTerm slots = as_slots(expression(set, scope));
    return {in_slots(element, slots), slots.defined};
  }
  const Value all = value(set, scope);
  if (all.is_undefined()) return {"false", "false"};
  if (is_all_numbers(all)) return {};
  std::vector<std::string> one;
  for (const Value& each : few_members(all, set)) one.push_back(smt_equal(element, of_value(each)));
  return {smt_any(one)};
}

}  // namespace durero::zed
