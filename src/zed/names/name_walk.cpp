#include "zed/names/name_walk.hpp"

#include <algorithm>
#include <array>
#include <ranges>
#include <utility>

#include "zed/syntax/symbols.hpp"
#include "zed/types/toolkit.hpp"

namespace durero::zed {
namespace {

constexpr std::array<std::string_view, 2> doubling_signs = {"Δ", "Ξ"};

/// The type of the members of a set.
std::optional<Type> member_type(const std::optional<Type>& set) {
  if (!set || !set->is(Type::Kind::power)) return std::nullopt;
  return set->parts()[0];
}

}  // namespace

std::size_t NameWalk::global(const Global& of) {
  const auto [at, added] = globals_.try_emplace(&of, 0);
  if (added) at->second = table_.add({Referent::Form::global, of.name});
  return at->second;
}

std::size_t NameWalk::toolkit_name(const Name& name) {
  const auto [at, added] = toolkit_names_.try_emplace(name, 0);
  if (added) at->second = table_.add({Referent::Form::toolkit, name});
  return at->second;
}

/// Looks a name up as the type-checker does: scopes, globals, the toolkit, and ΔS or ΞS of a schema S.
NameWalk::Meaning NameWalk::meaning_of(const Name& name) {
  for (const NameScope& scope : std::views::reverse(scopes_))
    if (const auto at = std::ranges::find(scope, name, &ScopedName::name); at != scope.end())
      return {at->referent, {}, {}};
  if (const Global* declared = typing_.find(section_->name, name)) {
    const auto schema = schemas_.find(declared);
    return {global(*declared), schema == schemas_.end() ? std::nullopt : std::optional(schema->second), {}};
  }
  const auto seen = typing_.toolkit.find(section_->name);
  if (toolkit_scheme(name, seen == typing_.toolkit.end() ? ToolkitSections() : seen->second))
    return {toolkit_name(name), {}, {}};
  for (const std::string_view sign : doubling_signs) {
    if (!name.word.starts_with(sign) || name.word.size() == sign.size() || !name.strokes.empty()) continue;
    Meaning base = meaning_of({name.word.substr(sign.size()), {}});
    if (!base.components) return {base.referent, {}, std::string(sign)};
    ComponentReferents both = *base.components;
    for (const auto& [component, referent] : *base.components)
      both.emplace_back(Name{component.word, component.strokes + "'"}, referent);
    return {base.referent, std::move(both), std::string(sign)};
  }
  return {};
}

void NameWalk::predicates(const SchemaText& text) {
  for (const Predicate& each : text.predicates) predicate(each.term);
}

void NameWalk::children(const Node& node) {
  for (const Term& child : node.children) term(child);
}

void NameWalk::predicate(const Term& of) {
  const Node& node = *of;
  switch (node.kind) {
    case Kind::negation:
    case Kind::conjunction:
    case Kind::disjunction:
    case Kind::implication:
    case Kind::equivalence:
      if (observer_) observer_(of, scopes_);
      for (const Term& part : node.children) predicate(part);
      return;
    case Kind::forall:
    case Kind::exists:
    case Kind::exists_one:
    case Kind::let:
      if (observer_) observer_(of, scopes_);
      return quantified(node, true);
    case Kind::truth:
    case Kind::falsity:
    case Kind::relation:
      term(of);
      return;
    case Kind::reference:
    case Kind::number:
    case Kind::set_extension:
    case Kind::comprehension:
    case Kind::tuple:
    case Kind::product:
    case Kind::power:
    case Kind::selection:
    case Kind::tuple_selection:
    case Kind::binding_extension:
    case Kind::theta:
    case Kind::application:
    case Kind::lambda:
    case Kind::mu:
    case Kind::conditional:
    case Kind::schema_text:
    case Kind::decoration:
    case Kind::renaming:
    case Kind::hiding:
    case Kind::composition:
    case Kind::piping:
    case Kind::projection:
    case Kind::precondition:
      link(schema(of));
  }
}

void NameWalk::quantified(const Node& node, bool of_predicates) {
  scopes_.push_back(signature(*node.text, Referent::Form::variable));
  predicates(*node.text);
  for (const Term& child : node.children)
    if (of_predicates) {
      predicate(child);
    } else {
      term(child);
    }
  scopes_.pop_back();
}

std::optional<ComponentReferents> NameWalk::term(const Term& of) {
  const Node& node = *of;
  if (chained_ && !passed_.insert(&node).second) return std::nullopt;
  if (observer_) observer_(of, scopes_);
  switch (node.kind) {
    case Kind::reference:
      return reference(of);
    case Kind::number:
    case Kind::truth:
    case Kind::falsity:
      return std::nullopt;
    case Kind::set_extension:
    case Kind::tuple:
    case Kind::product:
    case Kind::power:
    case Kind::application:
    case Kind::tuple_selection:
    case Kind::relation:
      children(node);
      return std::nullopt;
    case Kind::selection:
      selection(node);
      return std::nullopt;
    case Kind::binding_extension:
      binding_extension(of);
      return std::nullopt;
    case Kind::theta:
      theta(node);
      return std::nullopt;
    case Kind::comprehension:
    case Kind::lambda:
    case Kind::mu:
    case Kind::let:
      quantified(node, false);
      return std::nullopt;
    case Kind::conditional:
      predicate(node.children[0]);
      term(node.children[1]);
      term(node.children[2]);
      return std::nullopt;
    case Kind::schema_text:
    case Kind::decoration:
    case Kind::renaming:
    case Kind::hiding:
    case Kind::composition:
    case Kind::piping:
    case Kind::projection:
    case Kind::precondition:
    case Kind::negation:
    case Kind::conjunction:
    case Kind::disjunction:
    case Kind::implication:
    case Kind::equivalence:
    case Kind::forall:
    case Kind::exists:
    case Kind::exists_one: {
      ComponentReferents components = schema_of(node);
      table_.remember(components);
      return components;
    }
  }
  return std::nullopt;
}

std::optional<ComponentReferents> NameWalk::reference(const Term& of) {
  const Node& node = *of;
  if (is_operator_name(node.name.word) || node.name.word == "⟨,,⟩") {  // its words were found among the tokens
    children(node);
    return std::nullopt;
  }
  Meaning meaning = meaning_of(node.name);
  std::optional<ComponentReferents> components = std::move(meaning.components);
  note(take_token(node.name, node.place), node.name, std::move(meaning), typing_.type_of(of), false);
  children(node);
  return components;
}

void NameWalk::selection(const Node& node) {
  term(node.children[0]);
  const Token* token = take_token(node.name);
  const std::optional<Type> binding = typing_.type_of(node.children[0]);
  const Type* type = binding && binding->is(Type::Kind::schema) ? binding->field(node.name) : nullptr;
  Meaning meaning;
  if (type)
    for (const auto& [name, referent] : table_.of_bindings(*binding))
      if (name == node.name) meaning.referent = referent;
  note(token, node.name, std::move(meaning), type ? std::optional(*type) : std::nullopt, false);
}

void NameWalk::binding_extension(const Term& of) {
  const Node& node = *of;
  const std::optional<Type> type = typing_.type_of(of);
  ComponentReferents components;
  if (type && type->is(Type::Kind::schema)) components = table_.of_bindings(*type);
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    Meaning meaning;
    for (const auto& [name, referent] : components)
      if (name == node.names[i]) meaning.referent = referent;
    note(take_token(node.names[i]), node.names[i], std::move(meaning), typing_.type_of(node.children[i]), false);
    term(node.children[i]);
  }
}

