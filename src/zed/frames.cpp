#include <fmt/core.h>

#include <algorithm>

#include "durero/zed/review.hpp"
#include "expand.hpp"

namespace durero::zed {
namespace {

/// The schemas that some declaration includes, by name, without Δ, Ξ and strokes.
class Included {
 public:
  explicit Included(const Specification& specification) {
    for (const Section& section : specification.sections)
      for (const Paragraph& one : section.paragraphs) {
        if (const auto* box = std::get_if<Schema>(&one.form)) look(box->text);
        if (const auto* box = std::get_if<Axiomatic>(&one.form)) look(box->text);
        if (const auto* made = std::get_if<Definition>(&one.form)) look(made->value);
      }
  }
  bool operator()(const Name& name) const { return names_.contains(name.word); }

 private:
  void look(const SchemaText& text) {
    for (const Declaration& one : text.declarations) {
      if (one.form == Declaration::Form::included) for_each_name(one.term, [this](const Name& name) { insert(name); });
      look(one.term);
    }
    for (const Predicate& one : text.predicates) look(one.term);
  }
  void look(const Term& term) {
    if (term->text) look(*term->text);
    for (const Term& child : term->children) look(child);
  }
  void insert(const Name& name) {
    const bool doubled = name.word.starts_with("Δ") || name.word.starts_with("Ξ");
    names_.insert(doubled ? name.word.substr(std::string_view("Δ").size()) : name.word);
  }

  std::set<std::string> names_;
};

bool is_equation(const Term& term) {
  return term->kind == Kind::relation && term->names.size() == 1 && term->names[0].word == "_=_" &&
         term->children.size() == 2;
}

/// Removes from `open` what the equations determine, until nothing changes.
void determine(std::set<Name>& open, const std::vector<Term>& facts, Budget& budget) {
  std::vector<Term> equations;
  std::copy_if(facts.begin(), facts.end(), std::back_inserter(equations), is_equation);
  for (bool changed = true; changed;) {
    changed = false;
    budget.spend(10 * equations.size());
    for (const Term& one : equations)
      for (const std::size_t side : {0u, 1u}) {
        const Term &left = one->children[side], &right = one->children[1 - side];
        if (left->kind != Kind::reference || !open.contains(left->name) || mentions(right, open)) continue;
        open.erase(left->name);
        changed = true;
      }
  }
}

/// θS' = θS, where both are written out.
bool keeps(const Term& term, const Name& state) {
  if (!is_equation(term)) return false;
  const auto is_theta = [&state](const Term& side, const char* strokes) {
    return side->kind == Kind::theta && side->name.strokes == strokes && side->children[0]->kind == Kind::reference &&
           side->children[0]->name == state;
  };
  return (is_theta(term->children[0], "'") && is_theta(term->children[1], "")) ||
         (is_theta(term->children[0], "") && is_theta(term->children[1], "'"));
}

}  // namespace

namespace {

void look(const Specification& specification, const Typing& typing, std::vector<Defect>& found) {
  Budget budget;
  const Expander expander(specification, typing);
  const Included included(specification);
  for (const Section& section : specification.sections)
    for (const Paragraph& one : section.paragraphs) {
      const auto* box = std::get_if<Schema>(&one.form);
      if (!box || included(box->name)) continue;
      const Expansion whole = expander.text(box->text);
      budget.spend(100 * whole.facts.size());
      if (whole.opaque) continue;
      std::set<Name> open;
      for (const Name& state : whole.states) {
        if (std::any_of(whole.facts.begin(), whole.facts.end(), [&](const Term& fact) { return keeps(fact, state); }))
          continue;
        for (const Name& name : expander.components(state)) open.insert({name.word, name.strokes + "'"});
      }
      determine(open, whole.facts, budget);
      if (open.empty()) continue;
      std::string names;
      for (const Name& name : open) names += (names.empty() ? "" : ", ") + name.text();
      found.push_back({section.file, one.place, fmt::format("{} leaves {} open", box->name.text(), names),
                       "expected an equation for each component of the after-state", Defect::Severity::error});
    }
}

}  // namespace

std::vector<Defect> open_frames(const Specification& specification, const Typing& typing) {
  std::vector<Defect> found;
  try {
    look(specification, typing, found);
  } catch (const Budget::Spent&) {
    found.push_back(too_large(specification, "open frames"));
  }
  return found;
}

}  // namespace durero::zed
