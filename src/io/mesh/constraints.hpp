#pragma once
/// Edges that a triangulation must have.

#include "planar_edges.hpp"
#include "plane_points.hpp"

namespace durero::io {

/// Puts the edge between two points into a triangulation, and fixes it. The triangles keep the property of Delaunay
/// where edges are not fixed: of the two points across an edge neither is within the circle of the other's triangle.
/// False, and nothing is done, where another point lies on the edge, or it crosses a fixed one. It takes decisions for
/// the stars of its ends, for the edges that it crosses, and for the flips that follow. Precondition: the edges come
/// from delaunay_edges() of these points and from this function.
bool constrain(PlanarEdges& edges, const PlanePoints& points, PlanePoints::Number from, PlanePoints::Number to);

}  // namespace durero::io
