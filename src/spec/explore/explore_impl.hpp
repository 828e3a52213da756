#pragma once
/// An exploration in progress.

#include "lasso_search.hpp"
#include "member_exchange.hpp"
#include "planned_machine.hpp"
#include "state_table.hpp"

namespace durero::spec {

/// A claim about states, or about steps, that an exploration tries.
struct ExploredClaim {
  std::string text, place;
  zed::Term term;
  bool of_state = false;
  IdTest test{};  ///< of a state
  /// Of the steps of operations; the initial one is last. One that was not asked yet is empty.
  std::vector<std::pair<std::size_t, IdTest>> step_tests{};
  bool false_somewhere = false, open_somewhere = false, asked = false;
};

struct StateSpace::Impl {
  Impl(const Machine& of, ExploreBounds how);

  struct Edge {
    StateIndex from, to;
    std::uint32_t operation;
    std::size_t row;  ///< where the row of the step begins
  };
  /// The place where a claim is false: a state, or the last of these steps.
  struct Refutation {
    std::size_t claim;
    StateIndex before;
    std::uint32_t operation;
    std::vector<ValueId> row;
  };

  void plan(const std::vector<zed::Term>& predicates);
  void explore(const std::vector<zed::Valuation>& from);
  std::vector<Transition> way_to(StateIndex at);
  Transition start(StateIndex at);
  /// A step of that operation, or of any, from one state to a state of the class of another.
  std::optional<std::pair<Transition, StateIndex>> step(StateIndex from, StateIndex to_class, std::uint32_t operation);

  void add_claims();
  IdTest step_claim(const ExploredClaim& claim, std::size_t operation);
  void add_claim(const std::string& text, const std::string& place, const zed::Term& term);
  zed::Term state_predicate(const std::string& text, const std::string& option) const;
  void begin(const std::vector<zed::Valuation>& from);
  void note_initial();
  void go_through(const std::vector<zed::Valuation>& from);
  void go_on(StateIndex at);
  void go_by(std::size_t operation, StateIndex at, const StepRows& rows);
  bool may_go_on();
  bool reach(std::span<const ValueId> state, StateIndex from, StateIndex& found);
  void add_class(StateIndex first);
  void try_state(StateIndex at);
  void try_step(std::size_t operation, StateIndex before, std::span<const ValueId> row);
  template <class Test>
  void ask(ExploredClaim& claim, Test&& test, const std::function<Refutation()>& refutation);
  void finish();
  void add_refuted();
  void add_false_step(std::vector<Transition>& way, const Refutation& refutation);
  std::vector<bool> ends() const;
  void try_liveness();
  void add_lasso(const std::string& claim, const std::string& option, const LassoWay& lasso);
  std::vector<bool> holds_in_each(const zed::Term& predicate);
  std::uint64_t weight(StateIndex at) const { return weights_.empty() ? 1 : weights_[at]; }

  const Machine& machine;
  ExploreBounds bounds;
  PlannedMachine planned;
  StateTable table;
  std::optional<MemberExchange> exchange{};
  std::vector<ExploredClaim> claims{};
  std::vector<Refutation> refutations{};
  std::vector<StateIndex> queue{}, deadlocked{};
  std::vector<std::uint64_t> weights_{};  // of the first state of each class
  std::vector<std::size_t> depths{};
  std::vector<Edge> edges{};
  std::vector<ValueId> edge_rows{};
  std::vector<std::pair<zed::Term, std::string>> eventual{};
  std::vector<std::tuple<zed::Term, zed::Term, std::string>> leads{};
  std::size_t initial_size = 0;
  std::set<StateIndex> cut_from{};  // a bound kept steps of these from being taken
  std::size_t gone_on = 0;          // so many of the queue were gone on from
  bool cut = false;                 // --states left out some
  ExploreReport report{};
};

}  // namespace durero::spec
