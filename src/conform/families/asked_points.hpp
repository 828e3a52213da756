#pragma once
/// The points that the nearest is asked to lie where systems fail: near surfaces and between them, at centres, far
/// away.

#include "durero/conform/families/suite.hpp"

namespace durero::conform {

/// Puts the origin of each ray to such a point: where it was, near or between crossings of the ray, at the centre or a
/// vertex of an element, or far away.
void put_points_near(SuiteCase& of, NumberFormat numbers, Random& random);

/// Turns each ray to the nearest point, with a v of length 1 up to a rounding. Precondition: nearest points of the case
/// were answered.
void turn_to_nearest(SuiteCase& of);

}  // namespace durero::conform
