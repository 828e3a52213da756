#include <fmt/core.h>

#include <ranges>

#include "durero/zed/review/review.hpp"
#include "zed/review/expand.hpp"

namespace durero::zed {
namespace {

/// Knows what a specification mentions, and which bound variables it does not.
class Usage {
 public:
  Usage(const Typing& typing, std::vector<Defect>& defects) : typing_(typing), defects_(defects) {}

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
  bool mentioned(const Name& name) const { return mentioned_.contains(name); }

 private:
  struct Variable {
    Place place;
    bool used = false;
  };
  using Scope = std::unordered_map<Name, Variable>;

  void mention(const Name& name) {
    for (Scope& scope : std::views::reverse(scopes_)) {
      const auto entry = scope.find(name);
      if (entry == scope.end()) continue;
      entry->second.used = true;
      return;
    }
    mentioned_.insert(name);
  }

  /// A schema mentions its components where it is a predicate, the body of a schema quantifier, or behind θ.
  void mention_components(const Term& schema, const std::string& strokes = {}) {
    const auto type = typing_.types.find(schema.get());
    if (type == typing_.types.end() || !type->second.is_schema_set()) return;
    for (const Name& name : type->second.parts()[0].fields()) mention({name.word, name.strokes + strokes});
  }

  /// A text that declares components has no variables to report: they are for others, and hide those of that name
  /// outside.
  void components(const SchemaText& text) {
    Scope own;
    for (const Declaration& declaration : text.declarations) {
      term(declaration.term);
      for (const Name& name : declaration.names) own[name] = {{}, true};
    }
    scopes_.push_back(std::move(own));
    for (const Predicate& predicate : text.predicates) term(predicate.term);
    scopes_.pop_back();
  }

  void quantified(const Node& node) {
    Scope own;
    for (const Declaration& declaration : node.text->declarations) {
      term(declaration.term);
      for (std::size_t i = 0; i < declaration.names.size(); ++i)
        own[declaration.names[i]] = {i < declaration.places.size() ? declaration.places[i] : declaration.place,
                                     node.children.empty()};
    }
    scopes_.push_back(std::move(own));
    for (const Predicate& predicate : node.text->predicates) term(predicate.term);
    for (const Term& child : node.children) term(child);
    for (const Declaration& declared : node.text->declarations)
      for (const Name& name : declared.names) report(name, scopes_.back().at(name));
    scopes_.pop_back();
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
  std::vector<Scope> scopes_;
  std::set<Name> mentioned_;
};

}  // namespace

std::vector<Defect> unused_names(const Specification& specification, const Typing& typing) {
  std::vector<Defect> defects;
  Usage usage(typing, defects);
  for (const Section& section : specification.sections) usage.section(section);
  for (const Section& section : specification.sections) {
    const auto scope = typing.scopes.find(section.name);
    if (scope == typing.scopes.end()) continue;
    std::map<std::pair<std::uint32_t, std::uint32_t>, const Global*> unused;  // they stand in the order of the text
    for (const auto& [name, global] : scope->second) {
      const bool looked_at = global->form == Global::Form::given || global->form == Global::Form::free_type ||
                             global->form == Global::Form::branch;
      if (global->section == section.name && looked_at && !usage.mentioned(name))
        unused[{global->place.line, global->place.column}] = global.get();
    }
    for (const auto& [place, global] : unused)
      defects.push_back({global->file, global->place, fmt::format("{} is declared and never used", global->name.text()),
                         "expected a use, or no declaration", Defect::Severity::warning});
  }
  return defects;
}

}  // namespace durero::zed
