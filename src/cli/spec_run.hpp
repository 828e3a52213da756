#pragma once
/// The call of `durero spec run`, and its output of states.

#include <string>
#include <vector>

#include "durero/spec/animation.hpp"

namespace durero::cli {

/// A call of `durero spec run`.
struct RunCall {
  std::vector<std::string> files, given;
  spec::Setup setup;
  std::size_t choices = 20;   ///< so many ways to go on are listed
  std::size_t states = 1000;  ///< an exploration has so many at most
  std::string replay;
  std::uint64_t memory = 0;  ///< MiB; 0: as default_memory() says
};
int spec_run(RunCall call);

/// A table of the state before beside the state after, a component a line, with * where they differ; `before` may be
/// null.
std::string state_table(const spec::Machine& machine, const zed::Valuation* before, const zed::Valuation& after);
/// The operation with its inputs and outputs, on one line.
std::string step_line(const spec::Machine& machine, const spec::Transition& step);
/// Conjuncts, one a line, with their truth.
std::string findings_list(const std::vector<zed::ConjunctTruth>& findings);
/// The outlook from a state: whether the invariant holds, and which operations the state alone refuses, with the first
/// predicate that does.
std::string outlook(const spec::Machine& machine, const zed::Valuation& state);
/// Each operation, and one way to go on by it from the state.
std::string operations_list(const spec::Machine& machine, const zed::Valuation& state);
/// A conjecture, its place, and its result.
std::string claim_line(const spec::ConjectureResult& tried);
/// A way, step by step, each with its state.
std::string way_story(const spec::Machine& machine, const std::vector<spec::Transition>& way);

}  // namespace durero::cli
