#include "state_table.hpp"

#include <algorithm>

namespace durero::spec {

/// The place of the state among the slots, or the free one where it would stand.
std::size_t StateTable::place(std::span<const ValueId> wanted) const {
  std::size_t at = hash_of(wanted, 0) & (slots_.size() - 1);
  while (slots_[at] != none) {
    const auto here = state(slots_[at]);
    if (std::equal(here.begin(), here.end(), wanted.begin())) return at;
    at = (at + 1) & (slots_.size() - 1);
  }
  return at;
}

std::optional<StateIndex> StateTable::find(std::span<const ValueId> wanted) const {
  const StateIndex at = slots_[place(wanted)];
  return at == none ? std::nullopt : std::optional(at);
}

StateIndex StateTable::add(std::span<const ValueId> state, StateIndex parent, StateIndex of_class) {
  const auto at = static_cast<StateIndex>(size());
  slots_[place(state)] = at;
  ids_.insert(ids_.end(), state.begin(), state.end());
  parents_.push_back(parent);
  classes_.push_back(of_class == none ? at : of_class);
  if (size() * 2 > slots_.size()) grow();
  return at;
}

void StateTable::grow() {
  slots_.assign(slots_.size() * 2, none);
  for (StateIndex at = 0; at < size(); ++at) slots_[place(state(at))] = at;
}

}  // namespace durero::spec
