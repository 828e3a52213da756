#include "durero/zed/evaluate/unfold.hpp"

#include <algorithm>

#include "zed/evaluate/connectives.hpp"
#include "zed/evaluate/substitute.hpp"
#include "zed/syntax/match.hpp"

namespace durero::zed {
namespace {

class Unfolder {
 public:
  Unfolder(const Definitions& definitions, const Carriers& carriers, const Actuals& actuals)
      : definitions_(definitions), actuals_(actuals), connectives_(definitions, carriers) {}

  using Result = std::optional<Flat>;

  Result flat(const Term& term) {
    if (++depth_ > most_inclusions) return std::nullopt;
    Result result = flat_of(term);
    --depth_;
    return result;
  }

 private:
  static constexpr int most_inclusions = 100;

  Result flat_of(const Term& whole) {
    const Node& term = *whole;
    switch (term.kind) {
      case Kind::reference:
        return term.children.empty() ? named(whole) : instance(term.name, term.children);
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
        return joined_by(&Connectives::projection, term);
      case Kind::forall:
      case Kind::exists:
      case Kind::exists_one: {
        const Result bound = text(*term.text), of = flat(term.children[0]);
        return bound && of ? connectives_.quantified(term.kind, *bound, *of) : std::nullopt;
      }
      case Kind::conjunction: {
        const Result left = flat(term.children[0]), right = flat(term.children[1]);
        return left && right ? Result(merged(*left, *right)) : std::nullopt;
      }
      case Kind::disjunction:
        return joined_by(&Connectives::disjunction, term);
      case Kind::implication:
        return joined_by(&Connectives::implication, term);
      case Kind::equivalence:
        return joined_by(&Connectives::equivalence, term);
      case Kind::negation: {
        const Result of = flat(term.children[0]);
        return of ? connectives_.negation(*of) : std::nullopt;
      }
      default:
        return std::nullopt;
    }
  }

  using Connective = Result (Connectives::*)(const Flat&, const Flat&) const;
  Result joined_by(Connective connective, const Node& term) {
    const Result left = flat(term.children[0]), right = flat(term.children[1]);
    return left && right ? (connectives_.*connective)(*left, *right) : std::nullopt;
  }

  Result named(const Term& term) {
    const Name& name = term->name;
    if (const Meaning* meaning = definitions_.find(name)) {
      const auto* box = std::get_if<Schema>(&meaning->paragraph->form);
      const auto* definition = std::get_if<Definition>(&meaning->paragraph->form);
      if (!box && !definition) return std::nullopt;
      if ((box ? box->formals : definition->formals).empty()) return box ? text(box->text) : flat(definition->value);
      const auto actuals = actuals_ ? actuals_(term) : std::nullopt;
      return actuals ? instance(name, *actuals) : std::nullopt;
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

  /// Writes out an instance of a generic schema: the actuals stand for the formals.
  Result instance(const Name& name, const std::vector<Term>& actuals) {
    const Meaning* meaning = definitions_.find(name);
    if (!meaning) return std::nullopt;
    const auto* box = std::get_if<Schema>(&meaning->paragraph->form);
    const auto* definition = std::get_if<Definition>(&meaning->paragraph->form);
    if (!box && !definition) return std::nullopt;
    const std::vector<Name>& formals = box ? box->formals : definition->formals;
    if (formals.size() != actuals.size()) return std::nullopt;
    std::map<Name, Term> by;
    for (std::size_t i = 0; i < formals.size(); ++i) by.emplace(formals[i], actuals[i]);
    const auto now =
        substituted(box ? quantified(Kind::schema_text, box->text, {}) : definition->value, by, definitions_);
    return now ? flat(*now) : std::nullopt;
  }

  Result without(const Result& of, const Components& names) const {
    return of ? Result(hidden(*of, names, definitions_)) : std::nullopt;
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

  /// Returns x ′ = x for each component x of S where the predicate is θS ′ = θS; nothing for any other predicate.
  std::vector<Term> equal_components(const Term& predicate) const {
    if (!match::is_equation(predicate)) return {};
    const Node &left = *predicate->children[0], &right = *predicate->children[1];
    if (left.kind != Kind::theta || right.kind != Kind::theta) return {};
    auto names = components(left.children[0], definitions_), others = components(right.children[0], definitions_);
    if (!names || !others) return {};
    std::sort(names->begin(), names->end());
    std::sort(others->begin(), others->end());
    if (*names != *others) return {};
    std::vector<Term> equations;
    for (const Name& name : *names)
      equations.push_back(relation({{"_=_", {}}}, {reference(decorated(name, left.name.strokes)),
                                                   reference(decorated(name, right.name.strokes))}));
    return equations;
  }

  /// Returns the predicate with each schema in the place of a predicate written out.
  std::optional<Term> written_out(const Term& predicate) {
    if (const std::vector<Term> equations = equal_components(predicate); !equations.empty())
      return all_of_facts(equations);
    if (predicate->kind == Kind::conjunction && !components(predicate, definitions_)) {
      const auto left = written_out(predicate->children[0]), right = written_out(predicate->children[1]);
      return left && right ? std::optional(node(Kind::conjunction, {*left, *right})) : std::nullopt;
    }
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

  const Definitions& definitions_;
  const Actuals& actuals_;
  Connectives connectives_;
  int depth_ = 0;
};

}  // namespace

SchemaUnfolder::SchemaUnfolder(const std::vector<Section>& sections)
    : definitions_(std::make_shared<const Definitions>(sections)) {}

std::optional<Term> SchemaUnfolder::unfolded(const Term& schema, const Carriers& carriers,
                                             const Actuals& actuals) const {
  const auto flat = Unfolder(*definitions_, carriers, actuals).flat(schema);
  if (!flat) return std::nullopt;
  SchemaText text = declarations_of(flat->declared);
  for (const Term& fact : flat->facts) text.predicates.push_back({fact, {}, {}});
  return quantified(Kind::schema_text, std::move(text), {});
}

std::optional<Term> unfolded(const Term& schema, const std::vector<Section>& sections, const Carriers& carriers,
                             const Actuals& actuals) {
  return SchemaUnfolder(sections).unfolded(schema, carriers, actuals);
}

}  // namespace durero::zed
