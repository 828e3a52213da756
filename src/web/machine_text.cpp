#include "machine_text.hpp"

#include <algorithm>
#include <utility>

#include "asked_machine.hpp"
#include "durero/spec/animation_text.hpp"

namespace durero::web {

using spec::ConjectureResult;
using spec::Machine;
using spec::MachineOperation;
using spec::ReachedTransitions;
using spec::Transition;
using zed::Truth;

namespace {

std::string findings_text(const std::vector<zed::ConjunctTruth>& findings) {
  return array_of(findings, [](const zed::ConjunctTruth& finding) {
    return ObjectText()
        .member("truth", truth_word(finding.truth))
        .member("predicate", finding.predicate)
        .member("after", finding.strokes == "'")
        .member("label", finding.label)
        .member("line", std::uint64_t{finding.place.line})
        .text();
  });
}

std::string names_text(const Machine& machine, const std::vector<zed::Name>& names) {
  return array_of(names, [&](const zed::Name& name) {
    return ObjectText().member("name", name.text()).member("type", machine.type_text(name)).text();
  });
}

/// Whether an operation may go on from a state, as `ops` of `durero spec run` finds it.
void add_outlook(ObjectText& to, const Machine& machine, const MachineOperation& operation,
                 const zed::Valuation& state) {
  try {
    const ReachedTransitions one = machine.steps(state, operation, {}, 1);
    const bool none = one.transitions.empty();
    const bool open = none && (one.undecided || !one.bounded.empty());
    to.member("enabled", none ? open ? "open" : "no" : "yes");
    if (!none) to.member("example", spec::step_line(machine, one.transitions.front()));
  } catch (const zed::EvaluationError& error) {
    to.member("enabled", "open").member("why", error.what());
  } catch (const zed::StepsSpent&) {
    to.member("enabled", "open").member("why", "steps did not do");
  }
}

/// The predicates of an operation as the state alone decides them; none where the inputs are needed for that.
std::vector<zed::ConjunctTruth> predicates_of(const Machine& machine, const MachineOperation& operation,
                                              const zed::Valuation& state) {
  try {
    return machine.preconditions(state, operation, {});
  } catch (const zed::EvaluationError&) {
    return {};
  } catch (const zed::StepsSpent&) {
    return {};
  }
}

void add_refusal(ObjectText& to, const std::vector<zed::ConjunctTruth>& predicates) {
  const auto refused = std::ranges::find(predicates, Truth::no, &zed::ConjunctTruth::truth);
  to.raw("refused", refused == predicates.end() ? "null" : json_of(refused->predicate));
}

}  // namespace

std::string_view truth_word(Truth truth) {
  return truth == Truth::yes ? "true" : truth == Truth::no ? "false" : "open";
}

void add_machine(ObjectText& to, const Machine& machine) {
  to.member("state", machine.state())
      .member("init", machine.init())
      .raw("carriers", array_of_texts(machine.carriers()))
      .raw("taken", array_of_texts(machine.taken()))
      .raw("components", names_text(machine, machine.components()));
}

std::string operations_text(const Machine& machine, const zed::Valuation* state, bool look) {
  return array_of(machine.operations(), [&](const MachineOperation& operation) {
    ObjectText text;
    text.member("name", operation.name)
        .raw("inputs", names_text(machine, operation.inputs))
        .raw("outputs", names_text(machine, operation.outputs));
    if (state != nullptr) {
      const auto predicates = predicates_of(machine, operation, *state);
      if (look) add_outlook(text, machine, operation, *state);
      add_refusal(text, predicates);
      if (look) text.raw("predicates", findings_text(predicates));
    }
    return text.text();
  });
}

std::string values_text(const Machine& machine, const zed::Valuation& values) {
  ObjectText text;
  for (const auto& [name, value] : values) text.member(name.text(), machine.written(name, value));
  return text.text();
}

std::string transition_text(const Machine& machine, const Transition& step, const zed::Valuation* before) {
  ArrayText changed;
  for (std::size_t i = 0; before != nullptr && i < step.after.size(); ++i)
    if (!zed::same((*before)[i].second, step.after[i].second)) changed.raw(json_of(step.after[i].first.text()));
  return ObjectText()
      .member("operation", step.operation)
      .member("line", spec::step_line(machine, step))
      .raw("inputs", values_text(machine, step.inputs))
      .raw("outputs", values_text(machine, step.outputs))
      .raw("values", values_text(machine, step.after))
      .raw("changed", changed.text())
      .text();
}

std::string states_text(const Machine& machine, const spec::Animation& way) {
  ArrayText states;
  for (std::size_t i = 0; i < way.way().size(); ++i)
    states.raw(transition_text(machine, way.way()[i], i == 0 ? nullptr : &way.way()[i - 1].after));
  return states.text();
}

std::string way_on_text(const Machine& machine, const spec::Animation& way, const Transition& step) {
  spec::Animation longer(way);
  longer.take(step);
  return ObjectText().raw("step", transition_text(machine, step, way.now())).member("way", longer.saved()).text();
}

std::string invariant_text(const Machine& machine, const zed::Valuation& state) {
  try {
    return findings_text(machine.invariant(state));
  } catch (const zed::EvaluationError&) {
    return "[]";
  } catch (const zed::StepsSpent&) {
    return "[]";
  }
}

std::string claims_text(const Machine& machine, const spec::Animation& way) {
  const zed::Valuation none;
  const auto tried = asking([&] { return machine.conjectures(way.before() ? *way.before() : none, way.way().back()); });
  return array_of(tried, [](const ConjectureResult& claim) {
    return ObjectText()
        .member("claim", claim.claim)
        .member("place", claim.place)
        .member("truth", truth_word(claim.truth))
        .member("here", claim.of_states)
        .text();
  });
}

}  // namespace durero::web
