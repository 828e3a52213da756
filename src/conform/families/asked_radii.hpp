#pragma once
/// The radii of balls that are cast lie where systems fail: tiny, like the element, larger, and so that the ball just
/// touches an edge, a vertex or a limb, or just begins in touch.

#include <vector>

#include "durero/conform/families/suite.hpp"

namespace durero::conform {

/// The radius of each ray's ball, as the ranges of the rays. Most balls begin apart from everything, where the origin
/// does. Precondition: the case was answered.
std::vector<AskedRange> radii_of_balls(const SuiteCase& of, NumberFormat numbers, Random& random);

}  // namespace durero::conform
