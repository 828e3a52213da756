#include "zed/evaluate/connectives.hpp"

#include <algorithm>

#include "zed/evaluate/substitute.hpp"

namespace durero::zed {

SchemaText declarations_of(const std::vector<std::pair<Name, Term>>& declared) {
  SchemaText text;
  for (const auto& [name, set] : declared) {
    auto* last = text.declarations.empty() ? nullptr : &text.declarations.back();
    if (last && last->term == set) {
      last->names.push_back(name);
      last->places.emplace_back();
    } else {
      text.declarations.push_back({Declaration::Form::typed, {name}, {Place{}}, set, {}});
    }
  }
  return text;
}

/// Returns the facts of a schema, with the memberships in the sets of its declarations that `declared` does not state:
/// a negated schema, or one whose component the other side declares otherwise, states these too.
std::vector<Term> Connectives::said_by(const Flat& flat, const Flat& declared) const {
  std::vector<Term> facts;
  for (const auto& [name, set] : flat.declared) {
    const Term* in = declared.set_of(name);
    if (!(in && *in == set) && !is_whole_type(set, definitions_)) add_fact(facts, member(name, set));
  }
  for (const Term& fact : flat.facts) add_fact(facts, fact);
  return facts;
}

/// Returns the set of all values of a component's type, where the component is declared from `set`; null where it is
/// not known.
Term Connectives::whole(const Name& name, const Term& set) const {
  return is_whole_type(set, definitions_) ? set : carriers_(name);
}

Connectives::Result Connectives::declared_widely(const Flat& a, const Flat& b, bool keep_common) const {
  Flat wide;
  for (const Flat* side : {&a, &b})
    for (const auto& [name, set] : side->declared) {
      if (wide.set_of(name)) continue;
      const Term *in_a = a.set_of(name), *in_b = b.set_of(name);
      const bool common = keep_common && in_a && in_b && *in_a == *in_b;
      const Term widest = common ? set : whole(name, set);
      if (!widest) return std::nullopt;
      wide.declared.emplace_back(name, widest);
    }
  return wide;
}

Connectives::Result Connectives::joined(Kind kind, const Flat& left, const Flat& right) const {
  Result all = declared_widely(left, right, false);
  if (!all) return all;
  all->facts.push_back(node(kind, {all_of_facts(said_by(left, *all)), all_of_facts(said_by(right, *all))}));
  return all;
}

// The facts that both sides state stand before the disjunction.
Connectives::Result Connectives::disjunction(const Flat& left, const Flat& right) const {
  Result all = declared_widely(left, right, true);
  if (!all) return all;
  std::vector<Term> a = said_by(left, *all), b = said_by(right, *all);
  for (const Term& fact : a)
    if (std::find(b.begin(), b.end(), fact) != b.end()) all->facts.push_back(fact);
  const auto in_both = [&](const Term& fact) {
    return std::find(all->facts.begin(), all->facts.end(), fact) != all->facts.end();
  };
  std::erase_if(a, in_both);
  std::erase_if(b, in_both);
  if (!a.empty() && !b.empty()) all->facts.push_back(node(Kind::disjunction, {all_of_facts(a), all_of_facts(b)}));
  return all;
}

Connectives::Result Connectives::negation(const Flat& of) const {
  Result all = declared_widely(of, of, false);
  if (all) all->facts.push_back(node(Kind::negation, {all_of_facts(said_by(of, *all))}));
  return all;
}

Connectives::Result Connectives::projection(const Flat& left, const Flat& right) const {
  Components gone;
  for (const auto& [name, set] : left.declared)
    if (!right.set_of(name)) gone.push_back(name);
  return hidden(merged(left, right), gone, definitions_);
}

/// Says whether a name would be captured: a set of `bound` depends on a component of `of`, a fact of `bound` on such a
/// component that is not bound, or the set of a component on a bound name.
bool Connectives::captures(const Flat& bound, const Flat& of) const {
  const auto depends = [this](const Term& term, const Name& name) { return depends_on(term, name, definitions_); };
  for (const auto& [name, set] : of.declared) {
    const auto in_bound = [&, &component = name](const auto& each) { return depends(each.second, component); };
    if (std::any_of(bound.declared.begin(), bound.declared.end(), in_bound)) return true;
    if (!bound.set_of(name) &&
        std::any_of(bound.facts.begin(), bound.facts.end(),
                    [&, &component = name](const Term& fact) { return depends(fact, component); }))
      return true;
    for (const auto& [each, of_bound] : bound.declared)
      if (depends(set, each)) return true;
  }
  return false;
}

// Under ∀ the remaining components are declared from whole types, for where the bound schema has no binding every value
// of theirs satisfies the result. Under ∃₁ they keep their sets, for there is a binding that is in them.
Connectives::Result Connectives::quantified(Kind kind, const Flat& bound, const Flat& of) const {
  if (captures(bound, of)) return std::nullopt;
  if (kind == Kind::exists) {
    Components names;
    for (const auto& [name, set] : bound.declared) names.push_back(name);
    return hidden(merged(bound, of), names, definitions_);
  }
  Flat rest, known = bound;
  for (const auto& [name, set] : of.declared) {
    if (bound.set_of(name)) continue;
    const Term from = kind == Kind::forall ? whole(name, set) : set;
    if (!from) return std::nullopt;
    rest.declared.emplace_back(name, from);
    known.declared.emplace_back(name, from);
  }
  SchemaText text = declarations_of(bound.declared);
  if (!bound.facts.empty()) text.predicates.push_back({all_of_facts(bound.facts), {}, {}});
  rest.facts.push_back(zed::quantified(kind, std::move(text), {all_of_facts(said_by(of, known))}));
  return rest;
}

}  // namespace durero::zed
