#include "zed/review/prover.hpp"

#include <algorithm>

#include "zed/syntax/match.hpp"

namespace durero::zed {
namespace {

constexpr std::size_t max_sets = 64;  // no more sets tied to a domain are looked at

Term equation(const Term& a, const Term& b) { return relation({{"_=_", {}}}, {a, b}); }

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
      : expander_(expander), facts_(facts), budget_(budget) {}

  /// Says whether x ∈ S, or y ∈ S for a y that is x.
  bool holds_for(const Term& x, const Term& set) {
    if (member(x, set)) return true;
    for (const Term& fact : facts_.facts) {
      if (!is_relation(fact, "_=_")) continue;
      for (const std::size_t side : {0u, 1u})
        if (fact->children[side] == x && member(fact->children[1 - side], set)) return true;
    }
    return false;
  }

 private:
  bool member(const Term& x, const Term& set) {
    std::vector<Term> sets = {set};
    for (std::size_t i = 0; i < sets.size() && i < max_sets; ++i) {
      budget_.spend(4 * facts_.facts.size());
      if (at_once(x, sets[i])) return true;
      for (const Term& fact : facts_.facts) {
        for (const std::size_t side : {0u, 1u}) {
          const bool tied = is_relation(fact, "_=_") || (side == 1 && is_relation(fact, "_⊆_"));
          if (tied && fact->children[side] == sets[i]) insert(sets, fact->children[1 - side]);
          const Term* function = of_domain(sets[i]);
          if (function && is_relation(fact, "_=_") && fact->children[side] == *function &&
              !about(fact->children[1 - side], *function))
            insert(sets, domain_of(fact->children[1 - side]));
        }
      }
    }
    return false;
  }

  /// Says whether the term speaks of f, as (e, f e) ∈ f does: the domain of f cannot be known by it.
  static bool about(const Term& term, const Term& f) { return f->kind == Kind::reference && mentions(term, {f->name}); }

  static void insert(std::vector<Term>& sets, const Term& set) {
    if (std::find(sets.begin(), sets.end(), set) == sets.end()) sets.push_back(set);
  }

  bool holds(const Term& fact) const {
    return std::find(facts_.facts.begin(), facts_.facts.end(), fact) != facts_.facts.end();
  }

  bool at_once(const Term& x, const Term& set) {
    if (holds(relation({{"_∈_", {}}}, {x, set}))) return true;
    if (holds(node(Kind::negation, {relation({{"_∉_", {}}}, {x, set})}))) return true;
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
    return std::any_of(facts_.facts.begin(), facts_.facts.end(), [&](const Term& fact) {
      return is_relation(fact, "_∈_") && fact->children[1] == f && begins(fact->children[0]) &&
             !about(fact->children[0], f);
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
      return is_smaller(set) || std::any_of(facts_.facts.begin(), facts_.facts.end(), [&](const Term& fact) {
               return is_relation(fact, "_=_") && ((fact->children[0] == set && is_smaller(fact->children[1])) ||
                                                   (fact->children[1] == set && is_smaller(fact->children[0])));
             });
    };
    return std::any_of(facts_.facts.begin(), facts_.facts.end(), [&](const Term& fact) {
      return is_relation(fact, "_∈_") && fact->children[0] == x && equals_smaller(fact->children[1]);
    });
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

  bool equals(const Term& a, const Term& b) const { return holds(equation(a, b)) || holds(equation(b, a)); }
  bool differs(const Term& a, const Term& b) const {
    return holds(node(Kind::negation, {equation(a, b)})) || holds(node(Kind::negation, {equation(b, a)})) ||
           holds(relation({{"_≠_", {}}}, {a, b})) || holds(relation({{"_≠_", {}}}, {b, a}));
  }

  const Expander& expander_;
  const Facts& facts_;
  Budget& budget_;
  unsigned depth_ = 0;
};

}  // namespace

Term domain_of(const Term& function) { return apply(reference({"dom", {}}), function); }

bool proves_member(const Term& x, const Term& set, const Expander& expander, const Facts& facts, Budget& budget) {
  return Prover(expander, facts, budget).holds_for(x, set);
}

}  // namespace durero::zed
