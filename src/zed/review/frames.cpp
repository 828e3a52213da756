#include <fmt/core.h>

#include <algorithm>
#include <optional>

#include "durero/zed/review/review.hpp"
#include "zed/operators.hpp"
#include "zed/review/expand.hpp"
#include "zed/syntax/match.hpp"

namespace durero::zed {
namespace {

using match::is_equation;
using match::mentions;

/// Knows the schemas that some declaration includes, by name, without Δ, Ξ and strokes.
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
    names_.insert(doubled ? name.word.substr(std::string_view("Δ").size()) : name.word);
  }

  std::set<std::string> names_;
};

void determine(std::set<Name>& open, const std::vector<Term>& facts, Budget& budget);

/// x' = e determines x', either way round.
void by_equation(std::set<Name>& open, const Node& equation) {
  for (const std::size_t side : {0U, 1U}) {
    const Term &left = equation.children[side], &right = equation.children[1 - side];
    if (left->kind == Kind::reference && open.contains(left->name) && !mentions(right, open)) open.erase(left->name);
  }
}

/// A disjunction determines what each of its sides does, as one of them holds.
void by_sides(std::set<Name>& open, const std::vector<Term>& sides, Budget& budget) {
  std::set<Name> either;
  for (const Term& side : sides) {
    std::set<Name> left_open = open;
    determine(left_open, {side}, budget);
    either.merge(left_open);
  }
  open = std::move(either);
}

/// Returns the relation that holds just where this one does not, or nothing if that has no name of its own.
std::string_view opposite(const Name& relation) {
  const OperatorRow* row = operator_row(relation.word);
  return row ? row->opposite : std::string_view();
}

/// One of ¬ p and p holds, and one of a = b and a ≠ b.
bool are_cases(const Term& p, const Term& q) {
  const auto denies = [](const Term& a, const Term& b) { return a->kind == Kind::negation && a->children[0] == b; };
  const auto single = [](const Term& a) { return a->kind == Kind::relation && a->names.size() == 1; };
  return denies(p, q) || denies(q, p) ||
         (single(p) && single(q) && p->names[0].word == opposite(q->names[0]) && p->children == q->children);
}

/// p ⇒ P and ¬ p ⇒ Q determine what P and Q both do.
void by_cases(std::set<Name>& open, const std::vector<Term>& facts, Budget& budget) {
  std::vector<const Node*> implications;
  for (const Term& term : facts)
    if (term->kind == Kind::implication) implications.push_back(&*term);
  budget.spend(10 * implications.size() * implications.size());
  for (std::size_t i = 0; i < implications.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const std::vector<Term>&left = implications[i]->children, &right = implications[j]->children;
      if (are_cases(left[0], right[0])) by_sides(open, {left[1], right[1]}, budget);
    }
}

/// In ∃ D | P • Q and let D • Q the variables are open too, until P, Q or their definition determines them.
void by_body(std::set<Name>& open, const Node& node, Budget& budget) {
  std::set<Name> inside = open;
  std::vector<Term> facts = node.children;
  for (const Declaration& declaration : node.text->declarations) {
    if (declaration.form == Declaration::Form::included) return;
    for (const Name& name : declaration.names) {
      if (!inside.insert(name).second) return;  // a variable hides the component
      if (declaration.form == Declaration::Form::defined)
        facts.push_back(relation({{"_=_", {}}}, {reference(name), declaration.term}));
    }
  }
  for (const Predicate& predicate : node.text->predicates) facts.push_back(predicate.term);
  determine(inside, facts, budget);
  std::erase_if(open, [&inside](const Name& name) { return !inside.contains(name); });
}

void by_fact(std::set<Name>& open, const Term& fact, Budget& budget) {
  if (is_equation(fact)) by_equation(open, *fact);
  if (fact->kind == Kind::disjunction) by_sides(open, fact->children, budget);
  if (fact->kind == Kind::exists || fact->kind == Kind::let) by_body(open, *fact, budget);
}

/// Removes from `open` what the facts determine, until nothing changes.
void determine(std::set<Name>& open, const std::vector<Term>& conjunctions, Budget& budget) {
  std::vector<Term> facts;
  for (const Term& term : conjunctions) conjuncts(term, facts);
  for (std::size_t before = open.size() + 1; open.size() < before;) {
    before = open.size();
    budget.spend(10 * facts.size());
    for (const Term& part : facts) by_fact(open, part, budget);
    by_cases(open, facts, budget);
  }
}

/// Says whether the term is θS' = θS, with both written out.
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
  for (const Name& state : whole.states) {
    if (std::any_of(whole.facts.begin(), whole.facts.end(), [&](const Term& fact) { return keeps(fact, state); }))
      continue;
    for (const Name& name : expander.components(state)) open.insert({name.word, name.strokes + "'"});
  }
  determine(open, whole.facts, budget);
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
                         "expected an equation for each component of the after-state", Defect::Severity::error});
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
