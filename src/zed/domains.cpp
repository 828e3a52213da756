#include <fmt/core.h>

#include <algorithm>

#include "durero/zed/print.hpp"
#include "durero/zed/review.hpp"
#include "expand.hpp"

namespace durero::zed {
namespace {

constexpr std::size_t max_sets = 64;  // sets tied to a domain that are looked at

Term domain_of(const Term& function) { return apply(reference({"dom", {}}), function); }
Term equation(const Term& a, const Term& b) { return relation({{"_=_", {}}}, {a, b}); }

bool is_relation(const Term& fact, std::string_view word) {
  return fact->kind == Kind::relation && fact->children.size() == 2 && fact->names[0].word == word;
}

/// The operands of `a op b`, or null.
const Node* operands(const Term& term, std::string_view op) {
  if (term->kind != Kind::application || term->children[0]->kind != Kind::reference) return nullptr;
  const Node& argument = *term->children[1];
  const bool pair = argument.kind == Kind::tuple && argument.children.size() == 2;
  return term->children[0]->name.word == op && pair ? &argument : nullptr;
}

/// f of `dom f`, or null.
const Term* of_domain(const Term& set) {
  const bool domain = set->kind == Kind::application && set->children[0]->kind == Kind::reference &&
                      set->children[0]->name.word == "dom";
  return domain ? &set->children[1] : nullptr;
}

/// x of (x, y) and of x ↦ y, or null.
const Term* first_of_pair(const Term& pair) {
  if (const Node* both = operands(pair, "_↦_")) return &both->children[0];
  return pair->kind == Kind::tuple && pair->children.size() == 2 ? &pair->children[0] : nullptr;
}

bool is_partial_arrow(const Term& set) {
  if (set->kind != Kind::reference) return false;
  for (const std::string_view arrow : {"_⇸_", "_⤔_", "_⤀_", "_⇻_", "_⤕_"})
    if (set->name.word == arrow) return true;
  return false;
}

/// What holds at a place.
struct Context {
  std::vector<Term> facts;
  std::map<Name, Term> declared;  // a name and the set it is declared from
};

/// Decides x ∈ S from the facts, in the few steps that partial_applications() promises.
class Prover {
 public:
  Prover(const Expander& expander, const Context& context, Budget& budget)
      : expander_(expander), context_(context), budget_(budget) {}

