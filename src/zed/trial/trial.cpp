#include "durero/zed/trial/trial.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "durero/zed/evaluate/evaluate.hpp"
#include "zed/syntax/match.hpp"
#include "zed/trial/draw.hpp"

namespace durero::zed {
namespace {

Paragraph definition(const Name& name, SchemaText text) {
  return {{}, Definition{name, {}, quantified(Kind::schema_text, std::move(text), {}), {}}};
}

/// The schemas [ D | P ] and [ D | P; Q ] of ∀ D | P • Q, or of ∃; where the claim begins with no quantifier D and P
/// are empty.
struct Claim {
  SchemaText assumed, claimed;
  bool wants_witness = false;
  Name assumed_name, claimed_name;  // no text can write them

  Claim(const Term& term, std::size_t number)
      : assumed_name{" assumed " + std::to_string(number), ""}, claimed_name{" claimed " + std::to_string(number), ""} {
    const bool quantified = term->kind == Kind::forall || term->kind == Kind::exists;
    if (quantified) assumed = *term->text;
    wants_witness = term->kind == Kind::exists;
    claimed = assumed;
    claimed.predicates.push_back({quantified ? term->children[0] : term, {}, term->place});
  }
};

/// The conjuncts of what a schema text says of its names.
void add_conjuncts(const Term& term, std::vector<Term>& to) {
  if (term->kind != Kind::conjunction) return to.push_back(term);
  for (const Term& part : term->children) add_conjuncts(part, to);
}

/// The names in a term, in the order in which they are written; outside of schema texts, which bind others.
void add_names(const Term& term, std::vector<Name>& to) {
  if (term->kind == Kind::reference) to.push_back(term->name);
  for (const Term& part : term->children) add_names(part, to);
}

/// Of each conjunct a name that no conjunct before it has: x of x = e, and else the one that is written last, as what
/// relates values names those that it starts from before those that it makes of them: (i, n, t) ∈ refraction.
std::vector<Name> made_by_conjuncts(const SchemaText& text) {
  std::vector<Name> met, made;
  const auto is_new = [&](const Name& name) {
    return std::find(met.begin(), met.end(), name) == met.end() &&
           std::any_of(text.declarations.begin(), text.declarations.end(), [&](const Declaration& declaration) {
             return std::find(declaration.names.begin(), declaration.names.end(), name) != declaration.names.end();
           });
  };
  std::vector<Term> conjuncts;
  for (const Predicate& predicate : text.predicates) add_conjuncts(predicate.term, conjuncts);
  for (const Term& conjunct : conjuncts) {
    std::vector<Name> names;
    add_names(conjunct, names);
    if (match::is_equation(conjunct) && conjunct->children[0]->kind == Kind::reference)
      names.push_back(conjunct->children[0]->name);
    const auto last = std::find_if(names.rbegin(), names.rend(), is_new);
    if (last != names.rend()) made.push_back(*last);
    met.insert(met.end(), names.begin(), names.end());
  }
  return made;
}

/// Tries one conjecture.
class Attempt {
 public:
  Attempt(const Typing& typing, const Draw& draw, const Claim& claim, const TrialBounds& bounds)
      : typing_(typing), draw_(draw), claim_(claim), bounds_(bounds) {}

  void run(const Evaluator& evaluator, Trial& trial) {
    const SchemaCheck claim = evaluator.schema(claim_.claimed_name);
    made_ = results_of(claim.components());
    const bool closed = claim_.assumed.declarations.empty();
    const std::size_t draws = closed ? 1 : bounds_.draws, most = claim_.wants_witness ? draws : bounds_.states;
    for (std::size_t draw = 0; draw < draws && trial.tried < most && trial.counterexample.empty(); ++draw) {
      try {
        on(drawn(draw), claim, evaluator, trial);
      } catch (const EvaluationError& error) {
        if (undecided_.empty()) undecided_ = error.what();
      }
      if (witness_) break;
    }
    if (claim_.wants_witness && !witness_) {
      trial.why_not = "none of " + std::to_string(trial.tried) + " states is a witness";
      trial.tried = 0;
    }
    if (trial.tried == 0 && trial.why_not.empty())
      trial.why_not = undecided_.empty() ? "none of the values drawn are a state" : undecided_;
  }

