#include "zed/review/prover.hpp"

#include <algorithm>

#include "zed/syntax/match.hpp"

namespace durero::zed {
namespace {

constexpr std::size_t max_sets = 64;  // the most sets tied to a domain that are looked at

using match::is_relation;
using match::mentions;
using match::operands;

/// Returns f of `dom f`, or null.
const Term* of_domain(const Term& set) { return match::argument_of(set, "dom"); }

/// Returns x of (x, y) and of x ↦ y, or null.
const Term* first_of_pair(const Term& pair) {
  if (const Node* both = operands(pair, "_↦_")) return &both->children[0];
  return pair->kind == Kind::tuple && pair->children.size() == 2 ? &pair->children[0] : nullptr;
}

/// Decides x ∈ S from the facts, in the few steps that partial_applications() promises.
class Prover {
 public:
  Prover(const Expander& expander, const Facts& facts, Budget& budget)
      : expander_(expander), facts_(facts), budget_(budget) {
    for (const Term& fact : facts.facts) {
      if (fact->kind == Kind::negation) negations_.push_back(&fact->children[0]);
      if (fact->kind != Kind::relation || fact->children.size() != 2) continue;
      static const Word is_member = "_∈_", equals = "_=_", is_within = "_⊆_", differs = "_≠_";
      const Word word = fact->names[0].word;
      if (word == is_member) memberships_.push_back(fact.get());
      if (word == equals) equations_.push_back(fact.get());
      if (word == is_within) inclusions_.push_back(fact.get());
      if (word == differs) inequations_.push_back(fact.get());
    }
  }

  /// Says whether x ∈ S, or y ∈ S for a y that is x.
  bool holds_for(const Term& x, const Term& set) {
    if (member(x, set)) return true;
    for (const Node* fact : equations_)
      for (const std::size_t side : {0u, 1u})
        if (fact->children[side] == x && member(fact->children[1 - side], set)) return true;
    return false;
  }

 private:
  bool member(const Term& x, const Term& set) {
    std::vector<Term> sets = {set};
    for (std::size_t i = 0; i < sets.size() && i < max_sets; ++i) {
      budget_.spend(4 * facts_.facts.size());
      if (at_once(x, sets[i])) return true;
      tied_to(Term(sets[i]), sets);
    }
    return false;
  }

  /// Adds the sets whose members are all in this one by a single fact.
  void tied_to(const Term& set, std::vector<Term>& sets) const {
    const Term* function = of_domain(set);
    for (const Node* fact : equations_)
      for (const std::size_t side : {0u, 1u}) {
        const Term &here = fact->children[side], &other = fact->children[1 - side];
        if (here == set) insert(sets, other);
        if (function && here == *function && !about(other, *function)) insert(sets, domain_of(other));
      }
    for (const Node* fact : inclusions_)
      if (fact->children[1] == set) insert(sets, fact->children[0]);
  }

  /// Says whether the term mentions f, as (e, f e) ∈ f does: the domain of f cannot be found through such a term.
  static bool about(const Term& term, const Term& f) { return f->kind == Kind::reference && mentions(term, {f->name}); }

  static void insert(std::vector<Term>& sets, const Term& set) {
    if (std::find(sets.begin(), sets.end(), set) == sets.end()) sets.push_back(set);
  }

  static bool is_between(const Node& fact, const Term& a, const Term& b) {
    return fact.children[0] == a && fact.children[1] == b;
  }

  bool at_once(const Term& x, const Term& set) {
    if (std::ranges::any_of(memberships_, [&](const Node* fact) { return is_between(*fact, x, set); })) return true;
    for (const Term* denied : negations_)
      if (is_relation(*denied, "_∉_") && is_between(**denied, x, set)) return true;
    if (set->kind == Kind::set_extension)
      return std::find(set->children.begin(), set->children.end(), x) != set->children.end();
    if (depth_ > 8) return false;  // unions may stand in unions
    ++depth_;
    bool proved = false;
    if (const Node* both = operands(set, "_∪_")) proved = member(x, both->children[0]) || member(x, both->children[1]);
    if (const Node* both = operands(set, "_∩_")) proved = member(x, both->children[0]) && member(x, both->children[1]);
    if (const Node* image = operands(set, "_⦇_⦈")) proved = in_image(x, *image);
    if (const Term* function = of_domain(set)) proved = in_domain(x, *function);
    --depth_;
    return proved;
  }

