#pragma once
/// Ways without end in a graph of states, on which something never comes.

#include <functional>
#include <optional>
#include <vector>

#include "state_table.hpp"

namespace durero::spec {

/// A step of the graph, which leads to another state.
struct GraphStep {
  StateIndex to;
  std::uint32_t operation;
};

/// Any operation.
constexpr std::uint32_t any_operation = 0xffffffff;

/// A way: its steps, the first of which leads to its first state. From the last it goes round to the state at `loop`
/// where it has one; else it ends in a state from which no step leads to another.
struct LassoWay {
  std::vector<GraphStep> steps;
  std::optional<std::size_t> loop{};
};

class LassoSearch {
 public:
  /// Of the steps from each state, those to the state itself left out; of a state without steps `ends` says whether a
  /// way may end there.
  LassoSearch(const std::vector<std::vector<GraphStep>>& steps, std::vector<bool> ends)
      : steps_(steps), ends_(std::move(ends)) {}

  /// Returns a way that begins in one of these states, stays among the states that are in, and either ends or goes
  /// round for ever; a shortest one to the place where it turns. A fair way goes round only where each operation that
  /// is possible in each of its states is done. Nothing where there is none.
  std::optional<LassoWay> find(const std::vector<StateIndex>& from, const std::vector<bool>& in, bool fair) const;

 private:
  using Component = std::vector<StateIndex>;
  std::vector<std::uint32_t> components(const std::vector<bool>& in, std::vector<Component>& found) const;
  bool turns(const Component& component, const std::vector<std::uint32_t>& of, bool fair) const;
  std::vector<StateIndex> path(const std::vector<StateIndex>& from, const std::function<bool(StateIndex)>& into,
                               const std::function<bool(StateIndex)>& in) const;
  std::vector<GraphStep> round(const Component& component, const std::vector<std::uint32_t>& of, StateIndex at,
                               bool fair) const;

  const std::vector<std::vector<GraphStep>>& steps_;
  std::vector<bool> ends_;
};

}  // namespace durero::spec
