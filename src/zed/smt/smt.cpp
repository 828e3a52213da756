#include "durero/zed/smt/smt.hpp"

#include <algorithm>

#include "zed/evaluate/describe.hpp"
#include "zed/smt/smt_reply.hpp"
#include "zed/smt/smt_script.hpp"

namespace durero::zed {
namespace {

Truth negation_of(Truth truth) { return truth == Truth::open ? truth : truth == Truth::yes ? Truth::no : Truth::yes; }

Truth disjunction_of(Truth a, Truth b) {
  if (a == Truth::yes || b == Truth::yes) return Truth::yes;
  return a == Truth::open || b == Truth::open ? Truth::open : Truth::no;
}

/// The beginning of a text that is not understood, on one line.
std::string first_line(const std::string& output) {
  constexpr std::size_t most = 60;
  const std::string line = output.substr(0, output.find_first_of("\r\n"));
  std::string shown;
  for (const char c : line.substr(0, most)) shown += c >= ' ' && c < '\x7f' ? c : '?';
  return line.size() > most ? shown + "…" : shown;
}

std::string values_text(const Valuation& values) {
  std::string text;
  for (const auto& [name, value] : values) text += (text.empty() ? "" : ", ") + name.text() + " == " + value.text();
  return text;
}

/// The dialogue about one predicate.
class Dialogue {
 public:
  Dialogue(const SmtProgram& program, const Definitions& definitions, const Evaluator& evaluator, SmtCarrier carrier)
      : program_(program), definitions_(definitions), evaluator_(evaluator), carrier_(std::move(carrier)) {}

  /// Decides a predicate that the evaluator does not.
  Truth undecided(const Term& term, const Valuation& locals) {
    const auto part = [&](std::size_t i) { return decided(term->children[i], locals); };
    switch (term->kind) {
      case Kind::negation:
        return negation_of(part(0));
      case Kind::conjunction:
        return negation_of(disjunction_of(negation_of(part(0)), negation_of(part(1))));
      case Kind::disjunction:
        return disjunction_of(part(0), part(1));
      case Kind::implication:
        return disjunction_of(negation_of(part(0)), part(1));
      case Kind::equivalence: {
        const Truth a = part(0), b = part(1);
        return a == Truth::open || b == Truth::open ? Truth::open : truth(a == b);
      }
      case Kind::exists:
      case Kind::forall:
      case Kind::exists_one:
        return asked(sought_in(term), locals);
      case Kind::relation:
        return relation(term, locals);
      default:
        say(program_.name + " is not asked: " + describe(*term) + " is no quantified predicate");
        return Truth::open;
    }
  }

  SmtFinding finding(Truth truth) && {
    if (truth == Truth::open) values_.clear();
    return {truth, std::move(values_), std::move(said_)};
  }

 private:
  void say(const std::string& clause) {
    if (said_.find(clause) == said_.npos) said_ += (said_.empty() ? "" : "; ") + clause;
  }

  Truth decided(const Term& term, const Valuation& locals) {
    const Truth here = evaluated(term, locals);
    return here == Truth::open ? undecided(term, locals) : here;
  }

  Truth evaluated(const Term& term, const Valuation& locals) const {
    try {
      return evaluator_.holds(term, locals);
    } catch (const EvaluationError&) {
      return Truth::open;
    }
  }

  Truth relation(const Term& term, const Valuation& locals) {
    if (const auto sought = sought_in_emptiness(term, definitions_)) {
      const Truth empty = asked(*sought, locals);
      return term->names[0].word == "_=_" ? empty : negation_of(empty);
    }
    say(program_.name + " is not asked: " + describe(*term) + " is no quantified predicate");
    return Truth::open;
  }

