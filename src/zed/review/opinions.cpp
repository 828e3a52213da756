/// Opinions are given on text that ISO Z accepts and the house would not write, an operation as a state and a parent
/// named twice; and on text that older Z accepts and ISO Z does not, a predicate behind let.

#include <fmt/core.h>

#include <algorithm>
#include <functional>

#include "durero/zed/review/review.hpp"

namespace durero::zed {
namespace {

class Doubled {
 public:
  Doubled(const Typing& typing, std::vector<Defect>& defects) : typing_(typing), defects_(defects) {}

  void section(const Section& section) {
    section_ = &section;
    for (const Paragraph& paragraph : section.paragraphs) {
      if (const auto* box = std::get_if<Schema>(&paragraph.form)) text(box->text);
      if (const auto* box = std::get_if<Axiomatic>(&paragraph.form)) text(box->text);
      if (const auto* definition = std::get_if<Definition>(&paragraph.form)) term(definition->value);
      if (const auto* claim = std::get_if<Conjecture>(&paragraph.form)) term(claim->claim.term);
    }
  }

 private:
  void text(const SchemaText& text) {
    for (const Declaration& declaration : text.declarations) term(declaration.term);
    for (const Predicate& predicate : text.predicates) term(predicate.term);
  }
  void term(const Term& term) {
    if (term->kind == Kind::reference) look(*term);
    if (term->text) text(*term->text);
    for (const Term& child : term->children) this->term(child);
  }

  /// ΔS and ΞS, declared nowhere, double the schema S.
  void look(const Node& node) {
    const Name& name = node.name;
    if (!(name.word.starts_with("Δ") || name.word.starts_with("Ξ")) || !name.strokes.empty()) return;
    if (typing_.find(section_->name, name)) return;
    const Global* base = typing_.find(section_->name, {name.word.substr(std::string_view("Δ").size()), {}});
    if (!base || !base->scheme.type.is_schema_set()) return;
    const std::vector<Name>& fields = base->scheme.type.parts()[0].fields();
    const auto stroked =
        std::find_if(fields.begin(), fields.end(), [](const Name& field) { return !field.strokes.empty(); });
    if (stroked == fields.end()) return;
    defects_.push_back({section_->file, node.place,
                        fmt::format("{} doubles a schema with the component {}", name.text(), stroked->text()),
                        "expected a state behind Δ or Ξ, and an operation to be included as it is",
                        Defect::Severity::opinion});
  }

  const Typing& typing_;
  std::vector<Defect>& defects_;
  const Section* section_ = nullptr;
};

}  // namespace

std::vector<Defect> doubled_operations(const Specification& specification, const Typing& typing) {
  std::vector<Defect> defects;
  Doubled doubled(typing, defects);
  for (const Section& section : specification.sections) doubled.section(section);
  return defects;
}

namespace {

/// Calls `visit` for each term in a text, those inside others too.
void each_term(const Term& term, const std::function<void(const Term&)>& visit);
void each_term(const SchemaText& text, const std::function<void(const Term&)>& visit) {
  for (const Declaration& declaration : text.declarations) each_term(declaration.term, visit);
  for (const Predicate& predicate : text.predicates) each_term(predicate.term, visit);
}
void each_term(const Term& term, const std::function<void(const Term&)>& visit) {
  visit(term);
  if (term->text) each_term(*term->text, visit);
  for (const Term& child : term->children) each_term(child, visit);
}

}  // namespace

// The types tell where let stands before a predicate, for a predicate has no type.
std::vector<Defect> predicates_of_let(const Specification& specification, const Typing& typing) {
  std::vector<Defect> defects;
  for (const Section& section : specification.sections) {
    const auto look = [&](const Term& term) {
      if (term->kind == Kind::let && !typing.type_of(term))
        defects.push_back({section.file, term->place, "let stands before a predicate, which ISO Z does not take",
                           "expected ∃ with the same definitions, or let before an expression",
                           Defect::Severity::warning});
    };
    for (const Paragraph& paragraph : section.paragraphs) {
      if (const auto* box = std::get_if<Schema>(&paragraph.form)) each_term(box->text, look);
      if (const auto* box = std::get_if<Axiomatic>(&paragraph.form)) each_term(box->text, look);
      if (const auto* definition = std::get_if<Definition>(&paragraph.form)) each_term(definition->value, look);
      if (const auto* claim = std::get_if<Conjecture>(&paragraph.form)) each_term(claim->claim.term, look);
    }
  }
  return defects;
}

std::vector<Defect> repeated_parents(const Specification& specification, const Typing&) {
  std::vector<Defect> defects;
  for (const Section& section : specification.sections)
    for (auto parent = section.parents.begin(); parent != section.parents.end(); ++parent)
      if (std::find(section.parents.begin(), parent, *parent) != parent)
        defects.push_back({section.file, section.place, *parent + " is named twice as a parent", "expected it once",
                           Defect::Severity::warning});
  return defects;
}

}  // namespace durero::zed
