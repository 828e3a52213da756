#include "lasso_search.hpp"

#include <algorithm>
#include <deque>
#include <map>
#include <set>

namespace durero::spec {
namespace {

constexpr std::uint32_t no_component = 0xffffffff;

}  // namespace

/// Returns the strongly connected components among the states that are in, by Tarjan's algorithm with its own stack.
std::vector<std::uint32_t> LassoSearch::components(const std::vector<bool>& in, std::vector<Component>& found) const {
  constexpr std::uint32_t unseen = 0xffffffff;
  std::vector<std::uint32_t> number(steps_.size(), unseen), low(steps_.size(), 0), of(steps_.size(), no_component);
  std::vector<StateIndex> open;
  std::vector<std::pair<StateIndex, std::size_t>> calls;
  std::uint32_t next = 0;
  const auto enter = [&](StateIndex at) {
    number[at] = low[at] = next++;
    open.push_back(at);
    calls.emplace_back(at, 0);
  };
  for (StateIndex root = 0; root < steps_.size(); ++root) {
    if (!in[root] || number[root] != unseen) continue;
    for (enter(root); !calls.empty();) {
      const StateIndex at = calls.back().first;
      if (calls.back().second < steps_[at].size()) {
        const StateIndex to = steps_[at][calls.back().second++].to;
        if (!in[to]) continue;
        if (number[to] == unseen)
          enter(to);
        else if (of[to] == no_component)
          low[at] = std::min(low[at], number[to]);
        continue;
      }
      calls.pop_back();
      if (!calls.empty()) low[calls.back().first] = std::min(low[calls.back().first], low[at]);
      if (low[at] != number[at]) continue;
      found.emplace_back();
      for (StateIndex last = StateTable::none; last != at;) {
        last = open.back();
        open.pop_back();
        of[last] = static_cast<std::uint32_t>(found.size() - 1);
        found.back().push_back(last);
      }
    }
  }
  return of;
}

/// Says whether a way may go round in the component for ever: through all of it, where it is to be fair. An operation
/// that is possible in every state of it and leads out each time would be done at some time. In a part of the component
/// it would be so too, so no part need be asked.
bool LassoSearch::turns(const Component& component, const std::vector<std::uint32_t>& of, bool fair) const {
  if (component.size() < 2) return false;  // steps to the state itself are none
  if (!fair) return true;
  std::map<std::uint32_t, std::size_t> possible;
  std::set<std::uint32_t> done;
  for (const StateIndex at : component) {
    std::set<std::uint32_t> here;
    for (const GraphStep& step : steps_[at]) {
      here.insert(step.operation);
      if (of[step.to] == of[at]) done.insert(step.operation);
    }
    for (const std::uint32_t operation : here) ++possible[operation];
  }
  return std::all_of(possible.begin(), possible.end(),
                     [&](const auto& each) { return each.second < component.size() || done.contains(each.first); });
}

/// Returns a shortest path, by states; empty where there is none.
std::vector<StateIndex> LassoSearch::path(const std::vector<StateIndex>& from,
                                          const std::function<bool(StateIndex)>& into,
                                          const std::function<bool(StateIndex)>& in) const {
  std::map<StateIndex, StateIndex> before;
  std::deque<StateIndex> queue;
  for (const StateIndex at : from)
    if (in(at) && before.emplace(at, StateTable::none).second) queue.push_back(at);
  for (; !queue.empty(); queue.pop_front()) {
    if (into(queue.front())) {
      std::vector<StateIndex> way;
      for (StateIndex at = queue.front(); at != StateTable::none; at = before[at]) way.insert(way.begin(), at);
      return way;
    }
    for (const GraphStep& step : steps_[queue.front()])
      if (in(step.to) && before.emplace(step.to, queue.front()).second) queue.push_back(step.to);
  }
  return {};
}

/// Returns the steps of a way round in a component, from the state and back to it.
std::vector<GraphStep> LassoSearch::round(const Component& component, const std::vector<std::uint32_t>& of,
                                          StateIndex at, bool fair) const {
  const auto inside = [&](StateIndex each) { return of[each] == of[at]; };
  std::vector<GraphStep> way;
  std::set<StateIndex> seen;
  StateIndex now = at;
  const auto step_to = [&](const GraphStep& step) {
    way.push_back(step);
    seen.insert(step.to);
    now = step.to;
  };
  const auto go = [&](StateIndex to) {
    const auto part = path(
        {now}, [to](StateIndex each) { return each == to; }, inside);
    for (std::size_t i = 1; i < part.size(); ++i) step_to({part[i], any_operation});
  };
  std::set<std::uint32_t> done;
  for (const StateIndex each : fair ? component : Component{})  // all its states, and each operation that stays in it
    for (const GraphStep& step : steps_[each]) {
      if (!inside(step.to) || !done.insert(step.operation).second) continue;
      if (now != each) go(each);
      step_to(step);
    }
  for (const StateIndex each : fair ? component : Component{})
    if (!seen.contains(each)) go(each);
  if (way.empty())
    step_to(*std::find_if(steps_[at].begin(), steps_[at].end(), [&](const GraphStep& to) { return inside(to.to); }));
  if (now != at) go(at);
  return way;
}

std::optional<LassoWay> LassoSearch::find(const std::vector<StateIndex>& from, const std::vector<bool>& in,
                                          bool fair) const {
  std::vector<Component> found;
  const std::vector<std::uint32_t> of = components(in, found);
  std::vector<bool> turning(found.size());
  for (std::size_t i = 0; i < found.size(); ++i) turning[i] = turns(found[i], of, fair);
  const auto is_in = [&](StateIndex at) { return bool(in[at]); };
  LassoWay lasso;
  for (const StateIndex at : path(
           from, [&](StateIndex to) { return (steps_[to].empty() && ends_[to]) || turning[of[to]]; }, is_in))
    lasso.steps.push_back({at, any_operation});
  if (lasso.steps.empty()) return std::nullopt;
  const StateIndex last = lasso.steps.back().to;
  if (steps_[last].empty()) return lasso;
  lasso.loop = lasso.steps.size() - 1;
  const auto round = this->round(found[of[last]], of, last, fair);
  lasso.steps.insert(lasso.steps.end(), round.begin(), round.end());
  return lasso;
}

}  // namespace durero::spec
