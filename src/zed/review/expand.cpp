#include "zed/review/expand.hpp"

#include <algorithm>

#include "zed/syntax/utf8.hpp"

namespace durero::zed {
namespace {

// A text is written out at most this far; the longest schema of spec/ has 40 facts. Past it a schema is opaque.
constexpr std::size_t max_facts = 2000;
constexpr unsigned max_inclusions = 100;  // one inside the other

std::set<Name> bound_names(const SchemaText& text) {
  std::set<Name> bound;
  for (const Declaration& one : text.declarations) bound.insert(one.names.begin(), one.names.end());
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

void for_each_name(const Term& term, const std::function<void(const Name&)>& visit) {
  if (term->kind == Kind::reference) visit(term->name);
  for (const Term& child : term->children) for_each_name(child, visit);
  if (!term->text) return;
  for (const Declaration& one : term->text->declarations) {
    for (const Name& name : one.names) visit(name);
    for_each_name(one.term, visit);
  }
  for (const Predicate& one : term->text->predicates) for_each_name(one.term, visit);
}

Defect too_large(const Specification& specification, const std::string& looked_for) {
  const std::string file = specification.sections.empty() ? "" : specification.sections[0].file;
  return {file,
          {1, 1},
          "the text is too large to look for all its " + looked_for,
          "expected a shorter text",
          Defect::Severity::warning};
}

bool mentions(const Term& term, const std::set<Name>& names) {
  bool found = false;
  for_each_name(term, [&](const Name& name) { found = found || names.contains(name); });
  return found;
}

Term decorate(const Term& term, const std::set<Name>& names, const std::string& strokes) {
  Node made = *term;
  if (made.kind == Kind::reference && names.contains(made.name)) made.name.strokes += strokes;
  if (made.kind == Kind::theta) made.name.strokes += strokes;
  std::set<Name> unbound;  // a copy only where something is bound
  const std::set<Name>* free = &names;
  if (made.text) {
    SchemaText text = *made.text;
    for (Declaration& one : text.declarations) one.term = decorate(one.term, names, strokes);
    unbound = names;
    for (const Name& name : bound_names(text)) unbound.erase(name);
    free = &unbound;
    for (Predicate& one : text.predicates) one.term = decorate(one.term, *free, strokes);
    made.text = std::make_shared<const SchemaText>(std::move(text));
  }
  for (Term& child : made.children) child = decorate(child, *free, strokes);
  return make(std::move(made));
}

Expander::Expander(const Specification& specification, const Typing& typing) : typing_(typing) {
  for (const Section& section : specification.sections)
    for (const Paragraph& one : section.paragraphs) {
      if (const auto* box = std::get_if<Schema>(&one.form)) boxes_.emplace(box->name, &box->text);
      if (const auto* made = std::get_if<Definition>(&one.form)) definitions_.emplace(made->name, made->value);
      if (const auto* type = std::get_if<FreeType>(&one.form)) {
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
    for (const Paragraph& one : section.paragraphs)
      if (const auto* box = std::get_if<Axiomatic>(&one.form)) add(box->text, axioms_, 0);
}

std::set<Name> Expander::components(const Name& schema) const {
  std::set<Name> found;
  for (const auto& [section, scope] : typing_.scopes) {
    const auto at = scope.find(schema);
    if (at == scope.end() || !at->second->scheme.type.is_schema_set()) continue;
    const Type& type = at->second->scheme.type.parts()[0];
    found.insert(type.fields().begin(), type.fields().end());
    break;
  }
  return found;
}

std::set<Name> Expander::siblings(const Name& constant) const {
  const auto found = siblings_.find(constant);
  return found == siblings_.end() ? std::set<Name>() : found->second;
}

Expansion Expander::schema(const Term& term) const {
  Expansion made;
  add(term, made, 0);
  return made;
}

Expansion Expander::text(const SchemaText& text) const {
  Expansion made;
  add(text, made, 0);
  return made;
}

void Expander::add(const SchemaText& text, Expansion& to, unsigned depth) const {
  for (const Declaration& one : text.declarations) {
    if (one.form == Declaration::Form::included) {
      add(one.term, to, depth + 1);
      continue;
    }
    const bool typed = one.form == Declaration::Form::typed;
    for (const Name& name : one.names) {
      to.facts.push_back(relation({{typed ? "_∈_" : "_=_", {}}}, {reference(name), one.term}, one.place));
      if (typed) to.declared.emplace_back(name, one.term);
    }
  }
  for (const Predicate& one : text.predicates) conjuncts(one.term, to.facts);
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
  if (const auto made = definitions_.find(name); made != definitions_.end()) return add(made->second, to, depth);
  const bool delta = name.word.starts_with("Δ"), xi = name.word.starts_with("Ξ");
  if ((delta || xi) && name.strokes.empty()) {
    const Name base{name.word.substr(std::string_view("Δ").size()), {}};
    add_named(base, to, depth + 1);
    add_decorated(base, "'", to, depth + 1);
    const std::set<Name> names = components(base);
    const bool is_state = std::all_of(names.begin(), names.end(), [](const Name& one) { return one.strokes.empty(); });
    if (is_state) to.states.insert(base);
    if (!xi) return;
    for (const Name& one : names)
      to.facts.push_back(relation({{"_=_", {}}}, {reference({one.word, one.strokes + "'"}), reference(one)}));
  } else {
    to.opaque = true;
  }
}

}  // namespace durero::zed
