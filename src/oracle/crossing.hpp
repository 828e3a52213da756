#pragma once
/// Whether a ray crosses a surface before a distance, told from points of the surface, finer and finer where the ray
/// comes near.
///
/// Let w be a point of the surface within D of the ray, f the foot of w on the ray, n the normal at w and d the
/// direction of the ray. Let no rim or apex be within 20D of w, in the surface, and let its curvature be at most
/// κ ≤ 1/(36D) within 10D. Then, if |d·n| > 1/8 + 82/8·κD, the ray meets the surface at f ± 8D.
///   For along a path of length s in the surface the normal turns by at most κs, so that the height above the plane
///   that touches at w grows to at most κs²/2; within 10D of w, where κs < 1/3, the surface is the graph of a height
///   over a disc of radius 9D in that plane, and s is there at most 1.06 times the distance y from w in the plane, so
///   that the height is less than κy². At f ± 8D the ray is above or below w by at least 8D·|d·n| − D, on either side,
///   and y ≤ 9D, where the surface is at a height less than 81κD². So the ray is on one side of it at f − 8D, on the
///   other at f + 8D, and in between over the disc. That point is within 9D of w; where the surface is that of a leaf,
///   and every point of it within 9D of w is on the solid, so is this one.

#include "durero/oracle/sampled.hpp"
#include "element_surface.hpp"
#include "line.hpp"

namespace durero::oracle::sampled {

/// What the surface says to a claim that the ray does not meet it before the distance `before`, ∞ for a miss:
///   unsound: it does, by the proof above, with the foot's 8D on either side before that distance;
///   grazing, rim, origin: the points left cannot prove it, the ray being nearly tangent, near a rim, an apex or
///   another
///     leaf of the solid, or starting within 8D of the foot;
///   agrees: no point of the surface at hand is near the ray before that distance.
/// Points are `finest` from each other at the least; `slack` is the rounding of all distances.
SampledVerdict crossing(const ElementSurface& surface, const ScaledRay& line, double before, double finest,
                        double slack);

}  // namespace durero::oracle::sampled
