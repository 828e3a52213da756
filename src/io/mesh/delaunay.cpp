#include "delaunay.hpp"

namespace durero::io {
namespace {

using Edge = PlanarEdges::Edge;
using Places = std::span<const PlanePoints::Number>;

/// Triangulates halves, and joins them from below to above.
class DelaunayHalves {
 public:
  DelaunayHalves(const PlanePoints& points, PlanarEdges& edges) : points_(points), edges_(edges) {}

  /// The hull's edges that leave its first point, with the outside to the right, and its last, with the outside to the
  /// left.
  struct HullEdges {
    Edge first, last;
  };

  HullEdges triangulate(Places by_place) {
    if (by_place.size() == 2) {
      const Edge e = edges_.add(by_place[0], by_place[1]);
      return {e, PlanarEdges::twin(e)};
    }
    if (by_place.size() == 3) return triangle(by_place);
    return joined(triangulate(by_place.first(by_place.size() / 2)), triangulate(by_place.subspan(by_place.size() / 2)));
  }

 private:
  bool is_left_of(PlanePoints::Number p, Edge e) const {
    return points_.turn(edges_.origin(e), edges_.target(e), p) > 0;
  }
  bool is_right_of(PlanePoints::Number p, Edge e) const {
    return points_.turn(edges_.origin(e), edges_.target(e), p) < 0;
  }

  HullEdges triangle(Places corners) {
    const Edge a = edges_.add(corners[0], corners[1]), b = edges_.add(corners[1], corners[2]);
    edges_.put_after(b, PlanarEdges::twin(a));
    const int turn = points_.turn(corners[0], corners[1], corners[2]);
    if (turn == 0) return {a, PlanarEdges::twin(b)};
    const Edge c = edges_.connect(b, a);
    return turn > 0 ? HullEdges{a, PlanarEdges::twin(b)} : HullEdges{PlanarEdges::twin(c), c};
  }

  HullEdges joined(HullEdges left, HullEdges right) {
    const Edge tangent = lower_tangent(left, right);
    rise(tangent);
    return {left.first, right.last};
  }

  /// The edge from right to left below which no point of either half lies; it becomes the first or the last one of the
  /// hull where it begins at their end.
  Edge lower_tangent(HullEdges& left, HullEdges& right) {
    Edge of_left = left.last, of_right = right.first;
    for (;;) {
      if (is_left_of(edges_.origin(of_right), of_left))
        of_left = edges_.next(of_left);
      else if (is_right_of(edges_.origin(of_left), of_right))
        of_right = edges_.after(PlanarEdges::twin(of_right));
      else
        break;
    }
    const Edge tangent = edges_.connect(PlanarEdges::twin(of_right), of_left);
    if (edges_.origin(of_left) == edges_.origin(left.first)) left.first = PlanarEdges::twin(tangent);
    if (edges_.origin(of_right) == edges_.origin(right.last)) right.last = tangent;
    return tangent;
  }

  /// Puts the edges between the halves above one of them, up to the upper tangent.
  void rise(Edge base) {
    for (;;) {
      const Edge on_left = candidate(edges_.after(PlanarEdges::twin(base)), base, &PlanarEdges::after),
                 on_right = candidate(edges_.before(base), base, &PlanarEdges::before);
      const bool left_is_above = is_above(on_left, base), right_is_above = is_above(on_right, base);
      if (!left_is_above && !right_is_above) return;
      const bool takes_right =
          !left_is_above ||
          (right_is_above && points_.is_within_circle(edges_.target(on_left), edges_.origin(on_left),
                                                      edges_.origin(on_right), edges_.target(on_right)));
      base = takes_right ? edges_.connect(on_right, PlanarEdges::twin(base))
                         : edges_.connect(PlanarEdges::twin(base), PlanarEdges::twin(on_left));
    }
  }

  bool is_above(Edge e, Edge base) const { return is_right_of(edges_.target(e), base); }

  /// The first edge in the star of an end of the base whose circle through the base holds no point of its half; those
  /// before it are removed.
  Edge candidate(Edge e, Edge base, Edge (PlanarEdges::*neighbour)(Edge) const) {
    while (is_above(e, base)) {
      const Edge following = (edges_.*neighbour)(e);
      if (!is_above(following, base) || !points_.is_within_circle(edges_.target(base), edges_.origin(base),
                                                                  edges_.target(e), edges_.target(following)))
        break;
      edges_.remove(e);
      e = following;
    }
    return e;
  }

  const PlanePoints& points_;
  PlanarEdges& edges_;
};

}  // namespace

PlanarEdges delaunay_edges(const PlanePoints& points, std::span<const PlanePoints::Number> by_place) {
  PlanarEdges edges(points.size());
  const Edge first = DelaunayHalves(points, edges).triangulate(by_place).first;
  // The outside is to the right of that edge, and to the left of its twin.
  Edge e = PlanarEdges::twin(first);
  do {
    edges.fix(e);
    e = edges.next(e);
  } while (e != PlanarEdges::twin(first));
  return edges;
}

}  // namespace durero::io
