#pragma once
/// The states, steps and predicates of a machine, as `durero spec run` prints them.

#include <string>
#include <vector>

#include "durero/spec/animation.hpp"

namespace durero::spec {

/// A table of the state before beside the state after, a component a line, with * where they differ; `before` may be
/// null.
std::string state_table(const Machine& machine, const zed::Valuation* before, const zed::Valuation& after);
/// The operation with its inputs and outputs, on one line.
std::string step_line(const Machine& machine, const Transition& step);
/// Conjuncts, one a line, with their truth.
std::string findings_list(const std::vector<zed::ConjunctTruth>& findings);
/// The outlook from a state: whether the invariant holds, and which operations the state alone refuses, with the first
/// predicate that does.
std::string outlook(const Machine& machine, const zed::Valuation& state);
/// Each operation, and one way to go on by it from the state.
std::string operations_list(const Machine& machine, const zed::Valuation& state);
/// A conjecture, its place, and its result.
std::string claim_line(const ConjectureResult& tried);
/// A way, step by step, each with its state.
std::string way_story(const Machine& machine, const std::vector<Transition>& way);

}  // namespace durero::spec