  /// x ∈ S, or y ∈ S for a y that is x.
  bool holds_for(const Term& x, const Term& set) {
    if (member(x, set)) return true;
    for (const Term& fact : context_.facts) {
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
      budget_.spend(4 * context_.facts.size());
      if (at_once(x, sets[i])) return true;
      for (const Term& fact : context_.facts) {
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

  /// The term says something of f, whose domain it cannot be known by then: (e, f e) ∈ f.
  static bool about(const Term& term, const Term& f) { return f->kind == Kind::reference && mentions(term, {f->name}); }

  static void insert(std::vector<Term>& sets, const Term& one) {
    if (std::find(sets.begin(), sets.end(), one) == sets.end()) sets.push_back(one);
  }

  bool holds(const Term& fact) const {
    return std::find(context_.facts.begin(), context_.facts.end(), fact) != context_.facts.end();
  }

  bool at_once(const Term& x, const Term& set) {
    if (holds(relation({{"_∈_", {}}}, {x, set}))) return true;
    if (holds(node(Kind::negation, {relation({{"_∉_", {}}}, {x, set})}))) return true;
    if (set->kind == Kind::set_extension)
      return std::find(set->children.begin(), set->children.end(), x) != set->children.end();
    if (depth_ > 8) return false;  // unions in unions
    ++depth_;
    bool found = false;
    if (const Node* both = operands(set, "_∪_")) found = member(x, both->children[0]) || member(x, both->children[1]);
    if (const Node* both = operands(set, "_∩_")) found = member(x, both->children[0]) && member(x, both->children[1]);
    if (const Node* image = operands(set, "_⦇_⦈")) found = in_image(x, *image);
    if (const Term* function = of_domain(set)) found = in_domain(x, *function);
    --depth_;
    return found;
  }

  /// x ∈ dom f, where f is displayed, joined or overridden, or a pair of it is known.
  bool in_domain(const Term& x, const Term& f) {
    const auto begins = [&x](const Term& pair) {
      const Term* first = first_of_pair(pair);
      return first && *first == x;
    };
    if (f->kind == Kind::set_extension) return std::any_of(f->children.begin(), f->children.end(), begins);
    for (const std::string_view joined : {"_∪_", "_⊕_"})
      if (const Node* both = operands(f, joined))
        return member(x, domain_of(both->children[0])) || member(x, domain_of(both->children[1]));
    return std::any_of(context_.facts.begin(), context_.facts.end(), [&](const Term& fact) {
      return is_relation(fact, "_∈_") && fact->children[1] == f && begins(fact->children[0]) &&
             !about(fact->children[0], f);
    });
  }

  /// x ∈ g ∼ ⦇ {a, b} ⦈ where x ∈ dom g and g x is a or b.
  bool in_image(const Term& x, const Node& image) {
    const Term &inverse = image.children[0], &values = image.children[1];
    const bool inverted = inverse->kind == Kind::application && inverse->children[0]->kind == Kind::reference &&
                          inverse->children[0]->name.word == "_∼";
    if (!inverted || values->kind != Kind::set_extension || values->children.empty()) return false;
    const Term& g = inverse->children[1];
    if (!member(x, domain_of(g))) return false;
    const Term value = apply(g, x);
    std::set<Name> others;
    for (const Term& one : values->children) {
      if (equals(value, one)) return true;
      if (one->kind == Kind::reference && others.empty()) others = expander_.siblings(one->name);
    }
    if (others.empty()) return false;
    for (const Term& one : values->children) others.erase(one->name);
    return std::all_of(others.begin(), others.end(), [&](const Name& one) { return differs(value, reference(one)); });
  }

  bool equals(const Term& a, const Term& b) const { return holds(equation(a, b)) || holds(equation(b, a)); }
  bool differs(const Term& a, const Term& b) const {
    return holds(node(Kind::negation, {equation(a, b)})) || holds(node(Kind::negation, {equation(b, a)})) ||
           holds(relation({{"_≠_", {}}}, {a, b})) || holds(relation({{"_≠_", {}}}, {b, a}));
  }

  const Expander& expander_;
  const Context& context_;
  Budget& budget_;
  unsigned depth_ = 0;
};

class Walker {
 public:
  Walker(const Expander& expander, std::vector<Defect>& found) : expander_(expander), found_(found) {
    join(context_, expander.axioms());
  }

  void section(const Section& section) {
    file_ = section.file;
    for (const Paragraph& one : section.paragraphs) {
      if (const auto* box = std::get_if<Schema>(&one.form)) text(box->text, {});
      if (const auto* box = std::get_if<Axiomatic>(&one.form)) text(box->text, {});
      if (const auto* made = std::get_if<Definition>(&one.form)) term(made->value);
      if (const auto* claim = std::get_if<Conjecture>(&one.form)) term(claim->claim.term);
    }
  }

 private:
  static void join(Context& context, const Expansion& more) {
    context.facts.insert(context.facts.end(), more.facts.begin(), more.facts.end());
    for (const auto& [name, set] : more.declared) context.declared.insert_or_assign(name, set);
  }

  /// Walks a term where more holds.
  void with(const std::vector<Term>& more, const Term& then) {
    const std::size_t before = context_.facts.size();
    context_.facts.insert(context_.facts.end(), more.begin(), more.end());
    term(then);
    context_.facts.resize(before);
  }
  static std::vector<Term> facts(const Term& predicate) {
    std::vector<Term> made;
    conjuncts(predicate, made);
    return made;
  }
  static std::vector<Term> denied(const Term& predicate) {
    if (predicate->kind == Kind::negation) return facts(predicate->children[0]);
    std::vector<Term> made = {node(Kind::negation, {predicate})};
    if (predicate->kind == Kind::disjunction) {
      made = denied(predicate->children[0]);
      for (const Term& more : denied(predicate->children[1])) made.push_back(more);
    }
    return made;
  }

  /// Walks a schema text, each predicate with the others, and then the terms behind it.
  void text(const SchemaText& text, const std::vector<Term>& behind) {
    for (const Declaration& one : text.declarations)
      if (one.form != Declaration::Form::included) term(one.term);
    Context outer = context_;
    budget_.spend(100 * outer.facts.size());
    const Expansion whole = expander_.text(text);
    std::set<Name> bound;
    for (const auto& [name, set] : whole.declared) bound.insert(name);
    for (const Declaration& one : text.declarations) bound.insert(one.names.begin(), one.names.end());
    std::erase_if(context_.facts, [&bound](const Term& fact) { return mentions(fact, bound); });
    for (const Name& name : bound) context_.declared.erase(name);
    join(context_, whole);
    budget_.spend(100 * whole.facts.size());
    for (const Predicate& one : text.predicates) term(one.term);
    for (const Term& one : behind) term(one);
    context_ = std::move(outer);
  }

  void term(const Term& term) {
    const Node& node = *term;
    if (node.text) return text(*node.text, node.children);
    const auto& parts = node.children;
    switch (node.kind) {
      case Kind::conjunction:
        with(facts(parts[1]), parts[0]);
        return with(facts(parts[0]), parts[1]);
      case Kind::disjunction:
        with(denied(parts[1]), parts[0]);
        return with(denied(parts[0]), parts[1]);
      case Kind::implication:
        this->term(parts[0]);
        return with(facts(parts[0]), parts[1]);
      case Kind::conditional:
        this->term(parts[0]);
        with(facts(parts[0]), parts[1]);
        return with(denied(parts[0]), parts[2]);
      default:
        for (const Term& part : parts) this->term(part);
    }
    if (node.kind == Kind::application) application(node);
  }

  void application(const Node& node) {
    const Term &function = node.children[0], &argument = node.children[1];
    if (function->kind != Kind::reference) return;
    const auto declared = context_.declared.find(function->name);
    if (declared == context_.declared.end() || !is_partial_arrow(declared->second)) return;
    if (Prover(expander_, context_, budget_).holds_for(argument, domain_of(function))) return;
    const std::string f = function->name.text(), x = to_unicode(argument);
    found_.push_back({file_, node.place, fmt::format("{} is applied to {}, where nothing says {} ∈ dom {}", f, x, x, f),
                      "expected an invariant or a guard that gives it", Defect::Severity::error});
  }

  const Expander& expander_;
  std::vector<Defect>& found_;
  std::string file_;
  Context context_;
  Budget budget_;
};

}  // namespace

std::vector<Defect> partial_applications(const Specification& specification, const Typing& typing) {
  std::vector<Defect> found;
  const Expander expander(specification, typing);
  Walker walker(expander, found);
  try {
    for (const Section& section : specification.sections) walker.section(section);
  } catch (const Budget::Spent&) {
    found.push_back(too_large(specification, "applications outside a domain"));
  }
  return found;
}

std::vector<Defect> review(const Specification& specification) {
  std::vector<Defect> found = specification.defects;
  const Typing typing = check(specification);
  found.insert(found.end(), typing.defects.begin(), typing.defects.end());
  const bool right = found.empty();
  for (const auto& check : {open_frames, unused_names, partial_applications})
    if (right || check != partial_applications)
      for (Defect& one : check(specification, typing)) found.push_back(std::move(one));
  return found;
}

}  // namespace durero::zed
