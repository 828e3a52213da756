#include "durero/zed/evaluate/unfold.hpp"

#include <algorithm>

#include "zed/evaluate/flat.hpp"
#include "zed/evaluate/substitute.hpp"
#include "zed/syntax/match.hpp"

namespace durero::zed {
namespace {

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
        return term.children.empty() ? named(term.name) : instance(term);
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
        return without(flat(term.children[0]), term.names);
      case Kind::precondition:
        return without(flat(term.children[0]), hidden_by_pre(term.children[0], definitions_));
      case Kind::composition:
        return linked(term, "'", "");
      case Kind::piping:
        return linked(term, "!", "?");
      case Kind::projection:
        return projection(flat(term.children[0]), flat(term.children[1]));
      case Kind::exists: {
        const Result bound = text(*term.text), of = flat(term.children[0]);
        return bound && of ? without(merged(*bound, *of), components(*term.text, definitions_)) : std::nullopt;
      }
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

  /// Of a generic schema: the actuals stand for the formals.
  Result instance(const Node& term) {
    const Meaning* meaning = definitions_.find(term.name);
    if (!meaning) return std::nullopt;
    const auto* box = std::get_if<Schema>(&meaning->paragraph->form);
    const auto* definition = std::get_if<Definition>(&meaning->paragraph->form);
    if (!box && !definition) return std::nullopt;
    const std::vector<Name>& formals = box ? box->formals : definition->formals;
    if (formals.size() != term.children.size()) return std::nullopt;
    std::map<Name, Term> by;
    for (std::size_t i = 0; i < formals.size(); ++i) by.emplace(formals[i], term.children[i]);
    const auto now =
        substituted(box ? quantified(Kind::schema_text, box->text, {}) : definition->value, by, definitions_);
    return now ? flat(*now) : std::nullopt;
  }

  Result without(const Result& of, const Components& names) const {
    return of ? Result(hidden(*of, names, definitions_)) : std::nullopt;
  }

  /// S ⨡ T is S ∧ T without the components that only S has.
  Result projection(const Result& left, const Result& right) const {
    if (!left || !right) return std::nullopt;
    Components gone;
    for (const auto& [name, set] : left->declared)
      if (!right->set_of(name)) gone.push_back(name);
    return without(merged(*left, *right), gone);
  }

  /// S ⨟ T is ∃ x'' • S[x''/x'] ∧ T[x''/x] for the names x that they join, and S ⨠ T has x! and x? for x' and x. There
  /// are more strokes where x'' is a component already.
  Result linked(const Node& node, const std::string& stroke, const std::string& to) {
    const Term &left = node.children[0], &right = node.children[1];
    const std::vector<Name> names = joined(left, stroke, right, to, definitions_);
    const auto is_one = [&](const Name& name, const std::string& strokes) {
      return std::any_of(names.begin(), names.end(),
                         [&](const Name& each) { return name == decorated(each, strokes); });
    };
    std::string fresh = "''";
    for (const Term& side : {left, right})
      for (const Name& name : components(side, definitions_).value_or(Components{}))
        while (is_one(name, fresh)) fresh += "'";
    const auto link = [&](const std::string& strokes) {
      return [&, strokes](const Name& name) {
        const auto one = std::find_if(names.begin(), names.end(),
                                      [&](const Name& each) { return name == decorated(each, strokes); });
        return one == names.end() ? name : decorated(*one, fresh);
      };
    };
    const Result before = renamed(left, link(stroke)), behind = renamed(right, link(to));
    if (!before || !behind) return std::nullopt;
    Components between;
    for (const Name& name : names) between.push_back(decorated(name, fresh));
    return without(merged(*before, *behind), between);
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

  /// What the sets of its declarations say is a part of what the schema says where it is negated, and where the other
  /// side declares the name otherwise.
  std::optional<Term> said_by(const Flat& flat, const Flat& declared) const {
    std::vector<Term> facts;
    for (const auto& [name, set] : flat.declared)
      if (!(*declared.set_of(name) == set) && !is_whole_type(set, definitions_)) add_fact(facts, member(name, set));
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
        const Term whole = common || is_whole_type(set, definitions_) ? set : carriers_(name);
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
