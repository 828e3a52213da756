#include "claims.hpp"

#include <algorithm>

#include "machine_parts.hpp"

namespace durero::spec {

using zed::Name;

/// The names of the schemas that the text before the • includes, where it includes any and each is one of a state or a
/// step: no name of them is another of the text, which a set that is declared from might mean.
std::optional<std::vector<Name>> included_names(const zed::Typing& typing, const zed::Term& claim) {
  if (claim->kind != zed::Kind::forall) return std::nullopt;
  std::vector<Name> names;
  for (const zed::Declaration& declaration : claim->text->declarations) {
    if (declaration.form != zed::Declaration::Form::included) continue;
    const auto type = typing.type_of(declaration.term);
    if (!type || !type->is_schema_set()) return std::nullopt;
    const auto& fields = type->parts()[0].fields();
    names.insert(names.end(), fields.begin(), fields.end());
  }
  const bool free = std::none_of(names.begin(), names.end(), [&](const Name& name) {
    return typing.find(Machine::Parts::section_name, name) != nullptr;
  });
  return names.empty() || !free ? std::nullopt : std::optional(std::move(names));
}

/// ∀ S; D | P • Q of names of S that have values: S ⇒ (∀ D | P • Q).
zed::Term claim_instance(const zed::Term& claim) {
  zed::Term schemas = zed::node(zed::Kind::truth, {});
  zed::SchemaText rest = *claim->text;
  rest.declarations.clear();
  for (const zed::Declaration& declaration : claim->text->declarations) {
    if (declaration.form == zed::Declaration::Form::included)
      schemas = zed::node(zed::Kind::conjunction, {schemas, declaration.term});
    else
      rest.declarations.push_back(declaration);
  }
  if (!rest.declarations.empty())
    return zed::node(zed::Kind::implication, {schemas, zed::quantified(zed::Kind::forall, std::move(rest),
                                                                       {claim->children[0]}, claim->place)});
  for (const zed::Predicate& predicate : rest.predicates)
    schemas = zed::node(zed::Kind::conjunction, {schemas, predicate.term});
  return zed::node(zed::Kind::implication, {schemas, claim->children[0]});
}

}  // namespace durero::spec
