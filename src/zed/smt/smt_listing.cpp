/// Variables that range over slots are written out: each choice of them is a case of its own, without a quantifier.

#include <algorithm>
#include <set>

#include "zed/evaluate/describe.hpp"
#include "zed/smt/smt_slots.hpp"
#include "zed/smt/smt_translator.hpp"
#include "zed/smt/smt_values.hpp"
#include "zed/syntax/match.hpp"

namespace durero::zed {
namespace {

constexpr std::size_t most_of_quantifier = 16;   // members of a set without variables that a quantifier writes out
constexpr std::size_t most_of_set = 256;         // members of a set without variables that makes another set
constexpr std::size_t most_cases = 1024;         // of all quantifiers around a predicate together
constexpr std::size_t most_cases_of_set = 2048;  // of one set
constexpr std::size_t most_cases_of_one = 64;    // of ∃₁, whose cases are compared two by two

bool has_set(const SmtTerm& term) {
  if (term.sort == SmtSort::set) return true;
  for (const SmtTerm& part : term.parts)
    if (has_set(part)) return true;
  return false;
}

/// Says whether each name is declared once, by itself, and from what names none of them.
bool declares_apart(const SchemaText& text) {
  std::set<Name> names;
  for (const Declaration& each : text.declarations) {
    if (each.form == Declaration::Form::included) return false;
    for (const Name& name : each.names)
      if (!names.insert(name).second) return false;
  }
  for (const Declaration& each : text.declarations)
    if (match::mentions(each.term, names)) return false;
  return true;
}

}  // namespace

bool SmtListing::is_whole() const {
  for (const Declaration& each : rest.declarations)
    if (each.form != Declaration::Form::defined) return false;
  return true;
}

/// Says whether a term mentions a variable that is a set, or has one as its part.
bool SmtTranslator::mentions_set(const Term& term, const SmtScope& scope) const {
  bool found = false;
  match::each_name(term, [&](const Name& name) {
    const SmtMeaning* meaning = find(name, scope);
    if (meaning && meaning->term) found = found || has_set(*meaning->term);
    if (meaning && meaning->lambda) found = found || mentions_set(meaning->lambda, *meaning->scope);
  });
  return found;
}

std::optional<Value> SmtTranslator::constant(const SmtTerm& term) {
  if (term.defined != "true") return std::nullopt;
  std::vector<Value> parts;
  for (std::size_t i = 0; i < term.parts.size(); ++i) {
    if (term.sort == SmtSort::set && term.present[i] == "false") continue;
    if (term.sort == SmtSort::set && term.present[i] != "true") return std::nullopt;
    auto part = constant(term.parts[i]);
    if (!part) return std::nullopt;
    parts.push_back(std::move(*part));
  }
  if (term.sort == SmtSort::set) return Value::set(std::move(parts));
  if (term.sort == SmtSort::tuple) return Value::tuple(std::move(parts));
  if (term.sort == SmtSort::binding) return Value::binding(signature(term.names), std::move(parts));
  const auto number = smt_constant(term.text);
  if (!number) return std::nullopt;
  if (term.sort != SmtSort::atom) return Value(*number);
  const std::vector<Value>& all = members(term.type);
  for (std::size_t i = 0; i < all.size(); ++i)
    if (*number == Real(static_cast<int>(i))) return all[i];
  return std::nullopt;
}

/// Returns the members of a set without variables, if they are so few at most.
std::optional<std::vector<SmtTerm>> SmtTranslator::listed(const Term& set, const SmtScope& scope, std::size_t most) {
  if (const Term* of = abbreviated(set, scope)) return listed(*of, global_, most);
  if (!is_closed(set, scope)) return std::nullopt;
  if (set->kind == Kind::product) return listed_product(set, scope, most);
  const Meaning* meaning =
      set->kind == Kind::reference && !find(set->name, scope) ? definitions_.find(set->name) : nullptr;
  if (meaning && meaning->kind == Meaning::Kind::schema) return std::nullopt;
  std::vector<SmtTerm> made;
  try {
    if (meaning && (meaning->kind == Meaning::Kind::given || meaning->kind == Meaning::Kind::free_type)) {
      const std::string name = set->name.text();
      const std::size_t size = members(name).size();
      for (std::size_t i = 0; i < size; ++i) made.push_back({SmtSort::atom, std::to_string(i), "true", name});
      return made.size() > most ? std::nullopt : std::optional(std::move(made));
    }
    const Value all = value(set, scope);
    const auto* few = members_up_to(all, most);
    if (!few) return std::nullopt;
    for (const Value& each : *few) made.push_back(of_value(each));
  } catch (const Untranslated&) {
    return std::nullopt;
  } catch (const EvaluationError&) {
    return std::nullopt;
  }
  return made;
}

std::optional<std::vector<SmtTerm>> SmtTranslator::listed_product(const Term& set, const SmtScope& scope,
                                                                  std::size_t most) {
  std::vector<SmtTerm> made = {SmtTerm{SmtSort::tuple}};
  for (const Term& each : set->children) {
    const auto factor = listed(each, scope, most);
    if (!factor || made.size() * factor->size() > most) return std::nullopt;
    std::vector<SmtTerm> longer;
    for (const SmtTerm& tuple : made)
      for (const SmtTerm& part : *factor) {
        longer.push_back(tuple);
        longer.back().parts.push_back(part);
      }
    made = std::move(longer);
  }
  return made;
}

/// Returns a set that is written out: one that depends on a set variable, or one of few members. `any_set` asks for any
/// other too.
std::optional<SmtTerm> SmtTranslator::slots_of(const Term& set, const SmtScope& scope, bool any_set) {
  if (const Term* of = abbreviated(set, scope)) return slots_of(*of, global_, any_set);
  const bool closed = is_closed(set, scope);
  if (closed) {
    const bool is_text = set->kind == Kind::comprehension || set->kind == Kind::schema_text;
    const auto all =
        is_text && !any_set ? std::nullopt : listed(set, scope, any_set ? most_of_set : most_of_quantifier);
    if (!all) return std::nullopt;
    SmtTerm made{SmtSort::set};
    for (const SmtTerm& each : *all) add_slot(made, each, "true");
    return made;
  }
  if (!any_set && !mentions_set(set, scope)) return std::nullopt;
  try {
    return as_slots(expression(set, scope));
  } catch (const Untranslated&) {
    return std::nullopt;
  }
}

/// Chooses the variables of a schema text that are written out, as far as there are not too many cases.
SmtListing SmtTranslator::listing(const SchemaText& text, const SmtScope& scope, bool any_set) {
  SmtListing made;
  made.rest = text;
  if (!declares_apart(text)) return made;
  made.rest.declarations.clear();
  const std::size_t most = any_set ? most_cases_of_set : most_cases / expansion_;
  for (const Declaration& each : text.declarations) {
    const auto slots = each.form == Declaration::Form::typed ? slots_of(each.term, scope, any_set) : std::nullopt;
    std::size_t cases = made.cases;
    for (std::size_t i = 0; slots && i < each.names.size() && cases <= most; ++i) cases *= slots->parts.size();
    if (!slots || cases > most) {
      made.rest.declarations.push_back(each);
      continue;
    }
    made.cases = cases;
    for (const Name& name : each.names) made.sets.emplace_back(name, *slots);
  }
  return made;
}

/// Tells each case, unless its conditions never hold. What a listing leaves over is bound by symbols.
void SmtTranslator::each_case(const SmtListing& listing, const SmtScope& scope, const EachCase& each) {
  const TemporaryCount cases(expansion_, expansion_ * std::max<std::size_t>(listing.cases, 1));
  const TemporaryCount inside(quantifiers_, quantifiers_ + (listing.is_whole() ? 0 : 1));
  for (std::size_t n = 0; n < listing.cases; ++n) {
    SmtScope chosen{&scope};
    std::vector<std::string> present;
    std::size_t rest = n;
    for (std::size_t i = listing.sets.size(); i-- > 0;) {
      const auto& [name, set] = listing.sets[i];
      const std::size_t at = rest % set.parts.size();
      rest /= set.parts.size();
      present.push_back(smt_all({set.defined, set.present[at]}));
      SmtMeaning& meaning = chosen.names[name];
      meaning.value = constant(set.parts[at]);
      if (!meaning.value) meaning.term = set.parts[at];
    }
    if (smt_all(present) == "false") continue;
    SmtScope inner{&chosen};
    SmtBound bound = bind(listing.rest, chosen, inner);
    bound.conditions.insert(bound.conditions.begin(), present.begin(), present.end());
    if (smt_all(bound.conditions) != "false") each(inner, bound);
  }
}

/// Returns the characteristic tuple of declarations without inclusions.
SmtTerm SmtTranslator::characteristic(const SchemaText& text, const SmtScope& inner) {
  SmtTerm tuple{SmtSort::tuple};
  std::vector<std::string> defined;
  for (const Declaration& each : text.declarations)
    for (const Name& name : each.names) {
      tuple.parts.push_back(expression(reference(name), inner));
      defined.push_back(tuple.parts.back().defined);
    }
  if (tuple.parts.size() == 1) return SmtTerm(tuple.parts[0]);
  tuple.defined = smt_all(defined);
  return tuple;
}

/// Translates ∃₁ where all cases are written out: those that hold have one member.
std::optional<std::string> SmtTranslator::exactly_one(const Term& term, const SmtScope& scope) {
  const SmtListing list = listing(*term->text, scope, false);
  if (list.sets.empty() || !list.is_whole() || list.cases > most_cases_of_one) return std::nullopt;
  SmtTerm found{SmtSort::set};
  each_case(list, scope, [&](const SmtScope& inner, const SmtBound& bound) {
    const std::string here = smt_all({smt_all(bound.conditions), predicate(term->children[0], inner)});
    add_slot(found, characteristic(*term->text, inner), here);
  });
  return smt_equal(size_of_slots(merged_slots(std::move(found))), {SmtSort::integer, "1"});
}

}  // namespace durero::zed
