#include "zed/evaluate/flat.hpp"

#include <algorithm>

#include "zed/evaluate/substitute.hpp"
#include "zed/syntax/match.hpp"

namespace durero::zed {

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

bool is_whole_type(const Term& set, const Definitions& definitions) {
  if (set->kind == Kind::power || set->kind == Kind::product)
    return std::all_of(set->children.begin(), set->children.end(),
                       [&](const Term& part) { return is_whole_type(part, definitions); });
  if (set->kind != Kind::reference || !set->children.empty()) return false;
  const Meaning* meaning = definitions.find(set->name);
  return meaning ? meaning->kind == Meaning::Kind::given || meaning->kind == Meaning::Kind::free_type
                 : set->name.text() == "𝔸";
}

namespace {

class Hiding {
 public:
  explicit Hiding(const Definitions& definitions) : definitions_(definitions) {}

  Flat hidden(const Flat& of, const Components& names) const {
    Flat rest;
    std::vector<std::pair<Name, Term>> inside;
    for (const auto& each : of.declared) {
      const bool hides = std::find(names.begin(), names.end(), each.first) != names.end();
      (hides ? inside : rest.declared).push_back(each);
    }
    std::vector<Term> facts = of.facts;
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

 private:
  /// Replaces ∃ x : T • x = e ∧ P by e ∈ T ∧ P with e for x, where e does not depend on x.
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
        if (!is_whole_type(set, definitions_)) add_fact(now, relation({{"_∈_", {}}}, {value, set}));
        continue;
      }
      const auto fact = substituted(facts[j], {{name, value}}, definitions_);
      if (!fact) return false;
      if (!match::is_equation(*fact) || !((*fact)->children[0] == (*fact)->children[1])) add_fact(now, *fact);
    }
    facts = std::move(now);
    return true;
  }

  const Definitions& definitions_;
};

}  // namespace

Flat hidden(const Flat& of, const Components& names, const Definitions& definitions) {
  return Hiding(definitions).hidden(of, names);
}

}  // namespace durero::zed
