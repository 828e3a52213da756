#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "zed/types/checker.hpp"

namespace durero::zed {
namespace {

Fields fields_of(const Type& schema) {
  Fields signature;
  signature.reserve(schema.fields().size());
  for (std::size_t i = 0; i < schema.fields().size(); ++i)
    signature.emplace_back(schema.fields()[i], schema.parts()[i]);
  return signature;
}

Fields decorated(Fields fields, const std::string& strokes) {
  for (auto& [name, type] : fields) name.strokes += strokes;
  return fields;
}

auto find(Fields& fields, const Name& name) {
  return std::find_if(fields.begin(), fields.end(), [&name](const auto& field) { return field.first == name; });
}

void remove(Fields& fields, const Name& name) {
  std::erase_if(fields, [&name](const auto& field) { return field.first == name; });
}

}  // namespace

FieldTable Checker::signature(const SchemaText& text) {
  FieldTable table;
  for (const Declaration& declaration : text.declarations) {
    if (declaration.form == Declaration::Form::included) {
      if (const auto fields = schema_fields(declaration.term, "as a declaration")) {
        merge(table, *fields, declaration.place, "included");
      } else {
        table.is_open = table.is_open || !awaited_.empty();
      }
      continue;
    }
    const Type type = declaration.form == Declaration::Form::typed
                          ? element(declaration.term, "the range of a variable")
                          : expression(declaration.term);
    for (std::size_t i = 0; i < declaration.names.size(); ++i)
      merge(table, declaration.names[i], type,
            i < declaration.places.size() ? declaration.places[i] : declaration.place, "declared");
  }
  return table;
}

void Checker::predicates(const SchemaText& text) {
  for (const Predicate& conjunct : text.predicates) predicate(conjunct.term);
}

void Checker::merge(FieldTable& table, const Fields& more, Place place, const char* what) {
  table.fields.reserve(table.fields.size() + more.size());
  for (const auto& [name, type] : more) merge(table, name, type, place, what);
}

void Checker::merge(FieldTable& table, const Name& name, const Type& type, Place place, const char* what) {
  spend(1);
  const auto [known, is_new] = table.positions.try_emplace(name, table.fields.size());
  if (is_new) {
    table.fields.emplace_back(name, type);
    return;
  }
  const Type& before = table.fields[known->second].second;
  if (!unify(before, type))
    error(place,
          fmt::format("{} is {} with the type {}, and is {} already", name.text(), what, type.text(), before.text()),
          "expected one type for one name");
}

Fields Checker::merged(const Fields& left, const Fields& right, Place place) {
  FieldTable table;
  merge(table, left, place, "declared");
  merge(table, right, place, "declared");
  return std::move(table.fields);
}

std::optional<Fields> Checker::schema_fields(const Term& term, const char* role) {
  const Type type = expression(term);
  if (awaits(*term, type)) return std::nullopt;
  if (type.is_schema_set()) return fields_of(type.parts()[0]);
  if (!type.is(Type::Kind::unknown))
    error(term->place, fmt::format("an expression of type {} stands {}", type.text(), role), "expected a schema");
  return std::nullopt;
}

Type Checker::schema_expression(const Node& node) {
  switch (node.kind) {
    case Kind::schema_text:
      return schema_of_text(*node.text);
    case Kind::decoration: {
      auto fields = schema_fields(node.children[0], "before a stroke");
      return fields ? schema_set(decorated(std::move(*fields), node.name.strokes)) : undetermined_schema();
    }
    case Kind::renaming:
      return renaming(node);
    case Kind::hiding:
      return hiding(node);
    case Kind::composition:
      return joined(node, "⨟", "'", "");
    case Kind::piping:
      return joined(node, "⨠", "!", "?");
    case Kind::precondition:
      return precondition(node);
    case Kind::forall:
    case Kind::exists:
    case Kind::exists_one:
      return schema_quantifier(node);
    case Kind::negation: {
      const auto fields = schema_fields(node.children[0], "behind ¬");
      return fields ? schema_set(*fields) : undetermined_schema();
    }
    default:
      break;
  }
  const auto left = schema_fields(node.children[0], "as an operand of the schema calculus");
  const auto right = schema_fields(node.children[1], "as an operand of the schema calculus");
  if (!left || !right) return undetermined_schema();
  const Fields both = merged(*left, *right, node.children[1]->place);
  return schema_set(node.kind == Kind::projection ? *right : both);
}

Type Checker::schema_of_text(const SchemaText& text) {
  push(signature(text));
  predicates(text);
  FieldTable table = pop();
  return table.is_open ? undetermined_schema() : schema_set(std::move(table.fields));
}

/// ΔS and ΞS declare the components of S and of S ′.
Type Checker::doubled(const Type& schema, Place place) {
  const Fields fields = fields_of(schema.parts()[0]);
  return schema_set(merged(fields, decorated(fields, "'"), place));
}

Type Checker::renaming(const Node& node) {
  auto fields = schema_fields(node.children[0], "before a renaming");
  if (!fields) return undetermined_schema();
  std::set<Name> olds;
  FieldTable renamed;
  for (std::size_t i = 0; i + 1 < node.names.size(); i += 2)
    if (!olds.insert(node.names[i + 1]).second)
      return wrong(node.place, node.names[i + 1].text() + " is renamed twice", "expected one new name for it");
  spend(fields->size() * node.names.size());
  for (const auto& [name, type] : *fields) {
    Name now = name;
    for (std::size_t i = 0; i + 1 < node.names.size(); i += 2)
      if (node.names[i + 1] == name) now = node.names[i];
    merge(renamed, now, type, node.place, "declared");
  }
  return schema_set(std::move(renamed.fields));
}

Type Checker::hiding(const Node& node) {
  auto fields = schema_fields(node.children[0], "before ⧹");
  if (!fields) return undetermined_schema();
  spend(fields->size() * node.names.size());
  for (const Name& name : node.names) {
    if (find(*fields, name) == fields->end())
      error(node.place, name.text() + " is no component of the schema", "expected one of its components to hide");
    remove(*fields, name);
  }
  return schema_set(std::move(*fields));
}

/// S ⨟ T hides the x' of S that meet an x of T; S ⨠ T hides the x! of S that meet an x? of T.
Type Checker::joined(const Node& node, const char* what, const std::string& left_stroke,
                     const std::string& right_stroke) {
  auto left = schema_fields(node.children[0], "as the left operand"),
       right = schema_fields(node.children[1], "as the right operand");
  if (!left || !right) return undetermined_schema();
  spend(left->size() * right->size());
  Fields kept;
  for (const auto& [name, type] : *left) {
    const bool ends = name.strokes.ends_with(left_stroke);
    const std::string base =
        ends ? name.strokes.substr(0, name.strokes.size() - left_stroke.size()) : name.strokes.text();
    const auto match = ends ? find(*right, {name.word, base + right_stroke}) : right->end();
    if (match == right->end()) {
      kept.emplace_back(name, type);
      continue;
    }
    if (!unify(type, match->second))
      error(node.place,
            fmt::format("{} joins {} of type {} with {} of type {}", what, name.text(), type.text(),
                        match->first.text(), match->second.text()),
            "expected one type");
    right->erase(match);
  }
  return schema_set(merged(kept, *right, node.place));
}

/// pre S hides the after-state and the outputs.
Type Checker::precondition(const Node& node) {
  auto fields = schema_fields(node.children[0], "behind pre");
  if (!fields) return undetermined_schema();
  std::erase_if(*fields, [](const auto& field) {
    return field.first.strokes.ends_with("'") || field.first.strokes.ends_with("!");
  });
  return schema_set(std::move(*fields));
}

Type Checker::schema_quantifier(const Node& node) {
  push(signature(*node.text));
  predicates(*node.text);
  auto fields = schema_fields(node.children[0], "behind the • of a schema quantifier");
  const FieldTable bound = pop();
  if (!fields || bound.is_open) return undetermined_schema();
  spend(fields->size() * bound.fields.size());
  for (const auto& [name, type] : bound.fields) {
    const auto entry = find(*fields, name);
    if (entry == fields->end()) continue;
    if (!unify(entry->second, type))
      error(node.place,
            fmt::format("{} is bound with the type {}, and is {} in the schema", name.text(), type.text(),
                        entry->second.text()),
            "expected one type");
    fields->erase(entry);
  }
  return schema_set(std::move(*fields));
}

}  // namespace durero::zed