 private:
  Given drawn(std::size_t draw) {
    Given values;
    Chances chances(draw);
    for (const Declaration& declaration : claim_.assumed.declarations) declare(declaration, chances, values);
    return values;
  }

  // A schema without samples is drawn declaration by declaration, so that each input comes from the set that is named.
  void declare(const Declaration& declaration, Chances& chances, Given& values) {
    const bool included = declaration.form == Declaration::Form::included;
    const SchemaText* text = included && !draw_.has_samples(declaration.term) ? draw_.text(declaration.term) : nullptr;
    if (text) {
      for (const Declaration& each : text->declarations) declare(each, chances, values);
      return;
    }
    const Type& element = element_of(declaration.term);
    if (included) return include(declaration.term, element, chances, values);
    for (const Name& name : declaration.names) values.emplace_back(name, draw_.of(declaration.term, element, chances));
  }

  const Type& element_of(const Term& set) {
    const auto known = elements_.find(set.get());
    if (known != elements_.end()) return known->second;
    const std::optional<Type> type = typing_.type_of(set);
    if (!type || !type->is(Type::Kind::power)) throw EvaluationError("the type of a declaration is not known");
    return elements_.emplace(set.get(), type->settled().parts()[0]).first->second;
  }

  // Of ΔS, and ΞS, the state before is drawn where S has samples: the other is what an operation makes of it.
  void include(const Term& schema, const Type& element, Chances& chances, Given& values) const {
    const std::string& word = schema->name.word;
    const bool change = schema->kind == Kind::reference && (word.starts_with("Δ") || word.starts_with("Ξ"));
    const Term before = change ? reference({word.substr(std::string("Δ").size()), ""}) : schema;
    const bool sampled = change && draw_.has_samples(before);
    const Value binding = draw_.of(sampled ? before : schema, element, chances);
    std::size_t next = 0;
    for (const Name& name : element.fields())
      if (!sampled || !is_result(name)) values.emplace_back(name, binding.binding()->values[next++]);
  }

  std::vector<Name> results_of(const std::vector<Name>& names) const {
    std::vector<Name> results;
    std::copy_if(names.begin(), names.end(), std::back_inserter(results), is_result);
    return results.empty() ? made_by_conjuncts(claim_.assumed) : results;
  }

  bool is_made(const Name& name) const { return std::find(made_.begin(), made_.end(), name) != made_.end(); }

  // An after-state and outputs are what an operation makes of the rest, as other values are what a conjunct makes of
  // those that it starts from; by chance few values drawn are that. So where they are no state, the first that the text
  // gives for the rest takes their place.
  void complete(const Given& values, const Evaluator& evaluator, const SchemaCheck& claim, std::vector<Value>& found) {
    std::vector<Name> known;
    for (const Name& name : claim.components())
      if (!is_made(name)) known.push_back(name);
    if (!results_) {
      std::vector<Name> made = std::exchange(made_, {});  // what cannot be compiled is not tried again
      results_ = evaluator.completion(claim_.assumed_name, known);
      made_ = std::move(made);
    }
    results_->each(in_order(known, values), [&](std::span<const Value> sought) {
      Given all = values;
      std::erase_if(all, [this](const auto& value) { return is_made(value.first); });
      for (std::size_t i = 0; i < sought.size(); ++i) all.emplace_back(results_->sought()[i], sought[i]);
      found = in_order(claim.components(), all);
      return false;
    });
  }

  static bool is_result(const Name& name) { return name.strokes.find_first_of("'!") != std::string::npos; }

  // A name that two declarations share has the value of the first.
  static std::vector<Value> in_order(const std::vector<Name>& names, const Given& values) {
    std::vector<Value> found;
    for (const Name& name : names) {
      const auto at =
          std::find_if(values.begin(), values.end(), [&](const auto& value) { return value.first == name; });
      found.push_back(at == values.end() ? Value(Open{}) : at->second);
    }
    return found;
  }