  Truth asked(const SmtSought& sought, const Valuation& locals) {
    SmtScript script(definitions_, evaluator_, carrier_);
    std::string text;
    try {
      text = script.text(sought, locals);
    } catch (const Untranslated& error) {
      say(program_.name + " is not asked: " + error.what());
      return Truth::open;
    }
    const SmtReply reply = program_.ask(text);
    if (reply.failure.empty()) return answered(sought, script, reply.output, locals);
    say(program_.name + " " + reply.failure);
    return Truth::open;
  }

  Truth answered(const SmtSought& sought, SmtScript& script, const std::string& output, const Valuation& locals) {
    const SmtVerdict verdict = read_reply(output);
    const auto found = script.values(verdict);
    switch (verdict.answer) {
      case SmtVerdict::Answer::unsat:
        say(program_.name + " finds no " + sought.called + (script.bounds().empty() ? "" : " " + script.bounds()));
        return Truth::open;
      case SmtVerdict::Answer::unknown:
        if (found && holds(sought, *found, locals) == Truth::yes) break;  // a guess that is right is a witness, too
        say(program_.name + " does not decide it either");
        return Truth::open;
      case SmtVerdict::Answer::garbled:
        say(program_.name + "'s answer is not understood: " + first_line(output));
        return Truth::open;
      case SmtVerdict::Answer::sat:
        if (found) break;
        say(program_.name + "'s answer has no values that are understood");
        return Truth::open;
    }
    return confirmed(sought, *found, locals);
  }

  /// Lets the text say whether the values found are what is sought.
  Truth confirmed(const SmtSought& sought, const std::vector<Valuation>& found, const Valuation& locals) {
    std::string shown;
    for (const Valuation& each : found) shown += (shown.empty() ? "" : " and ") + values_text(each);
    const Truth here = holds(sought, found, locals);
    if (here == Truth::yes) {
      say(program_.name + " finds the " + sought.called + " " + shown +
          (found.size() > 1 ? ", which hold by the text" : ", which holds by the text"));
      values_ = found.back();
      return sought.then;
    }
    say(program_.name + "'s answer " + shown +
        (here == Truth::no ? " does not hold by the text" : " is not decided by the text"));
    return Truth::open;
  }

  Truth holds(const SmtSought& sought, const std::vector<Valuation>& found, const Valuation& locals) const {
    const Term claim = sought.claim();
    Truth all = Truth::yes;
    for (const Valuation& each : found) {
      Valuation names = locals;
      names.insert(names.end(), each.begin(), each.end());
      const Truth here = evaluated(claim, names);
      if (here == Truth::no) return here;
      if (here == Truth::open) all = here;
    }
    if (found.size() == 2 && std::equal(found[0].begin(), found[0].end(), found[1].begin(), found[1].end(),
                                        [](const auto& a, const auto& b) { return same(a.second, b.second); }))
      return Truth::no;
    return all;
  }

  const SmtProgram& program_;
  const Definitions& definitions_;
  const Evaluator& evaluator_;
  SmtCarrier carrier_;
  Valuation values_;
  std::string said_;
};

}  // namespace

SmtFinding ask_program(const SmtProgram& program, const Term& predicate, const std::vector<Section>& sections,
                       const Evaluator& evaluator, const Valuation& locals, const KnownMembers& members) {
  const Definitions definitions(sections);
  const auto carrier = [&](const Name& set) -> std::optional<std::vector<Value>> {
    if (members)
      if (auto known = members(set)) return known;
    try {
      const Value all = evaluator.value(set);
      const auto* few = all.set() ? all.set()->members() : nullptr;
      const auto is_atom = [](const Value& each) { return each.get<Atom>() != nullptr; };
      if (few && std::all_of(few->begin(), few->end(), is_atom)) return *few;
    } catch (const EvaluationError&) {  // they are not known
    }
    return std::nullopt;
  };
  Dialogue dialogue(program, definitions, evaluator, carrier);
  const Truth truth = dialogue.undecided(predicate, locals);
  return std::move(dialogue).finding(truth);
}

}  // namespace durero::zed
