#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <ranges>
#include <set>
#include <unordered_map>
#include <unordered_set>

#include "durero/zed/print/print.hpp"
#include "durero/zed/review/review.hpp"
#include "zed/operators.hpp"
#include "zed/review/expand.hpp"
#include "zed/review/prover.hpp"
#include "zed/syntax/match.hpp"

namespace durero::zed {
namespace {

bool is_partial_arrow(const Term& set) {
  if (set->kind != Kind::reference) return false;
  const OperatorRow* row = operator_row(set->name.word);
  return row && row->arrow && row->arrow->function && !row->arrow->total;
}

/// The partial functions of a specification: the words of all names that are declared as one. Only such a name, perhaps
/// with strokes, has such a set in any text written out. A term that applies none of them needs no proof.
class PartialFunctions {
 public:
  explicit PartialFunctions(const Specification& specification) {
    for (const Section& section : specification.sections)
      for (const Paragraph& paragraph : section.paragraphs) {
        if (const auto* box = std::get_if<Schema>(&paragraph.form)) declared_in(box->text);
        if (const auto* box = std::get_if<Axiomatic>(&paragraph.form)) declared_in(box->text);
        if (const auto* definition = std::get_if<Definition>(&paragraph.form)) declared_in(definition->value);
        if (const auto* claim = std::get_if<Conjecture>(&paragraph.form)) declared_in(claim->claim.term);
      }
  }

  bool applied_in(const Term& term) const {
    if (term->kind == Kind::application && term->children[0]->kind == Kind::reference &&
        words_.contains(term->children[0]->name.word))
      return true;
    const auto here = [this](const Term& part) { return applied_in(part); };
    return (term->text && applied_in(*term->text)) || std::ranges::any_of(term->children, here);
  }
  bool applied_in(const SchemaText& text) const {
    return std::ranges::any_of(text.declarations, [this](const Declaration& each) { return applied_in(each.term); }) ||
           std::ranges::any_of(text.predicates, [this](const Predicate& each) { return applied_in(each.term); });
  }

 private:
  void declared_in(const SchemaText& text) {
    for (const Declaration& declaration : text.declarations) {
      if (is_partial_arrow(declaration.term))
        for (const Name& name : declaration.names) words_.insert(name.word);
      declared_in(declaration.term);
    }
    for (const Predicate& predicate : text.predicates) declared_in(predicate.term);
  }
  void declared_in(const Term& term) {
    if (term->text) declared_in(*term->text);
    for (const Term& child : term->children) declared_in(child);
  }

  std::unordered_set<std::string> words_;
};

class Walker {
 public:
  Walker(const Specification& specification, const Expander& expander, std::vector<Defect>& defects)
      : partial_(specification), expander_(expander), defects_(defects) {
    Before none;
    join(expander.axioms(), none);
  }

  void section(const Section& section) {
    file_ = section.file;
    for (const Paragraph& paragraph : section.paragraphs) {
      if (const auto* box = std::get_if<Schema>(&paragraph.form); box && partial_.applied_in(box->text))
        text(box->text, {});
      if (const auto* box = std::get_if<Axiomatic>(&paragraph.form); box && partial_.applied_in(box->text))
        text(box->text, {});
      if (const auto* definition = std::get_if<Definition>(&paragraph.form)) term(definition->value);
      if (const auto* claim = std::get_if<Conjecture>(&paragraph.form)) term(claim->claim.term);
    }
  }

 private:
  /// The sets that names were declared from before a scope; nothing for a name that was not declared.
  using Before = std::vector<std::pair<Name, std::optional<Term>>>;

  void join(const Expansion& more, Before& before) {
    context_.facts.insert(context_.facts.end(), more.facts.begin(), more.facts.end());
    for (const auto& [name, set] : more.declared) {
      forget(name, before);
      context_.declared.insert_or_assign(name, set);
    }
  }

  void forget(const Name& name, Before& before) {
    const auto entry = context_.declared.find(name);
    if (entry == context_.declared.end()) {
      before.emplace_back(name, std::nullopt);
      return;
    }
    before.emplace_back(name, std::move(entry->second));
    context_.declared.erase(entry);
  }

  void restore(Before& before) {
    for (auto& [name, set] : std::views::reverse(before)) {
      if (set)
        context_.declared.insert_or_assign(name, std::move(*set));
      else
        context_.declared.erase(name);
    }
  }

