#pragma once
/// The states that were found, each once, with the one from which each was found first.

#include <cstddef>
#include <optional>

#include "interned_values.hpp"

namespace durero::spec {

/// A state, by its place among those found.
using StateIndex = std::uint32_t;

class StateTable {
 public:
  static constexpr StateIndex none = 0xffffffff;

  explicit StateTable(std::size_t width) : width_(width), slots_(1 << 12, none) {}

  std::size_t size() const { return parents_.size(); }
  std::span<const ValueId> state(StateIndex at) const { return {ids_.data() + at * width_, width_}; }
  std::optional<StateIndex> find(std::span<const ValueId> state) const;
  /// Adds a state that is not there. `of_class` is the first state of its class, or `none` where it is that itself.
  StateIndex add(std::span<const ValueId> state, StateIndex parent, StateIndex of_class);
  StateIndex parent(StateIndex at) const { return parents_[at]; }
  /// The first state of the class of states that differ by an exchange of members alone.
  StateIndex class_of(StateIndex at) const { return classes_[at]; }

 private:
  std::size_t place(std::span<const ValueId> state) const;
  void grow();

  std::size_t width_;
  std::vector<ValueId> ids_;
  std::vector<StateIndex> parents_, classes_, slots_;
};

}  // namespace durero::spec
