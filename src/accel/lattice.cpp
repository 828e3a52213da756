#include "durero/accel/lattice.hpp"

namespace durero::accel {

// A ray is in the box where it is between the planes of all three axes: right after the last of the crossings by which
// it enters between two planes, unless it has left by then.
std::optional<PlaneCrossing> way_in(const AxisRay& line, const surface::Box& box) {
  PlaneCrossing event = line.start();
  for (int axis = 0; axis < 3; ++axis) {
    const bool below = !line.above(axis, box.low[axis], line.start());
    const bool beyond = line.above(axis, box.high[axis], line.start());
    if (!below && !beyond) continue;
    if (line.v()[axis] == 0 || below == line.backwards(axis)) return {};
    const PlaneCrossing in = line.crossing(axis, below ? box.low[axis] : box.high[axis]);
    if (line.order(in, event) > 0) event = in;
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (!line.above(axis, box.low[axis], event) || line.above(axis, box.high[axis], event)) return {};
  }
  return event;
}

}  // namespace durero::accel