  /// x ∈ dom f holds where f is displayed, joined or overridden, or a pair of it is known.
  bool in_domain(const Term& x, const Term& f) {
    const auto begins = [&x](const Term& pair) {
      const Term* first = first_of_pair(pair);
      return first && *first == x;
    };
    if (f->kind == Kind::set_extension) return std::any_of(f->children.begin(), f->children.end(), begins);
    for (const std::string_view joined : {"_∪_", "_⊕_"})
      if (const Node* both = operands(f, joined))
        return member(x, domain_of(both->children[0])) || member(x, domain_of(both->children[1]));
    return std::ranges::any_of(memberships_, [&](const Node* fact) {
      return fact->children[1] == f && begins(fact->children[0]) && !about(fact->children[0], f);
    });
  }

  /// x ∈ R ⦇ {a, b} ⦈ holds where x is known to be in R ⦇ {a} ⦈, or in what equals it.
  bool in_smaller_image(const Term& x, const Node& image) {
    const auto is_smaller = [&](const Term& set) {
      const Node* other = operands(set, "_⦇_⦈");
      if (!other || other->children[0] != image.children[0]) return false;
      const Term &part = other->children[1], &whole = image.children[1];
      const auto is_of_whole = [&](const Term& value) {
        return std::find(whole->children.begin(), whole->children.end(), value) != whole->children.end();
      };
      return part->kind == Kind::set_extension &&
             std::all_of(part->children.begin(), part->children.end(), is_of_whole);
    };
    const auto equals_smaller = [&](const Term& set) {
      budget_.spend(facts_.facts.size());
      return is_smaller(set) || std::ranges::any_of(equations_, [&](const Node* fact) {
               return (fact->children[0] == set && is_smaller(fact->children[1])) ||
                      (fact->children[1] == set && is_smaller(fact->children[0]));
             });
    };
    return std::ranges::any_of(
        memberships_, [&](const Node* fact) { return fact->children[0] == x && equals_smaller(fact->children[1]); });
  }

  /// x ∈ g ∼ ⦇ {a, b} ⦈ holds where x ∈ dom g and g x is a or b.
  bool in_image(const Term& x, const Node& image) {
    const Term* inverted = match::argument_of(image.children[0], "_∼");
    const Term& values = image.children[1];
    if (values->kind != Kind::set_extension || values->children.empty()) return false;
    if (in_smaller_image(x, image)) return true;
    if (!inverted) return false;
    const Term& g = *inverted;
    if (!member(x, domain_of(g))) return false;
    const Term value = apply(g, x);
    std::set<Name> others;
    for (const Term& term : values->children) {
      if (equals(value, term)) return true;
      if (term->kind == Kind::reference && others.empty()) others = expander_.siblings(term->name);
    }
    if (others.empty()) return false;
    for (const Term& part : values->children) others.erase(part->name);
    return std::all_of(others.begin(), others.end(), [&](const Name& name) { return differs(value, reference(name)); });
  }

  /// Says whether the fact has a and b on its sides, either way round.
  static bool relates(const Node& fact, const Term& a, const Term& b) {
    return is_between(fact, a, b) || is_between(fact, b, a);
  }
  bool equals(const Term& a, const Term& b) const {
    return std::ranges::any_of(equations_, [&](const Node* fact) { return relates(*fact, a, b); });
  }
  bool differs(const Term& a, const Term& b) const {
    return std::ranges::any_of(inequations_, [&](const Node* fact) { return relates(*fact, a, b); }) ||
           std::ranges::any_of(
               negations_, [&](const Term* denied) { return match::is_equation(*denied) && relates(**denied, a, b); });
  }

  const Expander& expander_;
  const Facts& facts_;
  Budget& budget_;
  std::vector<const Node*> memberships_, equations_, inclusions_, inequations_;  // facts x ∈ S, a = b, S ⊆ T, a ≠ b
  std::vector<const Term*> negations_;                                           // P of facts ¬ P
  unsigned depth_ = 0;
};

}  // namespace

Term domain_of(const Term& function) { return apply(reference({"dom", {}}), function); }

bool proves_member(const Term& x, const Term& set, const Expander& expander, const Facts& facts, Budget& budget) {
  return Prover(expander, facts, budget).holds_for(x, set);
}

}  // namespace durero::zed
