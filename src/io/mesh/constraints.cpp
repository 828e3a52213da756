#include "constraints.hpp"

#include <optional>

namespace durero::io {
namespace {

using Edge = PlanarEdges::Edge;
using Point = PlanePoints::Number;

/// One edge on its way into a triangulation.
class Constraint {
 public:
  Constraint(PlanarEdges& edges, const PlanePoints& points, Point from, Point to)
      : edges_(edges), points_(points), from_(from), to_(to) {}

  bool put() {
    if (const auto known = edge_to_end()) {
      edges_.fix(*known);
      return true;
    }
    const auto first = edge_to_the_right();
    if (!first || !cross_from(*first)) return false;
    for (const Edge e : crossed_) edges_.remove(e);
    const Edge made = edges_.add(from_, to_);
    edges_.put_after(made, *first);
    edges_.put_after(PlanarEdges::twin(made), last_);
    edges_.fix(made);
    fill(made);
    fill(PlanarEdges::twin(made));
    restore();
    return true;
  }

 private:
  std::optional<Edge> edge_to_end() const {
    const Edge first = edges_.leaving(from_);
    Edge e = first;
    do {
      if (edges_.target(e) == to_) return e;
      e = edges_.after(e);
    } while (e != first);
    return std::nullopt;
  }

  int side(Point p) const { return points_.turn(from_, to_, p); }

  /// The edge in the star of the beginning to whose left the triangle lies that the constraint enters. Nothing where a
  /// point lies on it there.
  std::optional<Edge> edge_to_the_right() const {
    const bool goes_up = points_.is_before(from_, to_);
    Edge e = edges_.leaving(from_);
    for (int of_e = side(edges_.target(e));;) {
      const Point p = edges_.target(edges_.after(e));
      const int of_after = side(p);
      if (of_after == 0 && points_.is_before(from_, p) == goes_up) return std::nullopt;
      if (of_e < 0 && of_after > 0) return e;
      e = edges_.after(e);
      of_e = of_after;
    }
  }

  /// Walks through the triangles to the end. False where a point or a fixed edge is in the way.
  bool cross_from(Edge to_the_right) {
    for (Edge e = edges_.next(to_the_right);;) {  // from a point on the right to one on the left
      if (edges_.is_fixed(e)) return false;
      crossed_.push_back(e);
      const Edge on_right = edges_.next(PlanarEdges::twin(e)), on_left = edges_.next(on_right);
      if (edges_.origin(on_left) == to_) {
        last_ = on_left;
        return true;
      }
      const int of_apex = side(edges_.origin(on_left));
      if (of_apex == 0) return false;
      e = of_apex > 0 ? on_right : on_left;
    }
  }

  /// Cuts the face to the left of the constraint into triangles. From each edge of the face a triangle went over the
  /// constraint; so where two neighbours make a convex corner, the edge across it is free.
  void fill(Edge made) {
    Edge e = edges_.next(made);
    while (edges_.next(edges_.next(edges_.next(made))) != made) {
      const Edge following = edges_.next(e);
      if (points_.turn(edges_.origin(e), edges_.target(e), edges_.target(following)) <= 0) {
        e = following;
        continue;
      }
      fresh_.push_back(edges_.connect(following, e));
      e = PlanarEdges::twin(fresh_.back());
      if (edges_.previous(e) != made) e = edges_.previous(e);
    }
  }

  /// Flips edges until each has the property of Delaunay (Lawson 1977): the surface over the lifted points goes down
  /// with each flip, so that it ends.
  void restore() {
    while (!fresh_.empty()) {
      const Edge e = fresh_.back();
      fresh_.pop_back();
      if (edges_.is_fixed(e) || !points_.is_within_circle(edges_.origin(e), edges_.target(e), edges_.apex(e),
                                                          edges_.apex(PlanarEdges::twin(e))))
        continue;
      edges_.flip(e);
      for (const Edge side : {e, PlanarEdges::twin(e)})
        for (const Edge around : {edges_.next(side), edges_.previous(side)}) fresh_.push_back(around);
    }
  }

  PlanarEdges& edges_;
  const PlanePoints& points_;
  Point from_, to_;
  Edge last_{};                // from the end, the one to the left of the constraint
  std::vector<Edge> crossed_;  // in order
  std::vector<Edge> fresh_;    // may lack the property of Delaunay
};

}  // namespace

bool constrain(PlanarEdges& edges, const PlanePoints& points, PlanePoints::Number from, PlanePoints::Number to) {
  return Constraint(edges, points, from, to).put();
}

}  // namespace durero::io
