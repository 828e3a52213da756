#include "planar_edges.hpp"

namespace durero::io {

PlanarEdges::Edge PlanarEdges::add(Point from, Point to) {
  Edge e = static_cast<Edge>(ends_.size());
  if (removed_.empty()) {
    ends_.resize(ends_.size() + 2);
  } else {
    e = removed_.back();
    removed_.pop_back();
  }
  ends_[e] = {from, e, e, false};
  ends_[twin(e)] = {to, twin(e), twin(e), false};
  leaving_[from] = e;
  leaving_[to] = twin(e);
  return e;
}

void PlanarEdges::put_after(Edge alone, Edge e) {
  const Edge behind = after(e);
  ends_[alone].before = e;
  ends_[alone].after = behind;
  ends_[e].after = ends_[behind].before = alone;
}

PlanarEdges::Edge PlanarEdges::connect(Edge from, Edge to) {
  const Edge behind = next(from);
  const Edge e = add(target(from), origin(to));
  put_after(e, behind);
  put_after(twin(e), to);
  return e;
}

void PlanarEdges::leave_star(Edge e) {
  leaving_[origin(e)] = after(e);
  ends_[after(e)].before = before(e);
  ends_[before(e)].after = after(e);
  ends_[e].after = ends_[e].before = e;
}

void PlanarEdges::remove(Edge e) {
  leave_star(e);
  leave_star(twin(e));
  removed_.push_back(e & ~1U);
}

void PlanarEdges::flip(Edge e) {
  const Edge of_left = previous(e), of_right = previous(twin(e));  // they end where e and its twin begin
  leave_star(e);
  leave_star(twin(e));
  ends_[e].origin = origin(of_right);
  ends_[twin(e)].origin = origin(of_left);
  put_after(e, of_right);
  put_after(twin(e), of_left);
}

}  // namespace durero::io
