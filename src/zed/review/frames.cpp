#include <fmt/core.h>

#include <optional>

#include "durero/zed/review/review.hpp"
#include "zed/review/determine.hpp"
#include "zed/review/expand.hpp"
#include "zed/syntax/match.hpp"

namespace durero::zed {
namespace {

/// The schemas that some declaration includes, by name, without Δ, Ξ and strokes.
class Included {
 public:
  explicit Included(const Specification& specification) {
    for (const Section& section : specification.sections)
      for (const Paragraph& paragraph : section.paragraphs) {
        if (const auto* box = std::get_if<Schema>(&paragraph.form)) look(box->text);
        if (const auto* box = std::get_if<Axiomatic>(&paragraph.form)) look(box->text);
        if (const auto* definition = std::get_if<Definition>(&paragraph.form)) look(definition->value);
      }
  }
  bool operator()(const Name& name) const { return names_.contains(name.word); }

 private:
  void look(const SchemaText& text) {
    for (const Declaration& declaration : text.declarations) {
      if (declaration.form == Declaration::Form::included)
        match::each_name(declaration.term, [this](const Name& name) { insert(name); });
      look(declaration.term);
    }
    for (const Predicate& predicate : text.predicates) look(predicate.term);
  }
  void look(const Term& term) {
    if (term->text) look(*term->text);
    for (const Term& child : term->children) look(child);
  }
  void insert(const Name& name) {
    const bool doubled = name.word.starts_with("Δ") || name.word.starts_with("Ξ");
    names_.insert(doubled ? Word(name.word.substr(std::string_view("Δ").size())) : name.word);
  }

  std::set<std::string> names_;
};

struct Judged {
  Name name;
  const SchemaText* text;
};

/// Returns the schema that a paragraph writes out, as a box or as a definition by one schema text.
std::optional<Judged> written_out(const Paragraph& paragraph) {
  if (const auto* box = std::get_if<Schema>(&paragraph.form)) return Judged{box->name, &box->text};
  const auto* definition = std::get_if<Definition>(&paragraph.form);
  if (definition && definition->value->kind == Kind::schema_text)
    return Judged{definition->name, definition->value->text.get()};
  return std::nullopt;
}

/// Returns the components of the after-state that the schema leaves open.
std::set<Name> left_open(const SchemaText& text, const Expander& expander, Budget& budget) {
  const Expansion whole = expander.text(text);
  budget.spend(100 * whole.facts.size());
  if (whole.opaque) return {};
  std::set<Name> open;
  for (const Name& state : whole.states)
    for (const Name& name : expander.components(state)) open.insert({name.word, name.strokes + "'"});
  Determiner(expander, budget).determine(open, whole.facts);
  return open;
}

void look(const Specification& specification, const Typing& typing, std::vector<Defect>& defects) {
  Budget budget;
  const Expander expander(specification, typing);
  const Included included(specification);
  for (const Section& section : specification.sections)
    for (const Paragraph& paragraph : section.paragraphs) {
      const auto judged = written_out(paragraph);
      if (!judged || included(judged->name)) continue;
      std::string names;
      for (const Name& name : left_open(*judged->text, expander, budget))
        names += (names.empty() ? "" : ", ") + name.text();
      if (names.empty()) continue;
      defects.push_back({section.file, paragraph.place, fmt::format("{} leaves {} open", judged->name.text(), names),
                         "expected an equation for each component of the after-state", Defect::Severity::opinion});
    }
}

}  // namespace

std::vector<Defect> open_frames(const Specification& specification, const Typing& typing) {
  std::vector<Defect> defects;
  try {
    look(specification, typing, defects);
  } catch (const Budget::Spent&) {
    defects.push_back(too_large(specification, "open frames"));
  }
  return defects;
}

}  // namespace durero::zed
