/// The components of schema expressions, as the walk over names follows them.

#include <algorithm>

#include "zed/names/name_walk.hpp"

namespace durero::zed {
namespace {

std::optional<std::size_t> referent_in(const ComponentReferents& among, const Name& name) {
  const auto at = std::ranges::find_if(among, [&](const auto& component) { return component.first == name; });
  return at == among.end() ? std::nullopt : std::optional(at->second);
}

void remove_component(ComponentReferents& from, const Name& name) {
  std::erase_if(from, [&](const auto& component) { return component.first == name; });
}

}  // namespace

ComponentReferents NameWalk::components_of(const NameScope& scope) {
  ComponentReferents components;
  components.reserve(scope.size());
  for (const ScopedName& each : scope) components.emplace_back(each.name, each.referent);
  return components;
}

ComponentReferents NameWalk::schema(const Term& of) {
  if (auto found = term(of)) return std::move(*found);
  const std::optional<Type> type = typing_.type_of(of);
  if (!type || !type->is_schema_set()) return {};
  return table_.of_bindings(type->parts()[0]);
}

ComponentReferents NameWalk::merged(ComponentReferents to, const ComponentReferents& more) {
  for (const auto& [name, referent] : more) {
    if (const auto known = referent_in(to, name)) {
      table_.unite(*known, referent);
    } else {
      to.emplace_back(name, referent);
    }
  }
  return to;
}

void NameWalk::link(const ComponentReferents& components, const std::string& strokes) {
  for (const auto& [name, referent] : components)
    if (const auto seen = meaning_of({name.word, name.strokes + strokes}).referent) table_.unite(*seen, referent);
}

// The kinds that are no schema expression are those of NameWalk::term().
ComponentReferents NameWalk::schema_of(const Node& node) {
  if (node.kind == Kind::schema_text) {
    NameScope scope = signature(*node.text, Referent::Form::component);
    scopes_.push_back(scope);
    predicates(*node.text);
    scopes_.pop_back();
    return components_of(scope);
  }
  if (node.kind == Kind::forall || node.kind == Kind::exists || node.kind == Kind::exists_one)
    return schema_quantifier(node);
  if (node.kind == Kind::renaming) return renaming(node);
  if (node.kind == Kind::hiding) return hiding(node);
  if (node.kind == Kind::composition) return joined(node, "'", "");
  if (node.kind == Kind::piping) return joined(node, "!", "?");
  ComponentReferents components = schema(node.children[0]);
  if (node.kind == Kind::decoration) {
    for (auto& [name, referent] : components) name.strokes += node.name.strokes;
  } else if (node.kind == Kind::precondition) {
    std::erase_if(components, [](const auto& component) {
      return component.first.strokes.ends_with("'") || component.first.strokes.ends_with("!");
    });
  } else if (node.children.size() == 2) {
    const ComponentReferents right = schema(node.children[1]);
    components = merged(std::move(components), right);
    if (node.kind == Kind::projection) return right;
  }
  return components;
}

/// S[new/old]: the token of the old name is that of the component, and the new name declares another.
ComponentReferents NameWalk::renaming(const Node& node) {
  const ComponentReferents before = schema(node.children[0]);
  ComponentReferents after = before;
  for (std::size_t i = 1; i < node.names.size(); i += 2) remove_component(after, node.names[i]);
  for (std::size_t i = 0; i + 1 < node.names.size(); i += 2) {
    const Name &now = node.names[i], &old = node.names[i + 1];
    const auto known = referent_in(before, old);
    const std::size_t referent = table_.add({Referent::Form::component, now});
    note(take_token(now), now, {referent, {}, {}}, field_type(node.children[0], old), true);
    note(take_token(old), old, {known, {}, {}}, field_type(node.children[0], old), false);
    if (known) after = merged(std::move(after), {{now, referent}});
  }
  return after;
}

ComponentReferents NameWalk::hiding(const Node& node) {
  ComponentReferents components = schema(node.children[0]);
  for (const Name& name : node.names) {
    const auto known = referent_in(components, name);
    note(take_token(name), name, {known, {}, {}}, field_type(node.children[0], name), false);
    remove_component(components, name);
  }
  return components;
}

/// S ⨟ T makes x' of S and x of T one, and S ⨠ T makes x! and x? one.
ComponentReferents NameWalk::joined(const Node& node, const std::string& left_stroke, const std::string& right_stroke) {
  const ComponentReferents left = schema(node.children[0]);
  ComponentReferents right = schema(node.children[1]);
  ComponentReferents kept;
  for (const auto& [name, referent] : left) {
    const bool ends = name.strokes.ends_with(left_stroke);
    const std::string base =
        ends ? name.strokes.substr(0, name.strokes.size() - left_stroke.size()) : name.strokes.text();
    const Name partner{name.word, base + right_stroke};
    const auto met = ends ? referent_in(right, partner) : std::nullopt;
    if (!met) {
      kept.emplace_back(name, referent);
      continue;
    }
    table_.unite(referent, *met);
    remove_component(right, partner);
  }
  return merged(std::move(kept), right);
}

ComponentReferents NameWalk::schema_quantifier(const Node& node) {
  NameScope scope = signature(*node.text, Referent::Form::variable);
  scopes_.push_back(scope);
  predicates(*node.text);
  ComponentReferents components = schema(node.children[0]);
  scopes_.pop_back();
  for (const ScopedName& bound : scope) {
    const auto known = referent_in(components, bound.name);
    if (!known) continue;
    table_.unite(bound.referent, *known);
    remove_component(components, bound.name);
  }
  return components;
}

}  // namespace durero::zed
