#include "durero/accel/lattice.hpp"

namespace durero::accel {

// The ray is in where it is between the planes of all three axes: right after the last of the crossings by which it
// comes in, unless it has left by then.
std::optional<Entry> entry(const Line& line, const Lattice& lattice) {
  Entry result{{}, line.start()};
  const auto outside = [&](int axis) { return result.cell[axis] < 0 || result.cell[axis] >= lattice.count[axis]; };
  bool within = true;
  for (int axis = 0; axis < 3; ++axis) {
    result.cell[axis] = lattice.place(axis, line.p()[axis]);
    if (!outside(axis)) continue;
    within = false;
    const bool from_below = result.cell[axis] < 0;
    if (line.v()[axis] == 0 || from_below == line.backwards(axis)) return {};
    const Crossing in = line.crossing(axis, lattice.plane(axis, from_below ? 0 : lattice.count[axis]));
    if (line.order(in, result.event) > 0) result.event = in;
  }
  if (within) return result;
  for (int axis = 0; axis < 3; ++axis) {
    result.cell[axis] = lattice.place_after(line, axis, result.event);
    if (outside(axis)) return {};
  }
  return result;
}

}  // namespace durero::accel
