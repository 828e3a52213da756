#pragma once
/// A hierarchy from the root downwards, by surface area.

#include <span>

#include "durero/accel/hierarchy.hpp"

namespace durero::accel {

/// Joins leaves without a place to one tree, whose root it gives. Each set is cut in two, in the order of the centres
/// along an axis, where A·n of both parts, their surfaces and numbers, add up to least; then a node gives way to its
/// children where that lowers Σ k·A, as long as its parent keeps to so many children. Precondition: a leaf or more.
/// Reorders `leaves`. The tree is no deeper than 40 + ⌈log₂ n⌉ steps.
Hierarchy::Number top_down(Hierarchy& tree, std::span<Hierarchy::Number> leaves, unsigned most_children);

}  // namespace durero::accel