void NameWalk::theta(const Node& node) { link(schema(node.children[0]), node.name.strokes); }

std::optional<Type> NameWalk::field_type(const Term& schema, const Name& name) const {
  const std::optional<Type> type = typing_.type_of(schema);
  const Type* field = type && type->is_schema_set() ? type->parts()[0].field(name) : nullptr;
  return field ? std::optional(*field) : std::nullopt;
}

void NameWalk::join(NameScope& scope, ScopedName name) {
  const auto at = std::ranges::find(scope, name.name, &ScopedName::name);
  if (at == scope.end()) {
    scope.push_back(std::move(name));
  } else {
    table_.unite(at->referent, name.referent);
  }
}

NameScope NameWalk::signature(const SchemaText& text, Referent::Form form) {
  NameScope scope;
  for (const Declaration& declaration : text.declarations) declare(declaration, form, scope);
  return scope;
}

void NameWalk::declare(const Declaration& declaration, Referent::Form form, NameScope& to) {
  if (declaration.form == Declaration::Form::included) {
    for (const auto& [name, referent] : schema(declaration.term)) {
      join(to, {name, referent, field_type(declaration.term, name)});
      const Global* seen = form == Referent::Form::global ? typing_.find(section_->name, name) : nullptr;
      if (seen) table_.unite(global(*seen), referent);
    }
    return;
  }
  std::vector<const Token*> tokens;
  for (std::size_t i = 0; i < declaration.names.size(); ++i) {
    const bool is_operator = is_operator_name(declaration.names[i].word);
    if (is_operator) declare_operator(declaration.names[i], declaration.places[i]);
    tokens.push_back(is_operator ? nullptr : take_token(declaration.names[i], declaration.places[i]));
  }
  term(declaration.term);
  std::optional<Type> type = typing_.type_of(declaration.term);
  if (declaration.form == Declaration::Form::typed) type = member_type(type);
  for (std::size_t i = 0; i < declaration.names.size(); ++i) {
    const Name& name = declaration.names[i];
    const Meaning meaning = form == Referent::Form::global ? declared_global(name, declaration.places[i])
                                                           : Meaning{table_.add({form, name}), {}, {}};
    note(tokens[i], name, meaning, type, true);
    join(to, {name, *meaning.referent, type});
  }
}

}  // namespace durero::zed
