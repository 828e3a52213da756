#include "zed/trial/claim.hpp"

#include <algorithm>

#include "zed/syntax/match.hpp"

namespace durero::zed {
namespace {

Paragraph definition(const Name& name, SchemaText text) {
  return {{}, Definition{name, {}, quantified(Kind::schema_text, std::move(text), {}), {}}};
}

/// The conjuncts of what a schema text says of its names.
void add_conjuncts(const Term& term, std::vector<Term>& to) {
  if (term->kind != Kind::conjunction) return to.push_back(term);
  for (const Term& part : term->children) add_conjuncts(part, to);
}

/// The names in a term, in the order in which they are written; outside of schema texts, which bind others.
void add_names(const Term& term, std::vector<Name>& to) {
  if (term->kind == Kind::reference) to.push_back(term->name);
  for (const Term& part : term->children) add_names(part, to);
}

}  // namespace

QuantifiedClaim::QuantifiedClaim(const Term& term, std::size_t number)
    : whole(term),
      assumed_name{" assumed " + std::to_string(number), ""},
      claimed_name{" claimed " + std::to_string(number), ""},
      denied_name{" denied " + std::to_string(number), ""} {
  const bool quantified = term->kind == Kind::forall || term->kind == Kind::exists;
  if (quantified) assumed = *term->text;
  wants_witness = term->kind == Kind::exists;
  claimed = assumed;
  const Term& said = quantified ? term->children[0] : term;
  claimed.predicates.push_back({said, {}, term->place});
  denied = assumed;
  denied.predicates.push_back({node(Kind::negation, {said}), {}, term->place});
}

std::vector<Paragraph> QuantifiedClaim::definitions() const {
  return {definition(assumed_name, assumed), definition(claimed_name, claimed), definition(denied_name, denied)};
}

std::vector<Name> made_by_conjuncts(const SchemaText& text) {
  std::vector<Name> met, made;
  const auto is_new = [&](const Name& name) {
    return std::find(met.begin(), met.end(), name) == met.end() &&
           std::any_of(text.declarations.begin(), text.declarations.end(), [&](const Declaration& declaration) {
             return std::find(declaration.names.begin(), declaration.names.end(), name) != declaration.names.end();
           });
  };
  std::vector<Term> conjuncts;
  for (const Predicate& predicate : text.predicates) add_conjuncts(predicate.term, conjuncts);
  for (const Term& conjunct : conjuncts) {
    std::vector<Name> names;
    add_names(conjunct, names);
    if (match::is_equation(conjunct) && conjunct->children[0]->kind == Kind::reference)
      names.push_back(conjunct->children[0]->name);
    const auto last = std::find_if(names.rbegin(), names.rend(), is_new);
    if (last != names.rend()) made.push_back(*last);
    met.insert(met.end(), names.begin(), names.end());
  }
  return made;
}

}  // namespace durero::zed