  void on(const Given& values, const SchemaCheck& claim, const Evaluator& evaluator, Trial& trial) {
    std::vector<Value> state = in_order(claim.components(), values);
    SchemaCheck::Apart truth = claim.apart(state);
    if (truth.before != Truth::yes && !made_.empty()) {
      complete(values, evaluator, claim, state);
      truth = claim.apart(state);
    }
    const bool open = truth.before == Truth::open || (truth.before == Truth::yes && truth.last == Truth::open);
    if (open && undecided_.empty()) undecided_ = "a variable is not determined";
    if (truth.before != Truth::yes || open) return;
    if (truth.last == Truth::no && !claim_.wants_witness) return refute(trial, claim.components(), state);
    ++trial.tried;
    witness_ = claim_.wants_witness && truth.last == Truth::yes;
  }

  static void refute(Trial& trial, const std::vector<Name>& names, const std::vector<Value>& state) {
    for (std::size_t i = 0; i < names.size(); ++i)
      trial.counterexample += "  " + names[i].text() + " = " + state[i].text() + "\n";
    if (names.empty()) trial.counterexample = "  it has no variables\n";
  }

  const Typing& typing_;
  const Draw& draw_;
  const Claim& claim_;
  const TrialBounds& bounds_;
  std::vector<Name> made_;                // an operation makes these of the rest, or conjuncts do
  std::optional<Completion> results_;     // gives these, once it is asked
  std::map<const Node*, Type> elements_;  // the types of the members of sets that declarations name
  std::string undecided_;                 // the first reason why some state decided nothing
  bool witness_ = false;
};

/// One evaluator serves all, as what the text's own names stand for is the same for each; every conjecture has the
/// steps for itself.
void try_claims(std::vector<Section> sections, const Draw& draw, const std::vector<Claim>& claims, const Typing& typing,
                const TrialBounds& bounds, std::vector<Trial>& trials) {
  Steps steps(bounds.steps);
  const Evaluator evaluator(std::move(sections), Given{}, &steps);
  for (std::size_t i = 0; i < claims.size(); ++i) {
    Trial& trial = trials[i];
    steps = Steps(bounds.steps);
    try {
      Attempt(typing, draw, claims[i], bounds).run(evaluator, trial);
    } catch (const EvaluationError& error) {
      if (trial.tried == 0) trial.why_not = error.what();
    } catch (const StepsSpent&) {
      if (trial.tried == 0) trial.why_not = "it takes more than " + std::to_string(bounds.steps) + " steps";
    }
  }
}

}  // namespace

std::vector<Trial> try_conjectures(const Specification& specification, const Typing& typing, const Samples& samples,
                                   const TrialBounds& bounds) {
  std::vector<Trial> trials;
  std::vector<Claim> claims;
  std::vector<Section> sections = specification.sections;
  for (const Section& section : specification.sections) {
    Section own{section.file, "trial of " + section.name, {section.name}, {}, section.place, {}};
    for (const Paragraph& paragraph : section.paragraphs)
      if (const auto* conjecture = std::get_if<Conjecture>(&paragraph.form)) {
        trials.push_back({section.file, paragraph.place, conjecture->claim.label, 0, {}, {}});
        const Claim& claim = claims.emplace_back(conjecture->claim.term, claims.size());
        own.paragraphs.push_back(definition(claim.assumed_name, claim.assumed));
        own.paragraphs.push_back(definition(claim.claimed_name, claim.claimed));
      }
    sections.push_back(std::move(own));
  }
  if (bounds.states == 0)
    for (Trial& trial : trials) trial.why_not = "no state is asked for";
  if (bounds.states > 0 && !trials.empty())
    try_claims(std::move(sections), Draw(specification, samples), claims, typing, bounds, trials);
  return trials;
}

}  // namespace durero::zed
