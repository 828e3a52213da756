#include "zed/review/determine.hpp"

#include <algorithm>
#include <array>

#include "zed/operators.hpp"
#include "zed/syntax/match.hpp"

namespace durero::zed {
namespace {

constexpr unsigned max_schemas = 100;

/// Returns the relation that holds just where this one does not, or nothing if that has no name of its own.
std::string_view opposite(const Name& relation) {
  const OperatorRow* row = operator_row(relation.word);
  return row ? row->opposite : std::string_view();
}

/// One of ¬ p and p holds, and one of a = b and a ≠ b.
bool are_cases(const Term& p, const Term& q) {
  const auto denies = [](const Term& a, const Term& b) { return a->kind == Kind::negation && a->children[0] == b; };
  const auto single = [](const Term& a) { return a->kind == Kind::relation && a->names.size() == 1; };
  return denies(p, q) || denies(q, p) ||
         (single(p) && single(q) && p->names[0].word == opposite(q->names[0]) && p->children == q->children);
}

}  // namespace

/// Returns the components of S, or S ⧹ (x), of a schema with a name; nothing of any other.
std::set<Name> Determiner::components(const Term& schema) const {
  if (schema->kind == Kind::reference) return expander_.components(schema->name);
  std::set<Name> names;
  if (schema->kind == Kind::hiding) names = components(schema->children[0]);
  for (const Name& hidden : schema->names) names.erase(hidden);
  return names;
}

/// Returns the names that θS ′ takes its components from.
std::vector<Name> Determiner::bound_by_theta(const Node& theta) const {
  std::vector<Name> names;
  for (const Name& name : components(theta.children[0]))
    names.push_back({name.word, name.strokes + theta.name.strokes});
  return names;
}

/// Returns the parts of a tuple by their numbers, and those of a binding by their names; nothing of any other term.
std::map<Name, Term> Determiner::parts(const Term& term) const {
  std::map<Name, Term> parts;
  if (term->kind == Kind::tuple)
    for (std::size_t i = 0; i < term->children.size(); ++i)
      parts.emplace(Name{std::to_string(i + 1), {}}, term->children[i]);
  if (term->kind == Kind::binding_extension)
    for (std::size_t i = 0; i < term->children.size(); ++i) parts.emplace(term->names[i], term->children[i]);
  if (term->kind == Kind::theta)
    for (const Name& name : bound_by_theta(*term))
      parts.emplace(Name{name.word, name.strokes.substr(0, name.strokes.size() - term->name.strokes.size())},
                    reference(name));
  return parts;
}

/// Says whether a term mentions an open component, by its name or behind θ.
bool Determiner::refers(const Term& term, const std::set<Name>& open) const {
  if (term->kind == Kind::reference && open.contains(term->name)) return true;
  if (term->kind == Kind::theta) {
    const std::vector<Name> names = bound_by_theta(*term);
    return names.empty() ||
           std::any_of(names.begin(), names.end(), [&](const Name& name) { return open.contains(name); });
  }
  const auto below = [&](const Term& part) { return refers(part, open); };
  if (std::any_of(term->children.begin(), term->children.end(), below)) return true;
  if (!term->text) return false;
  const auto& [declarations, predicates] = *term->text;
  return std::any_of(declarations.begin(), declarations.end(), [&](const auto& part) { return below(part.term); }) ||
         std::any_of(predicates.begin(), predicates.end(), [&](const auto& part) { return below(part.term); });
}

/// A pattern that equals a known value determines its components: those of tuples and bindings, and an operand of a sum
/// or difference whose other operand is known.
void Determiner::by_value(std::set<Name>& open, const Term& pattern, const Term& value) {
  if (pattern->kind == Kind::reference && open.contains(pattern->name) && !refers(value, open))
    open.erase(pattern->name);
  for (const auto& [name, part] : parts(pattern)) by_value(open, part, value);
  if (const Term* negated = match::argument_of(pattern, "-_")) by_value(open, *negated, value);
  for (const std::string_view sum : {"_+_", "_-_"})
    if (const Node* both = match::operands(pattern, sum))
      for (const std::size_t side : {0U, 1U})
        if (!refers(both->children[1 - side], open)) by_value(open, both->children[side], value);
}

/// x' = e determines x', either way round; equal tuples and bindings have equal parts.
void Determiner::by_equation(std::set<Name>& open, const Term& left, const Term& right) {
  const std::map<Name, Term> a = parts(left), b = parts(right);
  const auto same = [](const auto& one, const auto& other) { return one.first == other.first; };
  if (!a.empty() && std::equal(a.begin(), a.end(), b.begin(), b.end(), same)) {
    for (const auto& [name, part] : a) by_equation(open, part, b.at(name));
    return;
  }
  by_value(open, left, right);
  by_value(open, right, left);
}

/// A disjunction determines what each of its sides does, as one of them holds.
void Determiner::by_sides(std::set<Name>& open, const std::vector<Term>& sides) {
  std::set<Name> either;
  for (const Term& side : sides) {
    std::set<Name> left_open = open;
    determine(left_open, {side});
    either.merge(left_open);
  }
  open = std::move(either);
}

/// p ⇒ P and ¬ p ⇒ Q determine what P and Q both do.
void Determiner::by_cases(std::set<Name>& open, const std::vector<Term>& facts) {
  std::vector<const Node*> implications;
  for (const Term& term : facts)
    if (term->kind == Kind::implication) implications.push_back(&*term);
  budget_.spend(10 * implications.size() * implications.size());
  for (std::size_t i = 0; i < implications.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const std::vector<Term>&left = implications[i]->children, &right = implications[j]->children;
      if (are_cases(left[0], right[0])) by_sides(open, {left[1], right[1]});
    }
}

/// In ∃ D | P • Q and let D • Q the variables are open too, until P, Q or their definition determines them.
void Determiner::by_body(std::set<Name>& open, const Node& node) {
  std::set<Name> inside = open;
  std::vector<Term> facts = node.children;
  for (const Declaration& declaration : node.text->declarations) {
    if (declaration.form == Declaration::Form::included) return;
    for (const Name& name : declaration.names) {
      if (!inside.insert(name).second) return;  // a variable hides the component
      if (declaration.form == Declaration::Form::defined)
        facts.push_back(relation({{"_=_", {}}}, {reference(name), declaration.term}));
    }
  }
  for (const Predicate& predicate : node.text->predicates) facts.push_back(predicate.term);
  determine(inside, facts);
  std::erase_if(open, [&inside](const Name& name) { return !inside.contains(name); });
}

/// A schema as a predicate determines what its text determines, and so does Ξ. A part that cannot be written out may
/// determine any component of the schema, and so these count as determined.
void Determiner::by_schema(std::set<Name>& open, const Term& schema) {
  if (schemas_ == max_schemas) return;
  const Expansion whole = expander_.schema(schema);
  budget_.spend(100 * whole.facts.size());
  ++schemas_;
  determine(open, whole.facts);
  --schemas_;
  if (!whole.opaque) return;
  const std::set<Name> spoken_of = expander_.spoken_of(schema);
  std::erase_if(open, [&](const Name& name) { return spoken_of.empty() || spoken_of.contains(name); });
}

void Determiner::by_fact(std::set<Name>& open, const Term& fact) {
  if (match::is_equation(fact)) by_equation(open, fact->children[0], fact->children[1]);
  if (fact->kind == Kind::disjunction) by_sides(open, fact->children);
  if (fact->kind == Kind::exists || fact->kind == Kind::let) by_body(open, *fact);
  static constexpr std::array schemas = {Kind::reference,  Kind::decoration,  Kind::renaming, Kind::hiding,
                                         Kind::projection, Kind::composition, Kind::piping};
  if (std::find(schemas.begin(), schemas.end(), fact->kind) != schemas.end()) by_schema(open, fact);
}

void Determiner::determine(std::set<Name>& open, const std::vector<Term>& conjunctions) {
  if (open.empty()) return;
  std::vector<Term> facts;
  for (const Term& term : conjunctions) conjuncts(term, facts);
  for (std::size_t before = open.size() + 1; !open.empty() && open.size() < before;) {
    before = open.size();
    budget_.spend(10 * facts.size());
    for (const Term& part : facts) by_fact(open, part);
    by_cases(open, facts);
  }
}

}  // namespace durero::zed
