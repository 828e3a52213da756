#pragma once
/// All states that a machine can reach, breadth first. Operations are planned once, and states are numbers of values
/// that are kept once: so a machine with finite sets goes through some ten thousands of states in a second.
///
/// A number that nothing bounds is tried within bounds, which the report then names. Members of given sets that the
/// text does not tell apart are interchangeable: of states that differ by such an exchange alone one is gone on from,
/// and the others are counted with it.

#include <chrono>
#include <functional>
#include <limits>

#include "durero/spec/animation.hpp"

namespace durero::spec {

/// How far a machine is explored, and what of it is asked.
struct ExploreBounds {
  std::size_t states = 100'000;           ///< so many states are found at most
  std::int64_t low = 0, high = 3;         ///< numbers that nothing else bounds are tried from `low` to `high`
  bool symmetry = true;                   ///< interchangeable members of given sets are taken for each other
  bool graph = false;                     ///< the transitions are kept; symmetry is off then
  std::vector<std::string> always{};      ///< predicates that each state is to satisfy, as Z
  std::vector<std::string> eventually{};  ///< predicates that some state on every way is to satisfy
  /// Pairs P, Q: each state with P is to be followed by one with Q, on every way. A way goes on where it can: steps
  /// that leave the state as it is are no part of it.
  std::vector<std::pair<std::string, std::string>> leads_to{};
  bool fair =
      false;  ///< on a way that has no end an operation that stays possible is done at some time (weak fairness)
  double seconds = std::numeric_limits<double>::infinity();  ///< it goes on for so long at most, from `begun` on
  /// The time runs from here: from the making of these bounds, unless it is set.
  std::chrono::steady_clock::time_point begun = std::chrono::steady_clock::now();
  /// Called now and then, while operations are planned and within a state's steps too, with the states found and gone
  /// on from; false stops the exploration. The steps that were being looked for are not in the report then.
  std::function<bool(std::size_t states, std::size_t done)> go_on{};
};

/// How often a predicate of an operation was found true, and false, where the search asked it.
struct FactCoverage {
  std::string predicate;  ///< in Unicode
  zed::Place place;       ///< it begins here
  std::uint64_t yes = 0;  ///< so often it was true
  std::uint64_t no = 0;   ///< so often it was false
};

/// The deeds of an operation in an exploration.
struct OperationCoverage {
  std::string name;                   ///< of its schema
  std::uint64_t transitions = 0;      ///< so many were found
  std::uint64_t states = 0;           ///< in so many states it could happen
  std::vector<FactCoverage> facts{};  ///< those of its predicates that were asked, but for the state's own
  bool evaluated = false;             ///< the evaluator looked for its steps, as they could not be planned
};

/// A claim that is false, with a shortest way to where it is.
struct FalseClaim {
  std::string claim;                  ///< in Unicode
  std::string place;                  ///< FILE:LINE, or the option that asked it
  std::vector<Transition> way;        ///< the first transition is the initial one
  std::optional<std::size_t> loop{};  ///< the way goes round from the state after this transition, for ever
};

/// The result of an exploration.
struct ExploreReport {
  std::uint64_t states = 0;              ///< so many were found
  std::uint64_t transitions = 0;         ///< so many were found, each step of each state
  std::uint64_t classes = 0;             ///< states up to an exchange of members
  std::vector<std::string> exchanged{};  ///< the given sets whose members were taken for each other
  std::size_t depth = 0;                 ///< the greatest number of steps that a state takes from an initial one
  std::uint64_t initial = 0;             ///< so many states are initial
  std::uint64_t deadlocks = 0;           ///< states in which no operation can happen
  std::vector<std::vector<Transition>> deadlock_ways{};  ///< a shortest way to each of the first of them
  std::vector<OperationCoverage> operations{};           ///< by name
  std::vector<FalseClaim> refuted{};                     ///< each claim that is false
  std::uint64_t claims = 0;                              ///< claims that were tried
  std::uint64_t open = 0;                                ///< claims that were not decided somewhere
  std::uint64_t answers = 0;                             ///< the answers about them, in states and steps, yes or no
  std::uint64_t unanswered = 0;                          ///< the questions without an answer
  std::vector<std::string> bounded{};                    ///< what was left out, by the flag that would admit it
  bool stopped = false;                                  ///< `go_on` stopped it
  bool late = false;                                     ///< its time was over before it came to an end
  bool planned = true;  ///< it did not end so while operations were planned, and no state was looked for then
  /// Says whether there may be more than was found.
  bool is_bounded() const { return stopped || late || !bounded.empty(); }
};

/// The states that a machine can reach.
class StateSpace {
 public:
  /// Of a machine that outlives it, whose operations it plans. Throws zed::ZError where a predicate of the bounds is
  /// none of a state.
  StateSpace(const Machine& machine, ExploreBounds bounds);
  ~StateSpace();
  StateSpace(const StateSpace&) = delete;
  StateSpace& operator=(const StateSpace&) = delete;

  /// Explores from the initial states, or from these.
  const ExploreReport& explore(const std::vector<zed::Valuation>& from = {});
  /// The result of explore().
  const ExploreReport& report() const;

  /// How many states were found; the first ones are initial.
  std::size_t size() const;
  /// A state, by its place.
  zed::Valuation state(std::size_t at) const;
  /// A shortest way to the state, or to one like it but for an exchange of members.
  std::vector<Transition> way_to(std::size_t at) const;
  /// The transitions from a state, each with the place of the state after it; nothing where that was not found.
  std::vector<std::pair<Transition, std::optional<std::size_t>>> steps_from(std::size_t at) const;
  /// The states and transitions, where the bounds keep them.
  StateGraph graph() const;
  /// Whether the operation admits the transition. Throws EvaluationError where that is not decided.
  bool admits(const zed::Valuation& before, const Transition& step) const;

  struct Impl;  ///< what it is made of

 private:
  std::unique_ptr<Impl> impl_;
};

}  // namespace durero::spec
