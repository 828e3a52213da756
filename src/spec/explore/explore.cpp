#include "durero/spec/explore.hpp"

#include <algorithm>

#include "durero/zed/print/print.hpp"
#include "explore_impl.hpp"

namespace durero::spec {

using zed::Name;
using zed::Term;

namespace {

/// The first deadlocks have their ways in the report.
constexpr std::size_t most_deadlock_ways = 10;
/// Between so many states gone on from the exploration asks whether to go on.
constexpr std::size_t states_between_calls = 256;

}  // namespace

StateSpace::Impl::Impl(const Machine& of, ExploreBounds how)
    : machine(of), bounds(std::move(how)), planned(of, {bounds.low, bounds.high}), table(of.components().size()) {
  std::vector<Term> predicates;
  for (const std::string& always : bounds.always) {
    predicates.push_back(state_predicate(always, "--always"));
    add_claim("always " + zed::to_unicode(predicates.back()), "--always", predicates.back());
  }
  for (const std::string& text : bounds.eventually) {
    predicates.push_back(state_predicate(text, "--eventually"));
    eventual.emplace_back(predicates.back(), "eventually " + zed::to_unicode(predicates.back()));
  }
  for (const auto& [first, then] : bounds.leads_to) {
    const Term p = state_predicate(first, "--leads-to"), q = state_predicate(then, "--leads-to");
    predicates.insert(predicates.end(), {p, q});
    leads.emplace_back(p, q, zed::to_unicode(p) + " leads to " + zed::to_unicode(q));
  }
  add_claims();
  bounds.graph = bounds.graph || !eventual.empty() || !leads.empty();
  const bool planned_all = std::all_of(planned.operations().begin(), planned.operations().end(),
                                       [](const PlannedOperation& each) { return each.plan != nullptr; });
  if (bounds.symmetry && !bounds.graph && planned_all) exchange.emplace(planned, predicates);
  if (exchange && exchange->sets().empty()) exchange.reset();
}

/// Says whether the state is there now; one beyond the bounds is not.
bool StateSpace::Impl::reach(std::span<const ValueId> state, StateIndex from, StateIndex& found) {
  if (const auto at = table.find(state)) {
    found = *at;
    return true;
  }
  if (table.size() >= bounds.states) {
    cut = true;
    return false;
  }
  found = table.add(state, from, StateTable::none);
  depths.push_back(from == StateTable::none ? 0 : depths[from] + 1);
  report.depth = std::max(report.depth, depths.back());
  weights_.push_back(1);
  queue.push_back(found);
  if (exchange) add_class(found);
  try_state(found);
  return true;
}

/// Adds every state that exchanges of members make of a new one. They stand for it.
void StateSpace::Impl::add_class(StateIndex first) {
  std::vector<StateIndex> open{first};
  std::vector<ValueId> other;
  for (std::size_t i = 0; i < open.size(); ++i)
    for (std::size_t swap = 0; swap < exchange->size(); ++swap) {
      exchange->exchange(swap, table.state(open[i]), other);
      if (table.find(other)) continue;
      if (table.size() >= bounds.states) {
        cut = true;
        continue;
      }
      open.push_back(table.add(other, StateTable::none, first));
      depths.push_back(depths[first]);
      weights_.push_back(0);
      ++weights_[first];
    }
}

void StateSpace::Impl::begin(const std::vector<zed::Valuation>& from) {
  StateIndex found = 0;
  if (from.empty()) {
    const StepRows rows = planned.rows(planned.initial(), {});
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const auto row = rows.row(i);
      if (!reach(row.subspan(row.size() - planned.components()), StateTable::none, found)) continue;
      try_step(planned.operations().size(), 0, row);
    }
  } else {
    exchange.reset();  // the states that were given may tell members apart
    for (const zed::Valuation& state : from) reach(planned.ids(state), StateTable::none, found);
  }
  initial_size = table.size();
  report.initial = table.size();
}

/// Goes on from a state by each operation.
void StateSpace::Impl::go_on(StateIndex at) {
  bool some = false;
  auto& operations = planned.operations();
  const std::vector<ValueId> before(table.state(at).begin(), table.state(at).end());
  for (std::size_t i = 0; i < operations.size(); ++i) {
    const StepRows& rows = planned.rows(operations[i], before);
    some = some || rows.size() > 0;
    OperationCoverage& covered = report.operations[i];
    covered.states += rows.size() > 0 ? weight(at) : 0;
    covered.transitions += rows.size() * weight(at);
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const auto row = rows.row(r);
      StateIndex to = 0;
      const bool there = reach(row.subspan(row.size() - planned.components()), at, to);
      if (!there) cut_from.insert(at);
      if (bounds.graph && there) {
        edges.push_back({at, to, static_cast<std::uint32_t>(i), edge_rows.size()});
        edge_rows.insert(edge_rows.end(), row.begin(), row.end());
      }
      try_step(i, at, row);
    }
  }
  if (some) return;
  report.deadlocks += weight(at);
  if (deadlocked.size() < most_deadlock_ways) deadlocked.push_back(at);
}

void StateSpace::Impl::explore(const std::vector<zed::Valuation>& from) {
  for (const PlannedOperation& operation : planned.operations())
    report.operations.push_back({operation.name, 0, 0, {}, operation.plan == nullptr});
  begin(from);
  for (std::size_t at = 0; at < queue.size(); ++at) {
    if (at % states_between_calls == 0 && bounds.go_on && !bounds.go_on(table.size(), at)) {
      report.stopped = true;
      break;
    }
    go_on(queue[at]);
    gone_on = at + 1;
  }
  finish();
}

void StateSpace::Impl::finish() {
  report.states = table.size();
  report.classes = queue.size();
  if (exchange) report.exchanged = exchange->sets();
  for (std::size_t i = 0; i < report.operations.size(); ++i) {
    OperationCoverage& covered = report.operations[i];
    report.transitions += covered.transitions;
    for (const FactCount& count : planned.operations()[i].counts)
      covered.facts.push_back({zed::to_unicode(count.fact), count.fact->place, count.yes, count.no});
  }
  add_refuted();
  for (const StateIndex at : deadlocked) report.deadlock_ways.push_back(way_to(at));
  if (cut) planned.bounded().insert("states: --states");
  try_liveness();
  for (const ExploredClaim& claim : claims) {
    report.claims += claim.asked ? 1 : 0;
    report.open += claim.open_somewhere && !claim.false_somewhere ? 1 : 0;
  }
  report.claims += eventual.size() + leads.size();
  report.bounded.assign(planned.bounded().begin(), planned.bounded().end());
}

}  // namespace durero::spec
