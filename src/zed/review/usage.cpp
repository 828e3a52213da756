#include <fmt/core.h>

#include <algorithm>
#include <unordered_set>

#include "durero/zed/review/review.hpp"
#include "zed/review/expand.hpp"

namespace durero::zed {
namespace {

/// The usage of names in a specification: the names that it mentions, and the bound variables that it does not.
class Usage {
 public:
  /// Prepares to answer for the names in `looked_at`.
  Usage(const Typing& typing, std::vector<Defect>& defects, const std::unordered_set<Name>& looked_at)
      : typing_(typing), defects_(defects) {
    for (const Name& name : looked_at) known_[name];
  }

  void section(const Section& section) {
    file_ = section.file;
    for (const Paragraph& paragraph : section.paragraphs) {
      if (const auto* box = std::get_if<Schema>(&paragraph.form)) components(box->text);
      if (const auto* box = std::get_if<Axiomatic>(&paragraph.form)) components(box->text);
      if (const auto* definition = std::get_if<Definition>(&paragraph.form)) term(definition->value);
      if (const auto* claim = std::get_if<Conjecture>(&paragraph.form)) term(claim->claim.term);
      if (const auto* type = std::get_if<FreeType>(&paragraph.form))
        for (const Branch& branch : type->branches)
          if (branch.argument) term(branch.argument);
    }
  }
  bool mentioned(const Name& name) const { return known_.at(name).mentioned; }

 private:
  struct Variable {
    Place place;
    bool used = false;
  };
  /// The meanings of a name: the variables of that name in the scopes around, the innermost last, or else a global.
  struct Meanings {
    std::vector<Variable> variables{};
    bool mentioned = false;
  };

  void mention(const Name& name) {
    const auto entry = known_.find(name);
    if (entry == known_.end()) return;
    Meanings& known = entry->second;
    (known.variables.empty() ? known.mentioned : known.variables.back().used) = true;
  }

  /// Opens a scope with what the text declares; a name twice in it is one variable.
  std::vector<Meanings*> scope(const SchemaText& text, bool used) {
    std::vector<Meanings*> own;
    for (const Declaration& declaration : text.declarations)
      for (std::size_t i = 0; i < declaration.names.size(); ++i) {
        Meanings& known = known_[declaration.names[i]];
        const Variable variable{i < declaration.places.size() ? declaration.places[i] : declaration.place, used};
        if (std::ranges::find(own, &known) != own.end()) {
          known.variables.back() = variable;
        } else {
          known.variables.push_back(variable);
          own.push_back(&known);
        }
      }
    return own;
  }

  /// A schema mentions its components where it is a predicate, the body of a schema quantifier, or behind θ.
  void mention_components(const Term& schema, const std::string& strokes = {}) {
    const auto type = typing_.types.find(schema.get());
    if (type == typing_.types.end() || !type->second.is_schema_set()) return;
    for (const Name& name : type->second.parts()[0].fields())
      if (strokes.empty()) {
        mention(name);
      } else {
        mention({name.word, name.strokes + strokes});
      }
  }

  /// Walks a schema text that declares components. Its components are not reported, for others use them, and they hide
  /// variables of the same name outside.
  void components(const SchemaText& text) {
    for (const Declaration& declaration : text.declarations) term(declaration.term);
    const auto own = scope(text, true);
    for (const Predicate& predicate : text.predicates) term(predicate.term);
    for (Meanings* known : own) known->variables.pop_back();
  }

  void quantified(const Node& node) {
    for (const Declaration& declaration : node.text->declarations) term(declaration.term);
    const auto own = scope(*node.text, node.children.empty());
    for (const Predicate& predicate : node.text->predicates) term(predicate.term);
    for (const Term& child : node.children) term(child);
    for (const Declaration& declared : node.text->declarations)
      for (const Name& name : declared.names) report(name, known_.at(name).variables.back());
    for (Meanings* known : own) known->variables.pop_back();
  }

  void report(const Name& name, const Variable& variable) {
    if (variable.used) return;
    defects_.push_back({file_, variable.place, fmt::format("{} is declared and never used", name.text()),
                        "expected a use, or no declaration", Defect::Severity::warning});
  }

  void term(const Term& term) {
    const Node& node = *term;
    if (node.kind == Kind::reference) mention(node.name);
    if (node.kind == Kind::theta) mention_components(node.children[0], node.name.strokes);
    if (node.kind == Kind::schema_text) return components(*node.text);
    if (node.kind == Kind::reference) mention_components(term);
    if (node.text) return quantified(node);
    for (const Term& child : node.children) this->term(child);
  }

  const Typing& typing_;
  std::vector<Defect>& defects_;
  std::string file_;
  std::unordered_map<Name, Meanings> known_;  // a name without an entry is neither a variable in scope nor looked at
};

bool is_looked_at(const Global& global) {
  return global.form == Global::Form::given || global.form == Global::Form::free_type ||
         global.form == Global::Form::branch;
}

}  // namespace

std::vector<Defect> unused_names(const Specification& specification, const Typing& typing) {
  std::vector<Defect> defects;
  std::unordered_set<Name> looked_at;
  for (const auto& [section, scope] : typing.scopes)
    for (const auto& [name, global] : scope)
      if (is_looked_at(*global)) looked_at.insert(name);
  Usage usage(typing, defects, looked_at);
  for (const Section& section : specification.sections) usage.section(section);
  for (const Section& section : specification.sections) {
    const auto scope = typing.scopes.find(section.name);
    if (scope == typing.scopes.end()) continue;
    std::map<std::pair<std::uint32_t, std::uint32_t>, const Global*> unused;  // they stand in the order of the text
    for (const auto& [name, global] : scope->second) {
      if (global->section == section.name && is_looked_at(*global) && !usage.mentioned(name))
        unused[{global->place.line, global->place.column}] = global.get();
    }
    for (const auto& [place, global] : unused)
      defects.push_back({global->file, global->place, fmt::format("{} is declared and never used", global->name.text()),
                         "expected a use, or no declaration", Defect::Severity::warning});
  }
  return defects;
}

}  // namespace durero::zed
