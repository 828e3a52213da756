/// The ways to states, and what is to come on every way.
#include <algorithm>

#include "explore_impl.hpp"

namespace durero::spec {

using zed::Name;
using zed::Term;

/// The initial transition that leads to the state.
Transition StateSpace::Impl::start(StateIndex at) {
  const StepRows rows = planned.rows(planned.initial(), {});
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto row = rows.row(i), after = row.subspan(row.size() - planned.components());
    if (std::equal(after.begin(), after.end(), table.state(at).begin()))
      return planned.transition(planned.initial(), row);
  }
  Transition begun;  // a state from which the exploration began
  begun.operation = planned.initial().name;
  begun.after = planned.valuation(table.state(at));
  return begun;
}

std::optional<std::pair<Transition, StateIndex>> StateSpace::Impl::step(StateIndex from, StateIndex to_class,
                                                                        std::uint32_t operation) {
  auto& operations = planned.operations();
  const std::vector<ValueId> before(table.state(from).begin(), table.state(from).end());
  for (std::uint32_t i = 0; i < operations.size(); ++i) {
    if (operation != any_operation && i != operation) continue;
    const StepRows& rows = planned.rows(operations[i], before);
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const auto row = rows.row(r);
      const auto to = table.find(row.subspan(row.size() - planned.components()));
      if (to && table.class_of(*to) == to_class) return std::pair(planned.transition(operations[i], row), *to);
    }
  }
  return std::nullopt;
}

std::vector<Transition> StateSpace::Impl::way_to(StateIndex at) {
  std::vector<StateIndex> classes;
  for (StateIndex each = table.class_of(at); each != StateTable::none; each = table.parent(each))
    classes.push_back(each);
  std::reverse(classes.begin(), classes.end());
  std::vector<Transition> way{start(classes.front())};
  StateIndex now = classes.front();
  for (std::size_t i = 1; i < classes.size(); ++i) {
    auto next = step(now, classes[i], any_operation);
    if (!next) break;  // a bound cut a class of states apart
    way.push_back(std::move(next->first));
    now = next->second;
  }
  return way;
}

std::vector<bool> StateSpace::Impl::holds_in_each(const Term& predicate) {
  const IdTest test = planned.state_test(predicate);
  std::vector<bool> holds;
  for (StateIndex at = 0; at < table.size(); ++at) {
    planned.load_state(table.state(at));
    holds.push_back(test(planned.frame()));
  }
  return holds;
}

/// The states in which a way may end: a state that was not gone on from, or from which a bound cut steps, is none.
std::vector<bool> StateSpace::Impl::ends() const {
  std::vector<bool> ends(table.size(), false);
  for (std::size_t at = 0; at < gone_on; ++at) ends[queue[at]] = !cut_from.contains(queue[at]);
  return ends;
}

void StateSpace::Impl::try_liveness() {
  if (eventual.empty() && leads.empty()) return;
  std::vector<std::vector<GraphStep>> steps(table.size());
  for (const Edge& edge : edges)
    if (edge.from != edge.to) steps[edge.from].push_back({edge.to, edge.operation});
  const LassoSearch search(steps, ends());
  std::vector<StateIndex> from;
  for (StateIndex at = 0; at < initial_size; ++at) from.push_back(at);
  for (const auto& [predicate, text] : eventual) {
    std::vector<bool> in = holds_in_each(predicate);
    in.flip();
    if (const auto lasso = search.find(from, in, bounds.fair)) add_lasso(text, "--eventually", *lasso);
  }
  for (const auto& [first, then, text] : leads) {
    const std::vector<bool> begins = holds_in_each(first);
    std::vector<bool> in = holds_in_each(then);
    in.flip();
    std::vector<StateIndex> begun;
    for (StateIndex at = 0; at < table.size(); ++at)
      if (begins[at] && in[at]) begun.push_back(at);
    if (const auto lasso = search.find(begun, in, bounds.fair)) add_lasso(text, "--leads-to", *lasso);
  }
}

void StateSpace::Impl::add_lasso(const std::string& claim, const std::string& option, const LassoWay& lasso) {
  FalseClaim refuted{claim, option, way_to(lasso.steps.front().to), {}};
  const std::size_t stem = refuted.way.size() - 1;
  for (std::size_t i = 1; i < lasso.steps.size(); ++i)
    if (auto next = step(lasso.steps[i - 1].to, lasso.steps[i].to, lasso.steps[i].operation))
      refuted.way.push_back(std::move(next->first));
  if (lasso.loop) refuted.loop = stem + *lasso.loop;
  report.refuted.push_back(std::move(refuted));
}

}  // namespace durero::spec
