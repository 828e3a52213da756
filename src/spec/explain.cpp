/// A term with the values of what it is made of, as a tree: which conjunct is false, and with which witness.
#include <algorithm>
#include <memory>

#include "durero/spec/calculator.hpp"
#include "durero/zed/print/print.hpp"

namespace durero::spec {

using zed::Kind;
using zed::Name;
using zed::Term;
using zed::Truth;
using zed::Valuation;
using zed::Value;

namespace {

std::string explained_line(const ExplainedTerm& said, unsigned depth) {
  return std::string(2 * static_cast<std::size_t>(depth), ' ') + said.term + "  ▸  " + said.value + "\n";
}

void append_explained(std::string& to, const ExplainedTerm& said, unsigned depth) {
  to += explained_line(said, depth);
  for (const ExplainedTerm& part : said.parts) append_explained(to, part, depth + 1);
}

class Explainer {
 public:
  Explainer(const zed::Evaluator& evaluator, const zed::Typing& typing) : evaluator_(evaluator), typing_(typing) {}

  /// Adds a term, with its parts, to those of another.
  void explain(const Term& term, const Valuation& locals, unsigned depth, std::vector<ExplainedTerm>& into) {
    if (size_ > most_text || depth > most_depth) return;
    if (is_predicate(term)) {
      const std::string truth = truth_of(term, locals);
      ExplainedTerm& said = say(into, depth, {zed::to_unicode(term), truth});
      if (is_quantifier(term)) return explain_quantifier(term, locals, depth, said);
      return explain_parts(term, locals, depth, said);
    }
    ExplainedTerm& said = say(into, depth, {zed::to_unicode(term), value_of(term, locals)});
    if (!term->text) explain_parts(term, locals, depth, said);  // they else speak of variables that have no one value
  }

 private:
  static constexpr std::size_t most_text = 100'000;
  static constexpr unsigned most_depth = 60;

  bool is_predicate(const Term& term) const { return !typing_.type_of(term); }
  static bool is_quantifier(const Term& term) { return term->kind == Kind::forall || term->kind == Kind::exists; }

  /// Numerals, the names of operators and the tuple of their operands say nothing that their whole does not.
  static bool is_worth_saying(const Term& part) {
    if (part->kind == Kind::number) return false;
    return part->kind != Kind::reference || part->name.word.find("_") == std::string::npos;
  }

  ExplainedTerm& say(std::vector<ExplainedTerm>& into, unsigned depth, ExplainedTerm said) {
    size_ += explained_line(said, depth).size();
    return into.emplace_back(std::move(said));
  }

  void explain_parts(const Term& term, const Valuation& locals, unsigned depth, ExplainedTerm& said) {
    for (const Term& part : term->children)
      for (const Term& each : part->kind == Kind::tuple ? part->children : std::vector{part})
        if (is_worth_saying(each)) explain(each, locals, depth + 1, said.parts);
  }

  std::string truth_of(const Term& term, const Valuation& locals) const {
    try {
      const Truth truth = evaluator_.holds(term, locals);
      return truth == Truth::yes ? "true" : truth == Truth::no ? "false" : "not decided";
    } catch (const zed::EvaluationError&) {
      return "not decided";
    }
  }

  std::string value_of(const Term& term, const Valuation& locals) const {
    try {
      const Value value = evaluator_.value(term, locals);
      return value.is_open() ? "not decided" : value.text();
    } catch (const zed::EvaluationError&) {
      return "not decided";
    }
  }

  /// The values that make a ∀ false, or an ∃ true, and the body with them.
  void explain_quantifier(const Term& term, const Valuation& locals, unsigned depth, ExplainedTerm& said) {
    const bool universal = term->kind == Kind::forall;
    if (said.value != (universal ? "false" : "true")) return;
    const auto witness = first_witness(term, locals, universal);
    if (!witness) return;
    std::string values;
    for (const auto& [name, value] : *witness)
      values += (values.empty() ? "" : ", ") + name.text() + " == " + value.text();
    ExplainedTerm& found = say(said.parts, depth + 1, {universal ? "counter-example" : "witness", values, true});
    Valuation inner = *witness;
    inner.insert(inner.begin(), locals.begin(), locals.end());
    for (const zed::Predicate& predicate : term->text->predicates)
      explain(predicate.term, inner, depth + 2, found.parts);
    explain(term->children[0], inner, depth + 2, found.parts);
  }

  /// The first member of { D | P ∧ Q • (x, …) }, where all of D is x : T.
  std::optional<Valuation> first_witness(const Term& term, const Valuation& locals, bool universal) const {
    std::vector<Name> names;
    for (const zed::Declaration& declaration : term->text->declarations) {
      if (declaration.form != zed::Declaration::Form::typed) return std::nullopt;
      names.insert(names.end(), declaration.names.begin(), declaration.names.end());
    }
    zed::SchemaText text = *term->text;
    const Term& body = term->children[0];
    text.predicates.push_back({universal ? zed::node(Kind::negation, {body}) : body, {}, {}});
    try {
      const Value all = evaluator_.value(zed::quantified(Kind::comprehension, std::move(text), {}), locals);
      const auto* members = all.set() ? all.set()->members() : nullptr;
      if (!members || members->empty()) return std::nullopt;
      Valuation witness;
      for (std::size_t i = 0; i < names.size(); ++i)
        witness.emplace_back(names[i], names.size() == 1 ? members->front() : members->front().tuple()->parts[i]);
      return witness;
    } catch (const zed::EvaluationError&) {
      return std::nullopt;
    }
  }

  const zed::Evaluator& evaluator_;
  const zed::Typing& typing_;
  std::size_t size_ = 0;  // of the text so far
};

}  // namespace

std::string explanation_text(const ExplainedTerm& whole) {
  std::string text;
  append_explained(text, whole, 0);
  return text;
}

std::string Calculator::explain(const std::string& typed, zed::Steps& steps) const {
  return explanation_text(explained(typed, steps));
}

ExplainedTerm Calculator::explained(const std::string& typed, zed::Steps& steps, const LocalNames& locals) const {
  Term term = parsed(typed, notation_of(specification_));
  const zed::Typing typing = check(term, locals);
  const zed::Evaluator evaluator(specification_.sections, given_, &steps);
  Explainer explainer(evaluator, typing);
  std::vector<ExplainedTerm> whole;
  explainer.explain(term, locals.values, 0, whole);
  return std::move(whole.front());
}

}  // namespace durero::spec
