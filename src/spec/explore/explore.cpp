#include "durero/spec/explore.hpp"

#include <algorithm>

#include "durero/zed/print/print.hpp"
#include "explore_impl.hpp"
#include "spec/claims.hpp"

namespace durero::spec {

using zed::Name;
using zed::Term;

namespace {

/// The first deadlocks have their ways in the report.
constexpr std::size_t most_deadlock_ways = 10;
/// Between so many states gone on from the exploration asks whether to go on.
constexpr std::size_t states_between_calls = 256;

/// S ⇒ Q, where Q is asked first: it is true of most states, and much the smaller.
IdTest consequent_first(const Term& instance, const std::function<IdTest(const Term&)>& test_of) {
  return [schemas = test_of(instance->children[0]), rest = test_of(instance->children[1])](IdFrame frame) {
    try {
      if (rest(frame)) return true;
    } catch (const Undecided&) {
      if (!schemas(frame)) return true;
      throw;
    }
    return !schemas(frame);
  };
}

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

Term StateSpace::Impl::state_predicate(const std::string& text, const std::string& option) const {
  const Machine::Parts& parts = machine.parts();
  std::vector<std::pair<Name, zed::Type>> locals = zed::calculator_names();
  for (const Name& name : machine.components()) locals.emplace_back(name, parts.types.at(name));
  Term term = parsed(text, parts.notation);
  const zed::Typing typing = zed::check_term(parts.typing, Machine::Parts::section_name, term, locals, option);
  if (!typing.ok()) {
    const zed::Defect& first = typing.defects.front();
    throw zed::ZError(first.place, first.what, first.expected);
  }
  const auto type = typing.type_of(term);
  if (type && !type->is_schema_set()) throw zed::ZError(term->place, "this is an expression", "expected a predicate");
  return term;
}

void StateSpace::Impl::add_claim(const std::string& text, const std::string& place, const Term& term) {
  claims.push_back({text, place, term, true, planned.state_test(term)});
}

/// Each conjecture is asked where it has all the names that it speaks of.
void StateSpace::Impl::add_claims() {
  const Machine::Parts& parts = machine.parts();
  const auto has_all = [](const FrameScope& scope, const std::vector<Name>& names) {
    return std::all_of(names.begin(), names.end(), [&](const Name& name) { return scope.places.contains(name); });
  };
  for (Machine::Parts::Claim& each : const_cast<Machine::Parts&>(parts).claims) {
    const auto names = included_names(parts.typing, each.term);
    ExploredClaim claim{each.text, each.place, each.term};
    if (!names) {
      const zed::Truth truth = each.truth ? *each.truth : parts.truth(each.term, {}, each);
      each.truth = truth;
      claim.asked = true;
      claim.open_somewhere = truth == zed::Truth::open;
      ++(claim.open_somewhere ? report.unanswered : report.answers);
      claim.false_somewhere = truth == zed::Truth::no;
      if (claim.false_somewhere) report.refuted.push_back({each.text, each.place, {}, {}});
      claims.push_back(std::move(claim));
      continue;
    }
    const Term instance = claim_instance(each.term);
    const auto& components = machine.components();
    claim.of_state = std::all_of(names->begin(), names->end(), [&](const Name& name) {
      return std::find(components.begin(), components.end(), name) != components.end();
    });
    if (claim.of_state) {
      claim.test = consequent_first(instance, [&](const Term& part) { return planned.state_test(part); });
    } else {
      auto& operations = planned.operations();
      for (std::size_t i = 0; i < operations.size(); ++i)
        if (has_all(operations[i].scope, *names))
          claim.step_tests.emplace_back(
              i, consequent_first(instance, [&](const Term& part) { return planned.step_test(operations[i], part); }));
      if (has_all(planned.initial().scope, *names))
        claim.step_tests.emplace_back(operations.size(), consequent_first(instance, [&](const Term& part) {
                                        return planned.step_test(planned.initial(), part);
                                      }));
    }
    claims.push_back(std::move(claim));
  }
}

template <class Test>
void StateSpace::Impl::ask(ExploredClaim& claim, Test&& test, const std::function<Refutation()>& refutation) {
  if (claim.false_somewhere) return;
  claim.asked = true;
  try {
    const bool holds = test(planned.frame());
    ++report.answers;
    if (holds) return;
    claim.false_somewhere = true;
    refutations.push_back(refutation());
  } catch (const Undecided&) {
    claim.open_somewhere = true;
    ++report.unanswered;
  } catch (const NotInterned&) {
    claim.open_somewhere = true;
    ++report.unanswered;
  }
}

void StateSpace::Impl::try_state(StateIndex at) {
  for (std::size_t i = 0; i < claims.size(); ++i) {
    if (!claims[i].test) continue;
    planned.load_state(table.state(at));
    ask(claims[i], claims[i].test, [&] { return Refutation{i, at, any_operation, {}}; });
  }
}

void StateSpace::Impl::try_step(std::size_t operation, StateIndex before, std::span<const ValueId> row) {
  const auto& operations = planned.operations();
  const bool is_initial = operation == operations.size();
  for (std::size_t i = 0; i < claims.size(); ++i)
    for (const auto& [of, test] : claims[i].step_tests) {
      if (of != operation) continue;
      planned.load(is_initial ? planned.initial() : operations[operation],
                   is_initial ? std::span<const ValueId>() : table.state(before), row);
      ask(claims[i], test, [&] {
        return Refutation{i, before, static_cast<std::uint32_t>(operation), {row.begin(), row.end()}};
      });
    }
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

void StateSpace::Impl::add_refuted() {
  for (const Refutation& each : refutations) {
    const ExploredClaim& claim = claims[each.claim];
    FalseClaim refuted{claim.text, claim.place, {}, {}};
    const auto& operations = planned.operations();
    if (each.operation == any_operation)
      refuted.way = way_to(each.before);
    else if (each.operation == operations.size())
      refuted.way = {planned.transition(planned.initial(), each.row)};
    else {
      // The step is from the first state of a class; a way that leads to another state of it has one like it.
      refuted.way = way_to(each.before);
      const auto& operation = operations[each.operation];
      if (!exchange) {
        refuted.way.push_back(planned.transition(operation, each.row));
      } else {
        add_false_step(refuted.way, each);
      }
    }
    report.refuted.push_back(std::move(refuted));
  }
}

/// The first step from the end of the way that makes the claim false.
void StateSpace::Impl::add_false_step(std::vector<Transition>& way, const Refutation& refutation) {
  auto& operation = planned.operations()[refutation.operation];
  const std::vector<ValueId> before = planned.ids(way.back().after);
  const StepRows rows = planned.rows(operation, before);
  for (const auto& [of, test] : claims[refutation.claim].step_tests)
    for (std::size_t i = 0; i < rows.size() && of == refutation.operation; ++i) {
      planned.load(operation, before, rows.row(i));
      if (test(planned.frame())) continue;
      way.push_back(planned.transition(operation, rows.row(i)));
      return;
    }
}

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
  std::vector<ValueId> row;
  for (const auto* given : {&step.inputs, &step.outputs, &step.after})
    for (const auto& [name, value] : *given) row.push_back(impl_->planned.values().of(value));
  return impl_->planned.admits(*at, impl_->planned.ids(before), row);
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