  std::size_t number_of(const Name& name) { return numbers_.try_emplace(name, numbers_.size()).first->second; }

  /// The numbers of the names that the fact mentions. Most facts recur, and so their names are kept.
  const std::vector<std::size_t>& names_of(const Term& fact) {
    auto& [kept, names] = names_[fact.get()];
    if (!kept) {
      kept = fact;  // no other fact gets this address while it is kept
      match::each_name(fact, [&, &of_fact = names](const Name& name) { of_fact.push_back(number_of(name)); });
      std::ranges::sort(names);
      names.erase(std::ranges::unique(names).begin(), names.end());
    }
    return names;
  }

  /// Forgets the facts about these names.
  void forget_facts(const std::set<Name>& bound) {
    std::vector<bool> is_bound;
    for (const Name& name : bound) {
      const std::size_t number = number_of(name);
      if (number >= is_bound.size()) is_bound.resize(number + 1);
      is_bound[number] = true;
    }
    const auto speaks_of_one = [&](const Term& fact) {
      return std::ranges::any_of(names_of(fact), [&](std::size_t n) { return n < is_bound.size() && is_bound[n]; });
    };
    std::erase_if(context_.facts,
                  [&](const Term& fact) { return speaks_of_one(fact) && match::mentions(fact, bound); });
  }

  /// Walks a term under additional facts.
  void with(const std::vector<Term>& more, const Term& then) {
    const std::size_t before = context_.facts.size();
    context_.facts.insert(context_.facts.end(), more.begin(), more.end());
    term(then);
    context_.facts.resize(before);
  }
  static std::vector<Term> facts(const Term& predicate) {
    std::vector<Term> terms;
    conjuncts(predicate, terms);
    return terms;
  }
  static std::vector<Term> denied(const Term& predicate) {
    if (predicate->kind == Kind::negation) return facts(predicate->children[0]);
    std::vector<Term> parts = {node(Kind::negation, {predicate})};
    if (predicate->kind == Kind::disjunction) {
      parts = denied(predicate->children[0]);
      for (const Term& more : denied(predicate->children[1])) parts.push_back(more);
    }
    return parts;
  }

  /// Walks a schema text, each predicate with the others, and then the terms behind it.
  void text(const SchemaText& text, const std::vector<Term>& behind) {
    for (const Declaration& declaration : text.declarations)
      if (declaration.form != Declaration::Form::included) term(declaration.term);
    std::vector<Term> outer = context_.facts;
    Before before;
    budget_.spend(100 * outer.size());
    const Expansion whole = expander_.text(text);
    std::set<Name> bound;
    for (const auto& [name, set] : whole.declared) bound.insert(name);
    for (const Declaration& declared : text.declarations) bound.insert(declared.names.begin(), declared.names.end());
    forget_facts(bound);
    for (const Name& name : bound) forget(name, before);
    join(whole, before);
    budget_.spend(100 * whole.facts.size());
    for (const Predicate& predicate : text.predicates) term(predicate.term);
    for (const Term& part : behind) term(part);
    context_.facts = std::move(outer);
    restore(before);
  }

  void term(const Term& term) {
    if (!partial_.applied_in(term)) return;
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
    if (proves_member(argument, domain_of(function), expander_, context_, budget_)) return;
    const std::string f = function->name.text(), x = to_unicode(argument);
    defects_.push_back({file_, node.place,
                        fmt::format("{} is applied to {}, where nothing says {} ∈ dom {}", f, x, x, f),
                        "expected an invariant or a guard that gives it", Defect::Severity::opinion});
  }

  PartialFunctions partial_;
  const Expander& expander_;
  std::vector<Defect>& defects_;
  std::string file_;
  Facts context_;
  std::unordered_map<Name, std::size_t> numbers_;
  std::unordered_map<const Node*, std::pair<Term, std::vector<std::size_t>>> names_;
  Budget budget_;
};

}  // namespace

std::vector<Defect> partial_applications(const Specification& specification, const Typing& typing) {
  std::vector<Defect> defects;
  const Expander expander(specification, typing);
  Walker walker(specification, expander, defects);
  try {
    for (const Section& section : specification.sections) walker.section(section);
  } catch (const Budget::Spent&) {
    defects.push_back(too_large(specification, "applications outside a domain"));
  }
  return defects;
}

}  // namespace durero::zed
