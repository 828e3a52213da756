#include "durero/spec/animation_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace durero::spec {

using zed::Truth;

namespace {

std::size_t characters_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string padded(const std::string& text, std::size_t to) {
  return text + std::string(std::max(to, characters_of(text)) - characters_of(text), ' ');
}

std::string word_of(Truth truth) { return truth == Truth::yes ? "true " : truth == Truth::no ? "false" : "open "; }

const zed::ConjunctTruth* first_false(const std::vector<zed::ConjunctTruth>& findings) {
  const auto at = std::find_if(findings.begin(), findings.end(), [](const auto& f) { return f.truth == Truth::no; });
  return at == findings.end() ? nullptr : &*at;
}

}  // namespace

std::string state_table(const Machine& machine, const zed::Valuation* before, const zed::Valuation& after) {
  std::size_t names = 0, values = 0;
  for (std::size_t i = 0; i < after.size(); ++i) {
    names = std::max(names, characters_of(after[i].first.text()));
    if (before) values = std::max(values, characters_of(machine.written((*before)[i].first, (*before)[i].second)));
  }
  std::string said;
  for (std::size_t i = 0; i < after.size(); ++i) {
    const auto& [name, value] = after[i];
    const bool changed = before && !zed::same((*before)[i].second, value);
    const std::string was = before ? padded(machine.written(name, (*before)[i].second), values) + "  →  " : "";
    said += fmt::format("  {} {} == {}{}\n", changed ? "*" : " ", padded(name.text(), names), was,
                        machine.written(name, value));
  }
  return said;
}

std::string step_line(const Machine& machine, const Transition& step) {
  std::string said = step.operation;
  for (const auto* values : {&step.inputs, &step.outputs})
    for (const auto& [name, value] : *values)
      said += fmt::format("{} {} = {}", said.size() == step.operation.size() ? " " : ";", name.text(),
                          machine.written(name, value));
  return said;
}

std::string findings_list(const std::vector<zed::ConjunctTruth>& findings) {
  std::string said;
  for (const zed::ConjunctTruth& finding : findings) {
    const bool of_after = finding.strokes == "'" && finding.predicate.find('\'') == finding.predicate.npos;
    said += fmt::format("  {}  {}{}{}{}\n", word_of(finding.truth), finding.predicate, of_after ? "  (after)" : "",
                        finding.label.empty() ? "" : "  % ", finding.label);
  }
  return said;
}

namespace {

std::string invariant_line(const Machine& machine, const zed::Valuation& state) {
  try {
    const auto findings = machine.invariant(state);
    const auto holds =
        std::count_if(findings.begin(), findings.end(), [](const auto& f) { return f.truth == Truth::yes; });
    if (const auto* broken = first_false(findings)) return fmt::format("  invariant: false: {}\n", broken->predicate);
    return fmt::format("  invariant: {} of {} conjuncts hold{}\n", holds, findings.size(),
                       static_cast<std::size_t>(holds) == findings.size() ? "" : ", the others are not decided");
  } catch (const zed::EvaluationError& error) {
    return fmt::format("  invariant: not decided: {}\n", error.what());
  }
}

}  // namespace

std::string outlook(const Machine& machine, const zed::Valuation& state) {
  std::string may, cannot;
  for (const auto& operation : machine.operations()) {
    try {
      const auto findings = machine.preconditions(state, operation, {});
      const auto* refused = first_false(findings);
      if (refused) {
        cannot += fmt::format("  refused:   {}: {}\n", operation.name, refused->predicate);
        continue;
      }
    } catch (const zed::EvaluationError&) {  // the inputs may be needed to say
    }
    may += (may.empty() ? "" : ", ") + operation.name;
  }
  return invariant_line(machine, state) + (may.empty() ? "" : fmt::format("  may go on: {}\n", may)) + cannot;
}

std::string way_story(const Machine& machine, const std::vector<Transition>& way) {
  std::string said;
  for (std::size_t i = 0; i < way.size(); ++i)
    said += fmt::format("{}. {}\n{}", i, step_line(machine, way[i]),
                        state_table(machine, i == 0 ? nullptr : &way[i - 1].after, way[i].after));
  return said;
}

std::string operations_list(const Machine& machine, const zed::Valuation& state) {
  std::string said;
  for (const MachineOperation& operation : machine.operations()) {
    try {
      const ReachedTransitions one = machine.steps(state, operation, {}, 1);
      said += one.transitions.empty() ? fmt::format("  no   {}{}\n", operation.name,
                                                    one.undecided || !one.bounded.empty() ? " (none found)" : "")
                                      : fmt::format("  yes  {}\n", step_line(machine, one.transitions.front()));
    } catch (const zed::EvaluationError& error) {
      said += fmt::format("  open {}: {}\n", operation.name, error.what());
    } catch (const zed::StepsSpent&) {
      said += fmt::format("  open {}: --steps did not do\n", operation.name);
    }
  }
  return said;
}

std::string claim_line(const ConjectureResult& tried) {
  const char* word = tried.truth == Truth::yes ? "true" : tried.truth == Truth::no ? "false" : "open";
  return fmt::format("  {:<5}  {}: {}{}\n", word, tried.place, tried.claim, tried.of_states ? "  (here)" : "");
}

}  // namespace durero::spec
