#include "durero/zed/evaluate/unfold.hpp"

#include <algorithm>

#include "zed/evaluate/substitute.hpp"
#include "zed/syntax/match.hpp"

namespace durero::zed {
namespace {

/// A schema text without inclusions: each name with its set, and what holds of them.
struct Flat {
  std::vector<std::pair<Name, Term>> declared;
  std::vector<Term> facts;

  const Term* set_of(const Name& name) const {
    for (const auto& [each, set] : declared)
      if (each == name) return &set;
    return nullptr;
  }
};

Term member(const Name& name, const Term& set) { return relation({{"_∈_", {}}}, {reference(name), set}); }

void add_fact(std::vector<Term>& facts, const Term& fact) {
  if (fact->kind == Kind::conjunction) {
    for (const Term& part : fact->children) add_fact(facts, part);
  } else if (fact->kind != Kind::truth && std::find(facts.begin(), facts.end(), fact) == facts.end()) {
    facts.push_back(fact);
  }
}

Term all_of_facts(const std::vector<Term>& facts) {
  if (facts.empty()) return node(Kind::truth, {});
  Term all = facts[0];
  for (std::size_t i = 1; i < facts.size(); ++i) all = node(Kind::conjunction, {all, facts[i]});
  return all;
}

/// A name that both declare is in both sets.
Flat merged(Flat a, const Flat& b) {
  for (const auto& [name, set] : b.declared) {
    const Term* known = a.set_of(name);
    if (!known) {
      a.declared.emplace_back(name, set);
    } else if (!(*known == set)) {
      add_fact(a.facts, member(name, set));
    }
  }
  for (const Term& fact : b.facts) add_fact(a.facts, fact);
  return a;
}

class Unfolder {
 public:
  Unfolder(const Definitions& definitions, const Carriers& carriers) : definitions_(definitions), carriers_(carriers) {}

  using Result = std::optional<Flat>;

  Result flat(const Term& term) {
    if (++depth_ > most_inclusions) return std::nullopt;
    Result result = flat_of(*term);
    --depth_;
    return result;
  }

 private:
  static constexpr int most_inclusions = 100;

  Result flat_of(const Node& term) {
    switch (term.kind) {
      case Kind::reference:
        return term.children.empty() ? named(term.name) : std::nullopt;
      case Kind::schema_text:
        return text(*term.text);
      case Kind::decoration:
        return renamed(term.children[0], [&](const Name& name) { return decorated(name, term.name.strokes); });
      case Kind::renaming:
        return renamed(term.children[0], [&](const Name& name) {
          for (std::size_t i = 0; i + 1 < term.names.size(); i += 2)
            if (name == term.names[i + 1]) return term.names[i];
          return name;
        });
      case Kind::hiding:
        return hidden(flat(term.children[0]), term.names);
      case Kind::precondition:
        return hidden(flat(term.children[0]), hidden_by_pre(term.children[0], definitions_));
      case Kind::conjunction: {
        const Result left = flat(term.children[0]), right = flat(term.children[1]);
        return left && right ? Result(merged(*left, *right)) : std::nullopt;
      }
      case Kind::disjunction:
      case Kind::implication:
      case Kind::equivalence:
        return joined_by(term.kind, flat(term.children[0]), flat(term.children[1]));
      case Kind::negation:
        return negated(flat(term.children[0]));
      default:
        return std::nullopt;
    }
  }

  Result named(const Name& name) {
    if (const Meaning* meaning = definitions_.find(name)) {
      if (const auto* box = std::get_if<Schema>(&meaning->paragraph->form))
        return box->formals.empty() ? text(box->text) : std::nullopt;
      const auto* definition = std::get_if<Definition>(&meaning->paragraph->form);
      return definition && definition->formals.empty() ? flat(definition->value) : std::nullopt;
    }
    for (const bool unchanged : {false, true}) {
      const auto of = implicit(name, unchanged ? "Ξ" : "Δ", definitions_);
      if (!of) continue;
      const Result before = flat(reference(*of));
      const Result after = renamed(reference(*of), [](const Name& each) { return decorated(each, "'"); });
      if (!before || !after) return std::nullopt;
      Flat both = merged(*before, *after);
      for (const auto& [each, set] : before->declared)
        if (unchanged)
          add_fact(both.facts, relation({{"_=_", {}}}, {reference(decorated(each, "'")), reference(each)}));
      return both;
    }
    return std::nullopt;
  }

