/// Translates expressions that are sets, and operations of the toolkit on them.

#include "zed/evaluate/describe.hpp"
#include "zed/smt/smt_slots.hpp"
#include "zed/smt/smt_translator.hpp"
#include "zed/syntax/match.hpp"

namespace durero::zed {

/// Translates a name in scope, or `id S`.
SmtTerm SmtTranslator::named(const Term& term, const SmtScope& scope) {
  if (is_toolkit(term, scope) && term->name.text() == "id_" && term->children.size() == 1)
    return identity_of_slots(expression(term->children[0], scope));
  const SmtMeaning* meaning = find(term->name, scope);
  if (meaning && meaning->lambda) return expression(meaning->lambda, *meaning->scope);
  if (!meaning || !meaning->term) refuse(term, "is not translated");
  return *meaning->term;
}

SmtTerm SmtTranslator::set_expression(const Term& term, const SmtScope& scope) {
  if (term->kind == Kind::comprehension || term->kind == Kind::lambda) return comprehension(term, scope);
  if (term->kind == Kind::product) {
    std::vector<SmtTerm> factors;
    for (const Term& each : term->children) factors.push_back(as_slots(expression(each, scope)));
    return product_of_slots(factors);
  }
  SmtTerm made{SmtSort::set};
  std::vector<std::string> defined;
  for (const Term& each : term->children) {
    SmtTerm member = expression(each, scope);
    defined.push_back(member.defined);
    add_slot(made, std::move(member), "true");
  }
  made.defined = smt_all(defined);
  return merged_slots(std::move(made));
}

/// A comprehension, or a λ, has a member for each case. A comprehension has a value where each of its terms has one; a
/// λ has none at an argument for which its term has none.
SmtTerm SmtTranslator::comprehension(const Term& term, const SmtScope& scope) {
  const SmtListing list = listing(*term->text, scope, true);
  if (!list.is_whole()) refuse(term, "has no few members that are known");
  SmtTerm made{SmtSort::set};
  std::vector<std::string> defined;
  for (const auto& [name, set] : list.sets) defined.push_back(set.defined);
  each_case(list, scope, [&](const SmtScope& inner, const SmtBound& bound) {
    const bool own = term->kind == Kind::lambda || term->children.empty();
    SmtTerm member = own ? characteristic(*term->text, inner) : expression(term->children[0], inner);
    if (term->kind == Kind::lambda) member = pair_of(std::move(member), expression(term->children[0], inner));
    const std::string here = smt_all(bound.conditions);
    if (term->kind != Kind::lambda) defined.push_back(smt_implied(here, member.defined));
    add_slot(made, std::move(member), here);
  });
  made.defined = smt_all(defined);
  made.function = term->kind == Kind::lambda;
  return merged_slots(std::move(made));
}

/// Says that a set has a value, of which no member is asked.
std::string SmtTranslator::has_value(const Term& set, const SmtScope& scope) {
  if (set->kind == Kind::comprehension) return "true";
  if (!is_closed(set, scope)) return expression(set, scope).defined;
  const Meaning* meaning = set->kind == Kind::reference ? definitions_.find(set->name) : nullptr;
  if (meaning && meaning->kind != Meaning::Kind::definition && meaning->kind != Meaning::Kind::axiomatic) return "true";
  return value(set, scope).is_undefined() ? "false" : "true";
}

/// Keeps the members of which a part, or the whole, is in another set, or is not.
SmtTerm SmtTranslator::kept(const SmtTerm& set, std::optional<std::size_t> part, const Term& in, bool inside,
                            const SmtScope& scope) {
  std::vector<std::string> defined = {set.defined};
  if (set.parts.empty()) defined.push_back(has_value(in, scope));
  SmtTerm made = slots_where(set, [&](const SmtTerm& each) {
    const SmtMembership here = member(part ? pair_part(each, *part) : each, in, scope);
    defined.push_back(here.defined);
    return inside ? here.holds : smt_not(here.holds);
  });
  made.defined = smt_all(defined);
  return made;
}

/// A ∩ B is made of the members of that set whose members are few.
SmtTerm SmtTranslator::intersection_of(const Term& a, const Term& b, const SmtScope& scope) {
  std::optional<SmtTerm> left;
  try {
    left = as_slots(expression(a, scope));
  } catch (const Untranslated&) {
    return kept(as_slots(expression(b, scope)), std::nullopt, a, true, scope);
  }
  return kept(*left, std::nullopt, b, true, scope);
}

/// Translates the operations that ask one operand for memberships only: it may have any number of members.
std::optional<SmtTerm> SmtTranslator::filtered(const std::string& by, const Term& a, const Term& b,
                                               const SmtScope& scope) {
  const auto of = [&](const Term& set, std::optional<std::size_t> part, const Term& in, bool inside) {
    return kept(as_slots(expression(set, scope)), part, in, inside, scope);
  };
  if (by == "_∩_") return intersection_of(a, b, scope);
  if (by == "_∖_") return of(a, std::nullopt, b, false);
  if (by == "_◁_") return of(b, 0, a, true);
  if (by == "_⩤_") return of(b, 0, a, false);
  if (by == "_▷_") return of(a, 1, b, true);
  if (by == "_⩥_") return of(a, 1, b, false);
  if (by == "_⦇_⦈") return range_of_slots(of(a, 0, b, true));
  if (by == "_↾_") return squashed_slots(of(a, 1, b, true));
  if (by == "_↿_") return squashed_slots(of(b, 0, a, true));
  return std::nullopt;
}

/// Returns the value of a function of the toolkit that takes or gives sets.
std::optional<SmtTerm> SmtTranslator::set_operation(const std::string& by, const Term& argument,
                                                    const SmtScope& scope) {
  using Unary = SmtTerm (*)(const SmtTerm&);
  using Binary = SmtTerm (*)(const SmtTerm&, const SmtTerm&);
  static const std::map<std::string, Unary> of_one = {
      {"dom", domain_of_slots},   {"ran", range_of_slots},    {"_∼", inverse_of_slots}, {"#_", size_of_slots},
      {"min", least_of_slots},    {"max", greatest_of_slots}, {"⋃", union_in_slots},    {"rev", reversed_slots},
      {"head", head_of_slots},    {"last", last_of_slots},    {"tail", tail_of_slots},  {"front", front_of_slots},
      {"squash", squashed_slots}, {"⟨,,⟩", sequence_in_slots}};
  static const std::map<std::string, Binary> of_two = {{"_∪_", union_of_slots},
                                                       {"_⊖_", symmetric_difference_of_slots},
                                                       {"_⊕_", overridden_slots},
                                                       {"_⨾_", composed_slots},
                                                       {"_⁀_", concatenated_slots}};
  if (const auto one = of_one.find(by); one != of_one.end()) return one->second(as_slots(expression(argument, scope)));
  if (argument->kind != Kind::tuple || argument->children.size() != 2) return std::nullopt;
  const Term &a = argument->children[0], &b = argument->children[1];
  if (auto made = filtered(by, a, b, scope)) return made;
  const auto two = of_two.find(by);
  const bool backward = by == "_∘_", interval = by == "_‥_";
  if (two == of_two.end() && !backward && !interval) return std::nullopt;
  const SmtTerm left = expression(a, scope), right = expression(b, scope);
  if (interval) {
    bounded_ = true;
    return interval_in_slots(left, right, most_slots);
  }
  if (backward) return composed_slots(as_slots(right), as_slots(left));
  return two->second(as_slots(left), as_slots(right));
}

/// Says that each member of one set is in the other, of which no more is asked.
std::string SmtTranslator::inclusion(const Term& a, const Term& b, const SmtScope& scope) {
  const SmtMembership all = all_in(as_slots(expression(a, scope)), std::nullopt, b, scope);
  return smt_all({all.defined, all.holds});
}

/// Translates a relation of the toolkit between sets; nothing for another.
std::optional<std::string> SmtTranslator::set_relation(const std::string& by, const Term& a, const Term& b,
                                                       const SmtScope& scope) {
  if (by == "_⊆_") return inclusion(a, b, scope);
  if (by != "_⊂_" && by != "_prefix_" && by != "_partition_") return std::nullopt;
  const SmtTerm left = as_slots(expression(a, scope)), right = as_slots(expression(b, scope));
  const std::string defined = smt_all({left.defined, right.defined});
  if (by == "_partition_")
    return smt_all({defined, slots_are_disjoint(left), smt_equal(union_in_slots(range_of_slots(left)), right)});
  limit_text(left.parts.size() * text_size(right) + right.parts.size() * text_size(left));
  const std::string inside = subset_of_slots(left, right);
  if (by == "_⊂_") return smt_all({defined, inside, smt_not(subset_of_slots(right, left))});
  return smt_all({defined, slots_are_sequence(left), slots_are_sequence(right), inside});
}

}  // namespace durero::zed
