/// The states that were found, for those who ask.
#include <algorithm>

#include "explore_impl.hpp"

namespace durero::spec {

using zed::Name;
using zed::Term;

StateSpace::StateSpace(const Machine& machine, ExploreBounds bounds)
    : impl_(std::make_unique<Impl>(machine, std::move(bounds))) {}
StateSpace::~StateSpace() = default;

const ExploreReport& StateSpace::explore(const std::vector<zed::Valuation>& from) {
  impl_->explore(from);
  return impl_->report;
}

const ExploreReport& StateSpace::report() const { return impl_->report; }
std::size_t StateSpace::size() const { return impl_->table.size(); }
zed::Valuation StateSpace::state(std::size_t at) const {
  return impl_->planned.valuation(impl_->table.state(static_cast<StateIndex>(at)));
}

std::vector<Transition> StateSpace::way_to(std::size_t at) const { return impl_->way_to(static_cast<StateIndex>(at)); }

std::vector<std::pair<Transition, std::optional<std::size_t>>> StateSpace::steps_from(std::size_t at) const {
  std::vector<std::pair<Transition, std::optional<std::size_t>>> steps;
  const auto here = impl_->table.state(static_cast<StateIndex>(at));
  const std::vector<ValueId> before(here.begin(), here.end());
  for (PlannedOperation& operation : impl_->planned.operations()) {
    const StepRows& rows = impl_->planned.rows(operation, before);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const auto row = rows.row(i);
      const auto to = impl_->table.find(row.subspan(row.size() - impl_->planned.components()));
      steps.emplace_back(impl_->planned.transition(operation, row),
                         to ? std::optional<std::size_t>(*to) : std::nullopt);
    }
  }
  return steps;
}

StateGraph StateSpace::graph() const {
  StateGraph graph;
  for (std::size_t at = 0; at < size(); ++at) graph.states.push_back(state(at));
  graph.initial = impl_->initial_size;
  for (const Impl::Edge& edge : impl_->edges) {
    const PlannedOperation& operation = impl_->planned.operations()[edge.operation];
    graph.steps.push_back(
        {edge.from, edge.to,
         impl_->planned.transition(operation, std::span(impl_->edge_rows).subspan(edge.row, operation.width()))});
  }
  return graph;
}

bool StateSpace::admits(const zed::Valuation& before, const Transition& step) const {
  auto& operations = impl_->planned.operations();
  const auto at =
      std::find_if(operations.begin(), operations.end(), [&](const auto& each) { return each.name == step.operation; });
  if (at == operations.end() || !at->plan || at->checks.empty())
    return impl_->machine.is_step(before, step) == zed::Truth::yes;
  try {
    std::vector<ValueId> row;
    for (const auto* given : {&step.inputs, &step.outputs, &step.after})
      for (const auto& [name, value] : *given) row.push_back(impl_->planned.values().of(value));
    return impl_->planned.admits(*at, impl_->planned.ids(before), row);
  } catch (const NotInterned&) {
    return impl_->machine.is_step(before, step) == zed::Truth::yes;
  } catch (const Undecided& undecided) {
    throw zed::EvaluationError(undecided.what());
  }
}

Exploration explore(const Machine& machine, const std::vector<Transition>& from, std::size_t most_states,
                    StateGraph* graph) {
  ExploreBounds bounds;
  bounds.states = most_states;
  bounds.high = machine.parts().setup.numbers;
  bounds.low = -bounds.high;
  bounds.graph = graph != nullptr;
  StateSpace space(machine, bounds);
  std::vector<zed::Valuation> first;
  if (!from.empty()) first.push_back(from.back().after);
  const ExploreReport& report = space.explore(first);
  if (graph) *graph = space.graph();
  Exploration found{report.states, report.transitions, report.bounded, {}, {}, report.unanswered, report.answers};
  if (report.refuted.empty()) return found;
  const FalseClaim& refuted = report.refuted.front();
  found.refuted = ConjectureResult{refuted.claim, refuted.place, zed::Truth::no, !refuted.way.empty()};
  found.way = refuted.way.empty() && space.size() > 0 ? space.way_to(0) : refuted.way;
  if (!from.empty() && !found.way.empty()) {  // the first state is the one that the way so far led to
    found.way.erase(found.way.begin());
    found.way.insert(found.way.begin(), from.begin(), from.end());
  }
  return found;
}

}  // namespace durero::spec