  Result text(const SchemaText& text) {
    Flat whole;
    for (const Declaration& declaration : text.declarations) {
      if (declaration.form == Declaration::Form::included) {
        const Result part = flat(declaration.term);
        if (!part) return std::nullopt;
        whole = merged(std::move(whole), *part);
        continue;
      }
      if (declaration.form == Declaration::Form::defined) return std::nullopt;
      Flat own;
      for (const Name& name : declaration.names) own.declared.emplace_back(name, declaration.term);
      whole = merged(std::move(whole), own);
    }
    for (const Predicate& predicate : text.predicates) {
      const auto said = written_out(predicate.term);
      if (!said) return std::nullopt;
      add_fact(whole.facts, *said);
    }
    return whole;
  }

  /// A predicate in which no schema stands in the place of one.
  std::optional<Term> written_out(const Term& predicate) {
    if (components(predicate, definitions_)) {
      const Result schema = flat(predicate);
      if (!schema) return std::nullopt;
      std::vector<Term> facts;
      for (const auto& [name, set] : schema->declared) add_fact(facts, member(name, set));
      for (const Term& fact : schema->facts) add_fact(facts, fact);
      return all_of_facts(facts);
    }
    return predicate;
  }

  template <class New>
  Result renamed(const Term& schema, New&& new_name) {
    Result of = flat(schema);
    if (!of) return of;
    std::map<Name, Term> by;
    for (auto& [name, set] : of->declared) {
      const Name now = new_name(name);
      if (!(now == name)) by.emplace(name, reference(now));
      name = now;
    }
    for (Term& fact : of->facts) {
      auto now = through_theta(fact, by);
      if (!now) return std::nullopt;
      fact = std::move(*now);
    }
    return of;
  }

  std::optional<Term> through_theta(const Term& fact, const std::map<Name, Term>& by) const {
    return substituted(fact, by, definitions_);
  }

  /// ∃ names • the schema.
  Result hidden(Result of, const Components& names) {
    if (!of) return of;
    Flat rest;
    std::vector<std::pair<Name, Term>> inside;
    for (const auto& each : of->declared) {
      const bool hides = std::find(names.begin(), names.end(), each.first) != names.end();
      (hides ? inside : rest.declared).push_back(each);
    }
    std::vector<Term> facts = of->facts;
    while (eliminate_one(inside, facts)) {
    }
    SchemaText bound;
    std::vector<Term> under;
    for (const auto& [name, set] : inside)
      bound.declarations.push_back({Declaration::Form::typed, {name}, {Place{}}, set, {}});
    for (const Term& fact : facts) {
      const bool about = std::any_of(inside.begin(), inside.end(), [&, &each_fact = fact](const auto& each) {
        return depends_on(each_fact, each.first, definitions_);
      });
      about ? add_fact(under, fact) : add_fact(rest.facts, fact);
    }
    if (!inside.empty()) rest.facts.push_back(quantified(Kind::exists, std::move(bound), {all_of_facts(under)}));
    return rest;
  }

  /// ∃ x : T • x = e ∧ P is e ∈ T ∧ P with e for x, where e does not depend on x.
  bool eliminate_one(std::vector<std::pair<Name, Term>>& inside, std::vector<Term>& facts) const {
    for (std::size_t i = 0; i < inside.size(); ++i)
      for (std::size_t j = 0; j < facts.size(); ++j) {
        if (!match::is_equation(facts[j])) continue;
        for (const std::size_t side : {0U, 1U}) {
          const Term value = facts[j]->children[1 - side];
          const Name name = inside[i].first;
          if (!match::is_reference(facts[j]->children[side], name) || depends_on(value, name, definitions_)) continue;
          if (replace(name, value, inside[i].second, j, facts)) {
            inside.erase(inside.begin() + static_cast<std::ptrdiff_t>(i));
            return true;
          }
        }
      }
    return false;
  }

  bool replace(const Name& name, const Term& value, const Term& set, std::size_t at, std::vector<Term>& facts) const {
    std::vector<Term> now;
    for (std::size_t j = 0; j < facts.size(); ++j) {
      if (j == at) {
        if (!is_whole_type(set)) add_fact(now, relation({{"_∈_", {}}}, {value, set}));
        continue;
      }
      const auto fact = substituted(facts[j], {{name, value}}, definitions_);
      if (!fact) return false;
      if (!match::is_equation(*fact) || !((*fact)->children[0] == (*fact)->children[1])) add_fact(now, *fact);
    }
    facts = std::move(now);
    return true;
  }

