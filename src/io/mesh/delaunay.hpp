#pragma once
/// The Delaunay triangulation of points.

#include "planar_edges.hpp"
#include "plane_points.hpp"

namespace durero::io {

/// The edges of the Delaunay triangulation: no point lies within the circle of a triangle, as
/// PlanePoints::is_within_circle() decides, so that there is one alone. The edges of the convex hull are fixed. Points
/// on one line have the edges between neighbours. It takes O(n log n) decisions (Guibas and Stolfi 1985). Precondition:
/// two points or more, of which no two are one; by_place has their numbers, in their order.
PlanarEdges delaunay_edges(const PlanePoints& points, std::span<const PlanePoints::Number> by_place);

}  // namespace durero::io
