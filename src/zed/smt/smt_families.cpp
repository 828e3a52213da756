/// Translates variables that are sets: power sets, sets of relations, functions and sequences.

#include <algorithm>

#include "zed/smt/smt_slots.hpp"
#include "zed/smt/smt_translator.hpp"

namespace durero::zed {
namespace {

constexpr std::size_t most_listed = 32;    // a set of so many members has a slot for each in its subsets
constexpr std::size_t most_domain = 128;   // a domain of so many members has a slot for each in its functions
constexpr std::size_t most_covered = 256;  // members of a domain or range that are asked for one by one

SmtMembership both_hold(const SmtMembership& a, const SmtMembership& b) {
  return {smt_all({a.holds, b.holds}), smt_all({a.defined, b.defined})};
}

bool is_sequence_set(const std::string& name) { return name == "seq_" || name == "seq₁_" || name == "iseq_"; }

bool is_subset_family(const std::string& name) { return name == "𝔽_" || name == "ℙ₁_" || name == "𝔽₁_"; }

/// The place of the number, or the name, that puts the members of a set in an order: the member itself, or its first
/// part. Null where there is none.
const SmtTerm* ordered_by(const SmtTerm& member) {
  if (member.sort == SmtSort::integer || member.sort == SmtSort::real || member.sort == SmtSort::atom) return &member;
  return member.sort == SmtSort::tuple ? ordered_by(member.parts[0]) : nullptr;
}

/// Slots of one form stand for the same sets in each order: one order is asked for. Members that are numbers differ,
/// and so do the first parts of a function; other members may begin alike.
std::string stands_after(const SmtTerm& set, std::size_t i, bool by_place) {
  std::vector<std::string> facts = {set.present[i - 1]};
  const SmtTerm *before = ordered_by(set.parts[i - 1]), *here = ordered_by(set.parts[i]);
  const SmtTerm& last = set.parts[i - 1];
  const bool differ = before == &last || (set.function && before == &last.parts[0]);
  if (!by_place && before && here) facts.push_back(smt_call(differ ? "<" : "<=", {before->text, here->text}));
  return smt_implied(set.present[i], smt_all(facts));
}

}  // namespace

SmtTerm SmtTranslator::fresh(const SmtTerm& shape, SmtBound& bound) {
  SmtTerm variable = shape;
  variable.defined = "true";
  for (SmtTerm& part : variable.parts) part = fresh(part, bound);
  if (shape.sort == SmtSort::set) fresh_set(shape, variable, bound);
  const bool whole = shape.sort == SmtSort::tuple || shape.sort == SmtSort::binding || shape.sort == SmtSort::set;
  if (whole || !shape.text.empty()) return variable;
  variable.text = "v" + std::to_string(symbols_++);
  bound.symbols.push_back({variable.text, shape.sort == SmtSort::real ? "Real" : "Int"});
  return variable;
}

/// Makes a symbol for each member that may be present, and the conditions that make a function of a function's slots.
void SmtTranslator::fresh_set(const SmtTerm& shape, SmtTerm& set, SmtBound& bound) {
  for (std::string& present : set.present) {
    if (!present.empty()) continue;
    present = "v" + std::to_string(symbols_++);
    bound.symbols.push_back({present, "Bool"});
  }
  for (std::size_t i = 1; i < set.parts.size(); ++i) {
    const bool alike =
        shape.present[i - 1].empty() && shape.present[i].empty() && have_one_text(shape.parts[i - 1], shape.parts[i]);
    if (alike || shape.sequence) bound.conditions.push_back(stands_after(set, i, shape.sequence));
  }
  if (!set.function) return;
  set.function = false;
  bound.conditions.push_back(slots_are_function(set));
  set.function = true;
}

/// Says whether a set without variables is known to have a member.
bool SmtTranslator::is_inhabited(const Term& set, const SmtScope& scope) {
  if (const Term* of = abbreviated(set, scope)) return is_inhabited(*of, global_);
  if (const auto few = listed(set, scope, most_covered)) return !few->empty();
  if (!is_closed(set, scope)) return false;
  try {
    const Value all = value(set, scope);
    const auto size = all.set() ? all.set()->size() : std::nullopt;
    return size && sign(*size) > 0;
  } catch (const Untranslated&) {
    return false;
  }
}

/// A slot holds a member of its set even where it is not present, if the set has one: a solver finds more where each
/// number has bounds.
void SmtTranslator::bound_slots(const SmtTerm& variable, const Term& set, const SmtScope& scope, SmtBound& bound) {
  if (variable.sort != SmtSort::set) return;
  const bool power = set->kind == Kind::power;
  if (!power && !is_toolkit(set, scope)) return;
  const std::string name = power ? "" : set->name.text();
  const bool arrow = !power && operator_row(name)->arrow.has_value();
  if (!power && !arrow && !is_subset_family(name) && !is_sequence_set(name)) return;
  const std::size_t actuals = set->children.size();
  const bool pairs = arrow || is_sequence_set(name);
  for (std::size_t i = 0; i < actuals; ++i) {
    if (!is_inhabited(set->children[i], scope)) continue;
    for (const SmtTerm& part : variable.parts) {
      const SmtMembership in = member(pairs ? pair_part(part, actuals == 2 ? i : 1) : part, set->children[i], scope);
      bound.conditions.push_back(smt_all({in.defined, in.holds}));
    }
  }
}

/// The form of the members of ℙ X, X ⇸ Y, seq X and their like; nothing for another set.
std::optional<SmtTerm> SmtTranslator::family_shape(const Term& set, const SmtScope& scope) {
  if (set->kind == Kind::power) return subset_shape(set->children[0], scope);
  if (!is_toolkit(set, scope)) return std::nullopt;
  const std::string name = set->name.text();
  const std::size_t actuals = set->children.size();
  if (const auto& arrow = operator_row(name)->arrow; arrow && actuals == 2) return arrow_shape(*arrow, set, scope);
  if (is_subset_family(name) && actuals == 1) return subset_shape(set->children[0], scope);
  if (is_sequence_set(name) && actuals == 1) return sequence_shape(set, scope);
  return std::nullopt;
}

/// A set whose members are not listed has some slots.
SmtTerm SmtTranslator::some_slots(const SmtTerm& member) {
  bounded_ = true;
  SmtTerm made{SmtSort::set};
  made.parts.assign(most_slots, member);
  made.present.assign(most_slots, "");
  return made;
}

SmtTerm SmtTranslator::subset_shape(const Term& of, const SmtScope& scope) {
  SmtTerm made{SmtSort::set};
  if (const auto all = listed(of, scope, most_listed)) {
    made.parts = *all;
  } else if (const auto slots = mentions_set(of, scope) ? slots_of(of, scope, false) : std::nullopt) {
    made.parts = slots->parts;
  } else {
    return some_slots(shape(of, scope));
  }
  made.present.assign(made.parts.size(), "");
  return made;
}

/// A function from a listed domain has one slot for each argument.
SmtTerm SmtTranslator::arrow_shape(const Arrow& arrow, const Term& set, const SmtScope& scope) {
  const Term &from = set->children[0], &to = set->children[1];
  SmtTerm made{SmtSort::set};
  made.function = arrow.function;
  const auto domain = listed(from, scope, arrow.function ? most_domain : most_listed);
  const auto range = arrow.function || !domain ? std::nullopt : listed(to, scope, most_listed);
  if (domain && arrow.function) {
    for (const SmtTerm& argument : *domain) made.parts.push_back(pair_of(argument, shape(to, scope)));
    made.present.assign(made.parts.size(), arrow.total ? "true" : "");
    return made;
  }
  if (domain && range && domain->size() * range->size() <= most_listed) {
    for (const SmtTerm& first : *domain)
      for (const SmtTerm& second : *range) made.parts.push_back(pair_of(first, second));
    made.present.assign(made.parts.size(), "");
    return made;
  }
  made = some_slots(pair_of(shape(from, scope), shape(to, scope)));
  made.function = arrow.function;
  return made;
}

/// A sequence has a slot for each position. One without repetitions is no longer than its set has members.
SmtTerm SmtTranslator::sequence_shape(const Term& set, const SmtScope& scope) {
  const Term& items = set->children[0];
  const auto all = set->name.text() == "iseq_" ? listed(items, scope, most_slots) : std::nullopt;
  bounded_ = bounded_ || !all;
  SmtTerm made{SmtSort::set};
  made.function = made.sequence = true;
  const SmtTerm item = shape(items, scope);
  for (std::size_t i = 1; i <= (all ? all->size() : most_slots); ++i)
    made.parts.push_back(pair_of({SmtSort::integer, std::to_string(i)}, item));
  made.present.assign(made.parts.size(), "");
  return made;
}

/// Membership in ℙ X, X ⇸ Y, seq X and their like; nothing for another set.
std::optional<SmtMembership> SmtTranslator::in_family(const SmtTerm& element, const Term& set, const SmtScope& scope) {
  if (set->kind == Kind::power) return all_in(as_slots(element), std::nullopt, set->children[0], scope);
  if (!is_toolkit(set, scope)) return std::nullopt;
  const std::string name = set->name.text();
  const std::size_t actuals = set->children.size();
  if (const auto& arrow = operator_row(name)->arrow; arrow && actuals == 2)
    return in_arrow(as_slots(element), *arrow, set, scope);
  if (actuals != 1) return std::nullopt;
  if (is_sequence_set(name)) return in_sequences(as_slots(element), set, scope);
  if (!is_subset_family(name)) return std::nullopt;
  const SmtTerm subset = as_slots(element);
  const SmtMembership all = all_in(subset, std::nullopt, set->children[0], scope);
  return name == "𝔽_" ? all : both_hold(all, {slots_have_member(subset)});
}

/// Says that each member, or that part of each, is in another set.
SmtMembership SmtTranslator::all_in(const SmtTerm& set, std::optional<std::size_t> part, const Term& in,
                                    const SmtScope& scope) {
  std::vector<std::string> holds, defined = {set.defined};
  if (set.parts.empty()) defined.push_back(has_value(in, scope));
  for (std::size_t i = 0; i < set.parts.size(); ++i) {
    const SmtMembership here = member(part ? pair_part(set.parts[i], *part) : set.parts[i], in, scope);
    holds.push_back(smt_implied(set.present[i], here.holds));
    defined.push_back(here.defined);
  }
  return {smt_all(holds), smt_all(defined)};
}

SmtMembership SmtTranslator::in_arrow(const SmtTerm& relation, const Arrow& arrow, const Term& set,
                                      const SmtScope& scope) {
  const Term &from = set->children[0], &to = set->children[1];
  SmtMembership in = both_hold(all_in(relation, 0, from, scope), all_in(relation, 1, to, scope));
  if (arrow.function) in = both_hold(in, {slots_are_function(relation)});
  if (arrow.injective) in = both_hold(in, {slots_are_injective(relation)});
  if (arrow.total) in = both_hold(in, covers(relation, 0, from, scope));
  if (arrow.surjective) in = both_hold(in, covers(relation, 1, to, scope));
  return in;
}

/// Says that each member of a set is that part of some pair.
SmtMembership SmtTranslator::covers(const SmtTerm& relation, std::size_t part, const Term& set, const SmtScope& scope) {
  const SmtTerm parts = part == 0 ? domain_of_slots(relation) : range_of_slots(relation);
  if (const auto all = listed(set, scope, most_covered)) {
    std::vector<std::string> facts;
    for (const SmtTerm& each : *all) facts.push_back(in_slots(each, parts));
    return {smt_all(facts)};
  }
  const SmtTerm whole = as_slots(expression(set, scope));
  return {subset_of_slots(whole, parts), whole.defined};
}

SmtMembership SmtTranslator::in_sequences(const SmtTerm& sequence, const Term& set, const SmtScope& scope) {
  const std::string name = set->name.text();
  SmtMembership in = both_hold({slots_are_sequence(sequence)}, all_in(sequence, 1, set->children[0], scope));
  if (name == "seq₁_") in = both_hold(in, {slots_have_member(sequence)});
  if (name == "iseq_") in = both_hold(in, {slots_are_injective(sequence)});
  return in;
}

}  // namespace durero::zed