  /// Every value of its type is a member: of a given set, of a free type, of 𝔸, and of what ℙ and × make of these.
  bool is_whole_type(const Term& set) const {
    if (set->kind == Kind::power || set->kind == Kind::product)
      return std::all_of(set->children.begin(), set->children.end(),
                         [this](const Term& part) { return is_whole_type(part); });
    if (set->kind != Kind::reference || !set->children.empty()) return false;
    const Meaning* meaning = definitions_.find(set->name);
    return meaning ? meaning->kind == Meaning::Kind::given || meaning->kind == Meaning::Kind::free_type
                   : set->name.text() == "𝔸";
  }

  /// What the sets of its declarations say is a part of what the schema says where it is negated, and where the other
  /// side declares the name otherwise.
  std::optional<Term> said_by(const Flat& flat, const Flat& declared) const {
    std::vector<Term> facts;
    for (const auto& [name, set] : flat.declared)
      if (!(*declared.set_of(name) == set) && !is_whole_type(set)) add_fact(facts, member(name, set));
    for (const Term& fact : flat.facts) add_fact(facts, fact);
    return all_of_facts(facts);
  }

  Result declared_widely(const Flat& a, const Flat& b, bool keep_common) const {
    Flat wide;
    for (const Flat* side : {&a, &b})
      for (const auto& [name, set] : side->declared) {
        if (wide.set_of(name)) continue;
        const Term *in_a = a.set_of(name), *in_b = b.set_of(name);
        const bool common = keep_common && in_a && in_b && *in_a == *in_b;
        const Term whole = common || is_whole_type(set) ? set : carriers_(name);
        if (!whole) return std::nullopt;
        wide.declared.emplace_back(name, whole);
      }
    return wide;
  }

  Result joined_by(Kind kind, const Result& left, const Result& right) const {
    if (!left || !right) return std::nullopt;
    Result whole = declared_widely(*left, *right, kind == Kind::disjunction);
    if (!whole) return whole;
    const auto a = said_by(*left, *whole), b = said_by(*right, *whole);
    Flat common;
    std::vector<Term> facts_a, facts_b;
    add_fact(facts_a, *a);
    add_fact(facts_b, *b);
    if (kind == Kind::disjunction) {  // what both sides say stands before them
      for (const Term& fact : facts_a)
        if (std::find(facts_b.begin(), facts_b.end(), fact) != facts_b.end()) whole->facts.push_back(fact);
      const auto in_both = [&](const Term& fact) {
        return std::find(whole->facts.begin(), whole->facts.end(), fact) != whole->facts.end();
      };
      std::erase_if(facts_a, in_both);
      std::erase_if(facts_b, in_both);
      if (facts_a.empty() || facts_b.empty()) return whole;
    }
    whole->facts.push_back(node(kind, {all_of_facts(facts_a), all_of_facts(facts_b)}));
    return whole;
  }

  Result negated(const Result& of) const {
    if (!of) return of;
    Result whole = declared_widely(*of, *of, false);
    if (!whole) return whole;
    whole->facts.push_back(node(Kind::negation, {*said_by(*of, *whole)}));
    return whole;
  }

  const Definitions& definitions_;
  const Carriers& carriers_;
  int depth_ = 0;
};

}  // namespace

std::optional<Term> unfolded(const Term& schema, const std::vector<Section>& sections, const Carriers& carriers) {
  const Definitions definitions(sections);
  const auto flat = Unfolder(definitions, carriers).flat(schema);
  if (!flat) return std::nullopt;
  SchemaText text;
  for (const auto& [name, set] : flat->declared) {
    auto* last = text.declarations.empty() ? nullptr : &text.declarations.back();
    if (last && last->term == set) {
      last->names.push_back(name);
      last->places.emplace_back();
    } else {
      text.declarations.push_back({Declaration::Form::typed, {name}, {Place{}}, set, {}});
    }
  }
  for (const Term& fact : flat->facts) text.predicates.push_back({fact, {}, {}});
  return quantified(Kind::schema_text, std::move(text), {});
}

}  // namespace durero::zed
