#pragma once
/// The edges between points of a plane.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "plane_points.hpp"

namespace durero::io {

/// A graph drawn in the plane without crossings. Each edge is two directed ones, twins of each other; those that leave
/// a point are its star, a ring that goes round counter-clockwise. So each directed edge has a face to its left.
class PlanarEdges {
 public:
  using Point = PlanePoints::Number;
  using Edge = std::uint32_t;  ///< a directed one

  explicit PlanarEdges(std::size_t points) : leaving_(points) {}

  static Edge twin(Edge e) noexcept { return e ^ 1U; }
  Point origin(Edge e) const { return ends_[e].origin; }
  Point target(Edge e) const { return origin(twin(e)); }
  /// @{ The neighbours in the star of the origin.
  Edge after(Edge e) const { return ends_[e].after; }
  Edge before(Edge e) const { return ends_[e].before; }
  /// @}
  /// @{ The neighbours around the face to the left.
  Edge next(Edge e) const { return before(twin(e)); }
  Edge previous(Edge e) const { return twin(after(e)); }
  /// @}
  /// The point of the triangle to the left that is no end of the edge.
  Point apex(Edge e) const { return target(next(e)); }
  /// An edge that leaves the point. Precondition: one does.
  Edge leaving(Point p) const { return leaving_[p]; }
  /// One more than the greatest edge.
  std::size_t count() const noexcept { return ends_.size(); }

  /// @{ A fixed edge is in the triangulation, whatever its circle; so is its twin.
  bool is_fixed(Edge e) const { return ends_[e].fixed; }
  void fix(Edge e) { ends_[e].fixed = ends_[twin(e)].fixed = true; }
  /// @}

  /// Adds an edge that is alone in the star of either end, until it is put into others.
  Edge add(Point from, Point to);
  /// Puts an edge that is alone in its star into that of another, behind it.
  void put_after(Edge alone, Edge e);
  /// Adds an edge from the target of one edge to the origin of another, across the face to the left of both; they, and
  /// what is between them, are to its left.
  Edge connect(Edge from, Edge to);
  void remove(Edge e);
  /// Gives an edge between two triangles the points across it as its ends.
  void flip(Edge e);

 private:
  struct EdgeEnd {
    Point origin;
    Edge after, before;
    bool fixed;
  };

  void leave_star(Edge e);

  std::vector<EdgeEnd> ends_;
  std::vector<Edge> leaving_;  // of each point
  std::vector<Edge> removed_;  // of each pair of twins the even one
};

}  // namespace durero::io
