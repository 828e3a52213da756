#pragma once
/// The construction of a hierarchy from the root downwards, by the surface area heuristic.

#include <span>

#include "durero/accel/hierarchy.hpp"

namespace durero::accel {

/// Joins leaves without a place to one tree, and answers its root. Each set is cut in two, in the order of the centres
/// along an axis, by the least sum of A·n over both parts, with A their surfaces and n their numbers. A node then gives
/// way to its children where that lowers Σ k·A and its parent keeps to `most_children`. Reorders `leaves`. The tree is
/// no deeper than 40 + ⌈log₂ n⌉ steps. Precondition: there is a leaf.
Hierarchy::Number top_down(Hierarchy& tree, std::span<Hierarchy::Number> leaves, unsigned most_children);

}  // namespace durero::accel
