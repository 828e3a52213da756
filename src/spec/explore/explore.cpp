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

/// Watches an exploration as long as it is there.
class Watched {
 public:
  Watched(SearchWatch& watch, std::function<bool()> may_go_on) : watch_(watch) { watch_.watch(std::move(may_go_on)); }
  ~Watched() { watch_.watch({}); }
  Watched(const Watched&) = delete;
  Watched& operator=(const Watched&) = delete;

 private:
  SearchWatch& watch_;
};

}  // namespace

StateSpace::Impl::Impl(const Machine& of, ExploreBounds how)
    : machine(of), bounds(std::move(how)), planned(of, {bounds.low, bounds.high}), table(of.components().size()) {
  std::vector<Term> predicates;
  for (const std::string& always : bounds.always) predicates.push_back(state_predicate(always, "--always"));
  for (const std::string& text : bounds.eventually) {
    predicates.push_back(state_predicate(text, "--eventually"));
    eventual.emplace_back(predicates.back(), "eventually " + zed::to_unicode(predicates.back()));
  }
  for (const auto& [first, then] : bounds.leads_to) {
    const Term p = state_predicate(first, "--leads-to"), q = state_predicate(then, "--leads-to");
    predicates.insert(predicates.end(), {p, q});
    leads.emplace_back(p, q, zed::to_unicode(p) + " leads to " + zed::to_unicode(q));
  }
  bounds.graph = bounds.graph || !eventual.empty() || !leads.empty();
  const Watched watched(machine.parts().watch, [this] { return may_go_on(); });
  try {
    plan(predicates);
  } catch (const StoppedSearch&) {  // the report says by what
    report.planned = false;
  }
}

/// Plans the operations, and translates the claims about states; those about steps are translated where they are asked.
void StateSpace::Impl::plan(const std::vector<Term>& predicates) {
  planned.plan();
  for (std::size_t i = 0; i < bounds.always.size(); ++i)
    add_claim("always " + zed::to_unicode(predicates[i]), "--always", predicates[i]);
  add_claims();
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
  note_initial();
}

/// The states so far are initial.
void StateSpace::Impl::note_initial() {
  initial_size = table.size();
  report.initial = table.size();
}

/// Goes on from a state by the steps of an operation.
void StateSpace::Impl::go_by(std::size_t operation, StateIndex at, const StepRows& rows) {
  OperationCoverage& covered = report.operations[operation];
  covered.states += rows.size() > 0 ? weight(at) : 0;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    machine.parts().watch.count();
    covered.transitions += weight(at);
    const auto row = rows.row(r);
    StateIndex to = 0;
    const bool there = reach(row.subspan(row.size() - planned.components()), at, to);
    if (!there) cut_from.insert(at);
    if (bounds.graph && there) {
      edges.push_back({at, to, static_cast<std::uint32_t>(operation), edge_rows.size()});
      edge_rows.insert(edge_rows.end(), row.begin(), row.end());
    }
    try_step(operation, at, row);
  }
}

/// Goes on from a state by each operation.
void StateSpace::Impl::go_on(StateIndex at) {
  bool some = false;
  auto& operations = planned.operations();
  const std::vector<ValueId> before(table.state(at).begin(), table.state(at).end());
  for (std::size_t i = 0; i < operations.size(); ++i) {
    machine.parts().watch.count();
    const StepRows& rows = planned.rows(operations[i], before);
    some = some || rows.size() > 0;
    go_by(i, at, rows);
  }
  if (some) return;
  report.deadlocks += weight(at);
  if (deadlocked.size() < most_deadlock_ways) deadlocked.push_back(at);
}

/// Says whether the time is not over, and nobody stops it.
bool StateSpace::Impl::may_go_on() {
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - bounds.begun;
  report.late = taken.count() > bounds.seconds;
  report.stopped = !report.late && bounds.go_on && !bounds.go_on(table.size(), gone_on);
  return !report.late && !report.stopped;
}

/// Goes on from each state. A state in which it is stopped was not gone on from, so that it is no deadlock, and no way
/// ends there.
void StateSpace::Impl::go_through(const std::vector<zed::Valuation>& from) {
  const Watched watched(machine.parts().watch, [this] { return may_go_on(); });
  try {
    begin(from);
    for (; gone_on < queue.size(); ++gone_on) go_on(queue[gone_on]);
  } catch (const StoppedSearch&) {  // the report says by what
    if (initial_size == 0) note_initial();
  }
}

void StateSpace::Impl::explore(const std::vector<zed::Valuation>& from) {
  for (const PlannedOperation& operation : planned.operations())
    report.operations.push_back({operation.name, 0, 0, {}, report.planned && operation.plan == nullptr});
  if (report.planned) go_through(from);
  finish();
}

void StateSpace::Impl::finish() {
  report.states = table.size();
  report.classes = queue.size();
  if (exchange) report.exchanged = exchange->sets();
  for (std::size_t i = 0; i < report.operations.size(); ++i) {
    OperationCoverage& covered = report.operations[i];
    report.transitions += covered.transitions;
    if (!report.planned) continue;  // nothing was asked
    for (const FactCount& count : planned.operations()[i].counts)
      covered.facts.push_back({zed::to_unicode(count.fact), count.fact->place, count.yes, count.no});
  }
  add_refuted();
  for (const StateIndex at : deadlocked) report.deadlock_ways.push_back(way_to(at));
  if (cut) planned.bounded().insert("states: --states");
  if (report.late) planned.bounded().insert("states: --time");
  try_liveness();
  for (const ExploredClaim& claim : claims) {
    report.claims += claim.asked ? 1 : 0;
    report.open += claim.open_somewhere && !claim.false_somewhere ? 1 : 0;
  }
  report.claims += eventual.size() + leads.size();
  report.bounded.assign(planned.bounded().begin(), planned.bounded().end());
}

}  // namespace durero::spec
