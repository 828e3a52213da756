#include "zed/evaluate/definitions.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "zed/operators.hpp"

namespace durero::zed {
namespace {

bool contains(const Components& names, const Name& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void join(Components& names, const Components& more) {
  for (const Name& name : more) {
    if (!contains(names, name)) names.push_back(name);
  }
}

Components without(Components names, const Components& hidden) {
  std::erase_if(names, [&](const Name& name) { return contains(hidden, name); });
  return names;
}

std::optional<Name> without_stroke(const Name& name, const std::string& stroke) {
  if (!name.strokes.ends_with(stroke)) return std::nullopt;
  return Name{name.word, name.strokes.substr(0, name.strokes.size() - stroke.size())};
}

std::optional<Components> reference_components(const Node& node, const Definitions& definitions) {
  if (const Meaning* global = definitions.find(node.name)) {
    if (global->kind == Meaning::Kind::schema) {
      return components(std::get<Schema>(global->paragraph->form).text, definitions);
    }
    if (global->kind == Meaning::Kind::definition) {
      return components(std::get<Definition>(global->paragraph->form).value, definitions);
    }
    return std::nullopt;
  }
  for (const auto* prefix : {"Δ", "Ξ"}) {
    const auto of = implicit(node.name, prefix, definitions);
    if (!of) continue;
    auto names = components(reference(*of), definitions);
    if (!names) return std::nullopt;
    Components after;
    for (const Name& name : *names) after.push_back(decorated(name, "'"));
    join(*names, after);
    return names;
  }
  return std::nullopt;
}

Components renamed(Components names, const std::vector<Name>& pairs) {
  for (Name& name : names) {
    for (std::size_t i = 0; i + 1 < pairs.size(); i += 2) {
      if (name == pairs[i + 1]) {
        name = pairs[i];
        break;
      }
    }
  }
  return names;
}

std::optional<Components> joined_components(const Node& node, const std::string& stroke, const std::string& to_stroke,
                                            const Definitions& definitions) {
  auto left = components(node.children[0], definitions), right = components(node.children[1], definitions);
  if (!left || !right) return std::nullopt;
  Components from, to;
  for (const Name& name : joined(node.children[0], stroke, node.children[1], to_stroke, definitions)) {
    from.push_back(decorated(name, stroke));
    to.push_back(decorated(name, to_stroke));
  }
  *left = without(std::move(*left), from);
  join(*left, without(std::move(*right), to));
  return left;
}

}  // namespace

const std::string& Meaning::label() const {
  static const std::string none;
  const auto* definition = std::get_if<Definition>(&paragraph->form);
  return definition ? definition->label : none;
}

Definitions::Definitions(const std::vector<Section>& sections) : sections_(sections) {
  for (const Section& section : sections) {
    for (const Paragraph& paragraph : section.paragraphs) add(section, paragraph);
  }
  is_whole_ = true;
}

void Definitions::add(Meaning global) {
  if (const auto section = toolkit_section_of(global.name.text()))
    of_toolkit_ = fmt::format("{} is declared in {} and in {}, and what is evaluated has one meaning of it",
                              global.name.text(), global.section->name, name_of(*section));
  const auto [at, added] = globals_.try_emplace(global.name, global);
  if (added || at->second.section == global.section) return;
  ambiguous_.try_emplace(global.name,
                         fmt::format("{} is declared in {} and in {}, and what is evaluated has one meaning of it",
                                     global.name.text(), at->second.section->name, global.section->name));
}

void Definitions::refuse_ambiguous(const Name& name) const {
  if (!is_whole_) return;
  if (!of_toolkit_.empty()) throw EvaluationError(of_toolkit_);
  if (const auto at = ambiguous_.find(name); at != ambiguous_.end()) throw EvaluationError(at->second);
}

void Definitions::add(const Section& section, const Paragraph& paragraph) {
  using Which = Meaning::Kind;
  const auto& form = paragraph.form;
  const auto declare = [&](Which kind, const Name& name, std::uint32_t order = 0) {
    add(Meaning{.kind = kind, .name = name, .section = &section, .paragraph = &paragraph, .order = order});
  };
  if (const auto* given = std::get_if<GivenTypes>(&form)) {
    for (const Name& each : given->names) declare(Which::given, each);
  } else if (const auto* free = std::get_if<FreeType>(&form)) {
    declare(Which::free_type, free->name);
    std::uint32_t order = 0;
    for (const Branch& branch : free->branches) {
      declare(branch.argument ? Which::constructor : Which::constant, branch.name, order++);
    }
  } else if (const auto* definition = std::get_if<Definition>(&form)) {
    declare(Which::definition, definition->name);
  } else if (const auto* schema = std::get_if<Schema>(&form)) {
    declare(Which::schema, schema->name);
  } else if (const auto* axiomatic = std::get_if<Axiomatic>(&form)) {
    for (const Name& component : components(axiomatic->text, *this)) declare(Which::axiomatic, component);
  }
}

Meaning* Definitions::find(const Name& name) {
  refuse_ambiguous(name);
  const auto entry = globals_.find(name);
  return entry == globals_.end() ? nullptr : &entry->second;
}

const Meaning* Definitions::find(const Name& name) const {
  refuse_ambiguous(name);
  const auto entry = globals_.find(name);
  return entry == globals_.end() ? nullptr : &entry->second;
}

std::optional<Name> implicit(const Name& name, std::string_view prefix, const Definitions& definitions) {
  if (!name.word.starts_with(prefix) || name.word.size() == prefix.size() || definitions.find(name)) {
    return std::nullopt;
  }
  return Name{name.word.substr(prefix.size()), name.strokes};
}

Name decorated(Name name, const std::string& strokes) {
  name.strokes += strokes;
  return name;
}

Components components(const Declaration& declaration, const Definitions& definitions) {
  if (declaration.form != Declaration::Form::included) return declaration.names;
  auto names = components(declaration.term, definitions);
  if (!names) throw EvaluationError("a schema is included that is none");
  return std::move(*names);
}

Components components(const SchemaText& text, const Definitions& definitions) {
  Components names;
  for (const Declaration& declaration : text.declarations) join(names, components(declaration, definitions));
  return names;
}

std::vector<Name> joined(const Term& left, const std::string& stroke, const Term& right, const std::string& to_stroke,
                         const Definitions& definitions) {
  const auto from = components(left, definitions), to = components(right, definitions);
  std::vector<Name> names;
  if (!from || !to) return names;
  for (const Name& name : *from) {
    const auto base = without_stroke(name, stroke);
    if (base && contains(*to, decorated(*base, to_stroke))) names.push_back(*base);
  }
  return names;
}

Components hidden_by_pre(const Term& schema, const Definitions& definitions) {
  Components names = components(schema, definitions).value_or(Components{});
  std::erase_if(names, [](const Name& name) { return !name.strokes.ends_with("'") && !name.strokes.ends_with("!"); });
  return names;
}

std::optional<Components> components(const Term& term, const Definitions& definitions) {
  const Node& node = *term;
  const auto of = [&](std::size_t i) { return components(node.children[i], definitions); };
  switch (node.kind) {
    case Kind::reference:
      return reference_components(node, definitions);
    case Kind::schema_text:
      return components(*node.text, definitions);
    case Kind::decoration: {
      auto names = of(0);
      if (names) {
        for (Name& name : *names) name.strokes += node.name.strokes;
      }
      return names;
    }
    case Kind::renaming: {
      auto names = of(0);
      return names ? std::optional(renamed(std::move(*names), node.names)) : names;
    }
    case Kind::hiding: {
      auto names = of(0);
      return names ? std::optional(without(std::move(*names), node.names)) : names;
    }
    case Kind::composition:
      return joined_components(node, "'", "", definitions);
    case Kind::piping:
      return joined_components(node, "!", "?", definitions);
    case Kind::projection:
      return of(0) ? of(1) : std::nullopt;
    case Kind::precondition: {
      auto names = of(0);
      return names ? std::optional(without(std::move(*names), hidden_by_pre(node.children[0], definitions))) : names;
    }
    case Kind::negation:
      return of(0);
    case Kind::conjunction:
    case Kind::disjunction:
    case Kind::implication:
    case Kind::equivalence: {
      auto left = of(0), right = of(1);
      if (!left || !right) return std::nullopt;
      join(*left, *right);
      return left;
    }
    case Kind::forall:
    case Kind::exists:
    case Kind::exists_one: {
      auto names = of(0);
      return names ? std::optional(without(std::move(*names), components(*node.text, definitions))) : names;
    }
    default:
      return std::nullopt;
  }
}

}  // namespace durero::zed
