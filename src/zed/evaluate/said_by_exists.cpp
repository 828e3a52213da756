#include "zed/evaluate/said_by_exists.hpp"

#include <algorithm>
#include <set>

#include "zed/evaluate/substitute.hpp"
#include "zed/syntax/match.hpp"

namespace durero::zed {
namespace {

Term both_of(const Term& a, const Term& b) { return node(Kind::conjunction, {a, b}, a->place); }

Term exists_of(SchemaText text, const Term& body, Place place) {
  Node made = *node(Kind::exists, {body}, place);
  made.text = std::make_shared<const SchemaText>(std::move(text));
  return make(std::move(made));
}

/// Says whether a term binds names.
bool binds_names(const Term& term) { return term->text || std::ranges::any_of(term->children, binds_names); }

/// Says whether a set of the text mentions a name that the text declares, and so another one of this name.
bool mentions_its_names(const SchemaText& text) {
  std::set<Name> own;
  for (const Declaration& each : text.declarations) own.insert(each.names.begin(), each.names.end());
  return std::ranges::any_of(text.declarations, [&](const auto& each) { return match::mentions(each.term, own); });
}

/// The names that nobody can write for those of a text.
std::map<Name, Term> other_names(const SchemaText& text) {
  std::map<Name, Term> others;
  for (const Declaration& each : text.declarations)
    for (const Name& name : each.names)
      others.emplace(name, reference(Name{"another " + name.word.text(), name.strokes}));
  return others;
}

}  // namespace

std::optional<Term> just_one_by_exists(const Node& exists_one, const Definitions& definitions) {
  // P and Q are written twice, and each level of binders in them would be.
  if (binds_names(exists_one.children[0]) || mentions_its_names(*exists_one.text) ||
      std::ranges::any_of(exists_one.text->predicates, binds_names, &Predicate::term))
    return std::nullopt;
  SchemaText other = *exists_one.text;
  const std::map<Name, Term> others = other_names(other);
  const Place place = exists_one.place;
  Term same;
  for (Declaration& each : other.declarations) {
    if (each.form != Declaration::Form::typed) return std::nullopt;
    for (Name& name : each.names) {
      const Term& replaced = others.at(name);
      const Term equal = relation({{"_=_", ""}}, {replaced, reference(name)}, place);
      same = same ? both_of(same, equal) : equal;
      name = replaced->name;
    }
  }
  for (Predicate& each : other.predicates) {
    const auto replaced = substituted(each.term, others, definitions);
    if (!replaced) return std::nullopt;
    each.term = *replaced;
  }
  const auto body = substituted(exists_one.children[0], others, definitions);
  if (!body || !same) return std::nullopt;
  const Term another = exists_of(std::move(other), both_of(*body, node(Kind::negation, {same}, place)), place);
  return exists_of(*exists_one.text, both_of(exists_one.children[0], node(Kind::negation, {another}, place)), place);
}

std::optional<Term> emptiness_by_exists(const Node& relation, const std::function<bool(const Name&)>& is_toolkit) {
  if (relation.names.size() != 1 || relation.children.size() != 2) return std::nullopt;
  const bool equal = relation.names[0].word == "_=_";
  if (!equal && relation.names[0].word != "_≠_") return std::nullopt;
  const Term* found = match::comprehension_beside_empty(relation.children[0], relation.children[1], is_toolkit);
  if (!found || !(*found)->children.empty()) return std::nullopt;
  const Term some = exists_of(*(*found)->text, node(Kind::truth, {}), relation.place);
  return equal ? node(Kind::negation, {some}, relation.place) : some;
}

}  // namespace durero::zed
