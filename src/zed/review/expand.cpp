#include "zed/review/expand.hpp"

#include <algorithm>

namespace durero::zed {
namespace {

// The limits of an expansion. The longest schema of spec/ has 40 facts. A schema beyond the limits is opaque.
constexpr std::size_t max_facts = 2000;
constexpr unsigned max_inclusions = 100;  // the greatest depth of inclusions

std::set<Name> bound_names(const SchemaText& text) {
  std::set<Name> bound;
  for (const Declaration& declaration : text.declarations)
    bound.insert(declaration.names.begin(), declaration.names.end());
  return bound;
}

}  // namespace

void conjuncts(const Term& predicate, std::vector<Term>& to) {
  if (predicate->kind == Kind::conjunction) {
    for (const Term& part : predicate->children) conjuncts(part, to);
  } else if (predicate->kind == Kind::relation && predicate->children.size() > 2) {
    for (std::size_t i = 0; i + 1 < predicate->children.size(); ++i)
      to.push_back(
          relation({predicate->names[i]}, {predicate->children[i], predicate->children[i + 1]}, predicate->place));
  } else {
    to.push_back(predicate);
  }
}

Defect too_large(const Specification& specification, const std::string& looked_for) {
  const std::string file = specification.sections.empty() ? "" : specification.sections[0].file;
  return {file,
          {1, 1},
          "the text is too large to look for all its " + looked_for,
          "expected a shorter text",
          Defect::Severity::warning};
}

Term decorate(const Term& term, const std::set<Name>& names, const std::string& strokes) {
  Node node = *term;
  if (node.kind == Kind::reference && names.contains(node.name)) node.name.strokes += strokes;
  if (node.kind == Kind::theta) node.name.strokes += strokes;
  std::set<Name> unbound;  // the names are copied only where something is bound
  const std::set<Name>* free = &names;
  if (node.text) {
    SchemaText text = *node.text;
    for (Declaration& declaration : text.declarations) declaration.term = decorate(declaration.term, names, strokes);
    unbound = names;
    for (const Name& name : bound_names(text)) unbound.erase(name);
    free = &unbound;
    for (Predicate& predicate : text.predicates) predicate.term = decorate(predicate.term, *free, strokes);
    node.text = std::make_shared<const SchemaText>(std::move(text));
  }
  for (Term& child : node.children) child = decorate(child, *free, strokes);
  return make(std::move(node));
}

Expander::Expander(const Specification& specification, const Typing& typing) : typing_(typing) {
  for (const Section& section : specification.sections)
    for (const Paragraph& paragraph : section.paragraphs) {
      if (const auto* box = std::get_if<Schema>(&paragraph.form)) boxes_.emplace(box->name, &box->text);
      if (const auto* definition = std::get_if<Definition>(&paragraph.form))
        definitions_.emplace(definition->name, definition->value);
      if (const auto* type = std::get_if<FreeType>(&paragraph.form)) {
        std::set<Name> constants;
        bool only_constants = true;
        for (const Branch& branch : type->branches) {
          constants.insert(branch.name);
          only_constants = only_constants && !branch.argument;
        }
        if (only_constants)
          for (const Name& name : constants) siblings_[name] = constants;
      }
    }
  for (const Section& section : specification.sections)
    for (const Paragraph& paragraph : section.paragraphs)
      if (const auto* box = std::get_if<Axiomatic>(&paragraph.form)) add(box->text, axioms_, 0);
}

std::set<Name> Expander::components(const Name& schema) const {
  std::set<Name> names;
  for (const auto& [section, scope] : typing_.scopes) {
    const auto at = scope.find(schema);
    if (at == scope.end() || !at->second->scheme.type.is_schema_set()) continue;
    const Type& type = at->second->scheme.type.parts()[0];
    names.insert(type.fields().begin(), type.fields().end());
    break;
  }
  return names;
}

std::set<Name> Expander::spoken_of(const Term& schema) const {
  if (schema->kind != Kind::reference) return {};
  const Name& name = schema->name;
  std::set<Name> names = components(name);
  if (!names.empty() || !(name.word.starts_with("Δ") || name.word.starts_with("Ξ"))) return names;
  names = components({name.word.substr(std::string_view("Δ").size()), name.strokes});
  for (const Name& each : std::set<Name>(names)) names.insert({each.word, each.strokes + "'"});
  return names;
}

std::set<Name> Expander::siblings(const Name& constant) const {
  const auto entry = siblings_.find(constant);
  return entry == siblings_.end() ? std::set<Name>() : entry->second;
}

Expansion Expander::schema(const Term& term) const {
  Expansion expansion;
  add(term, expansion, 0);
  return expansion;
}

Expansion Expander::text(const SchemaText& text) const {
  Expansion expansion;
  add(text, expansion, 0);
  return expansion;
}

void Expander::add(const SchemaText& text, Expansion& to, unsigned depth) const {
  for (const Declaration& declaration : text.declarations) {
    if (declaration.form == Declaration::Form::included) {
      add(declaration.term, to, depth + 1);
      continue;
    }
    const bool typed = declaration.form == Declaration::Form::typed;
    for (const Name& name : declaration.names) {
      to.facts.push_back(
          relation({{typed ? "_∈_" : "_=_", {}}}, {reference(name), declaration.term}, declaration.place));
      if (typed) to.declared.emplace_back(name, declaration.term);
    }
  }
  for (const Predicate& predicate : text.predicates) conjuncts(predicate.term, to.facts);
}

void Expander::add(const Term& schema, Expansion& to, unsigned depth) const {
  if (depth > max_inclusions || to.facts.size() > max_facts) {
    to.opaque = true;
    return;
  }
  if (schema->kind == Kind::schema_text) {
    add(*schema->text, to, depth + 1);
  } else if (schema->kind == Kind::conjunction) {
    for (const Term& part : schema->children) add(part, to, depth + 1);
  } else if (schema->kind == Kind::reference && schema->children.empty()) {
    add_named(schema->name, to, depth + 1);
  } else if (schema->kind == Kind::decoration && schema->children[0]->kind == Kind::reference) {
    add_decorated(schema->children[0]->name, schema->name.strokes, to, depth + 1);
  } else {
    to.opaque = true;
  }
}

void Expander::add_decorated(const Name& base, const std::string& stroke, Expansion& to, unsigned depth) const {
  if (depth > max_inclusions) {
    to.opaque = true;
    return;
  }
  auto known = decorated_.find({base, stroke});
  if (known == decorated_.end()) {
    Expansion made;
    add_decorated_anew(base, stroke, made, depth);
    known = decorated_.emplace(std::pair(base, stroke), std::move(made)).first;
  }
  const Expansion& whole = known->second;
  to.facts.insert(to.facts.end(), whole.facts.begin(), whole.facts.end());
  to.declared.insert(to.declared.end(), whole.declared.begin(), whole.declared.end());
  to.opaque = to.opaque || whole.opaque;
}

void Expander::add_decorated_anew(const Name& base, const std::string& stroke, Expansion& to, unsigned depth) const {
  Expansion inner;
  add_named(base, inner, depth + 1);
  const std::set<Name> names = components(base);
  for (const Term& fact : inner.facts) to.facts.push_back(decorate(fact, names, stroke));
  for (const auto& [component, set] : inner.declared)
    to.declared.emplace_back(Name{component.word, component.strokes + stroke}, set);
  to.opaque = to.opaque || inner.opaque;
}

void Expander::add_named(const Name& name, Expansion& to, unsigned depth) const {
  if (const auto box = boxes_.find(name); box != boxes_.end()) return add(*box->second, to, depth);
  if (const auto entry = definitions_.find(name); entry != definitions_.end()) return add(entry->second, to, depth);
  const bool delta = name.word.starts_with("Δ"), xi = name.word.starts_with("Ξ");
  if ((delta || xi) && name.strokes.empty()) {
    const Name base{name.word.substr(std::string_view("Δ").size()), {}};
    add_named(base, to, depth + 1);
    add_decorated(base, "'", to, depth + 1);
    const std::set<Name> names = components(base);
    const bool is_state =
        std::all_of(names.begin(), names.end(), [](const Name& each) { return each.strokes.empty(); });
    if (is_state) to.states.insert(base);
    if (!xi) return;
    for (const Name& variable : names)
      to.facts.push_back(
          relation({{"_=_", {}}}, {reference({variable.word, variable.strokes + "'"}), reference(variable)}));
  } else {
    to.opaque = true;
  }
}

}  // namespace durero::zed
