#pragma once
/// A lattice of equal cubes, and its traversal by 3DDDA (Fujimoto), which steps from cell to cell by comparing the
/// parameters of exact crossings.
///
/// The traversal follows the line itself: it visits the cells that hold its points, by the rule of accel/line.hpp.
/// Fujimoto moves the origin to the centre of its cell first, which would follow another line.

#include <algorithm>
#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>

#include "durero/accel/line.hpp"
#include "durero/surface/bounds.hpp"

namespace durero::accel {

/// A cell of a lattice, by its place along each axis.
using Cell = glm::ivec3;

/// count.x · count.y · count.z cubes. All planes between cubes are binary64 numbers, because low is a whole multiple of
/// h, h has at most 8 significant bits, and no plane is more than 2⁴⁴ times h.
struct Lattice {
  glm::dvec3 low;  ///< the least corner
  double h;        ///< the side of a cube, as a length
  Cell count;      ///< the number along each axis, at least 1

  bool operator==(const Lattice&) const = default;

  /// The lower plane of the cells at a place.
  double plane(int axis, int place) const { return low[axis] + place * h; }
  /// The closed cube of a cell.
  surface::Box box(const Cell& cell) const {
    return {{plane(0, cell.x), plane(1, cell.y), plane(2, cell.z)},
            {plane(0, cell.x + 1), plane(1, cell.y + 1), plane(2, cell.z + 1)}};
  }
  /// The closed box of all cubes.
  surface::Box whole() const { return {low, {plane(0, count.x), plane(1, count.y), plane(2, count.z)}}; }
  /// The number of cubes.
  std::size_t size() const {
    return static_cast<std::size_t>(count.x) * static_cast<std::size_t>(count.y) * static_cast<std::size_t>(count.z);
  }
  /// The number of a cell, in 0 … size() − 1.
  std::size_t number(const Cell& cell) const {
    const auto at = [](int place) { return static_cast<std::size_t>(place); };
    return (at(cell.z) * at(count.y) + at(cell.y)) * at(count.x) + at(cell.x);
  }
  /// The place of a coordinate; −1 below the lattice, count beyond it.
  int place(int axis, double x) const {
    return greatest(axis, x, [&](int i) { return plane(axis, i) <= x; });
  }
  /// The place right after a crossing of any plane.
  int place_after(const AxisRay& line, int axis, const PlaneCrossing& event) const {
    const double x = line.p()[axis] + event.t * line.v()[axis];
    return greatest(axis, x, [&](int i) { return line.above(axis, plane(axis, i), event); });
  }

 private:
  /// The greatest place whose plane is below, or −1. The guess affects the time only.
  template <class Below>
  int greatest(int axis, double guess, Below below) const {
    const double steps = std::floor((guess - low[axis]) / h);
    int least = -1, above = count[axis] + 1;
    const int at = steps >= 0 ? (steps <= count[axis] ? static_cast<int>(steps) : count[axis]) : -1;
    if (at >= 0) (below(at) ? least : above) = at;
    if (least == at && at + 1 < above) (below(at + 1) ? least : above) = at + 1;
    while (above - least > 1) {
      const int middle = least + (above - least) / 2;
      (below(middle) ? least : above) = middle;
    }
    return least;
  }
};

/// The next of three crossings, one across each axis, and the axes whose crossings coincide with it.
struct Next {
  PlaneCrossing event;  ///< the first crossing
  unsigned axes;        ///< bit i: the crossing across axis i coincides with it
};

/// The first of three crossings.
inline Next first_of(const AxisRay& line, const PlaneCrossing (&crossings)[3]) {
  Next next{crossings[0], 1};
  for (int axis = 1; axis < 3; ++axis) {
    const int order = line.order(crossings[axis], next.event);
    const unsigned bit = 1u << axis;
    if (order < 0) next = {crossings[axis], bit};
    if (order == 0) next.axes |= bit;
  }
  return next;
}

/// The crossing by which a ray enters a half-open box, or its start; nothing where the ray has no point in the box.
std::optional<PlaneCrossing> way_in(const AxisRay& line, const surface::Box& box);

/// The crossing by which a ray leaves a box. Precondition: the ray is in it.
inline Next way_out(const AxisRay& line, const surface::Box& box) {
  PlaneCrossing out[3];
  for (int axis = 0; axis < 3; ++axis)
    out[axis] = line.crossing(axis, (line.backwards(axis) ? box.low : box.high)[axis]);
  return first_of(line, out);
}

/// Calls visit(cell, event) for every cell that holds a point of the ray, in the order of the ray, with the crossing by
/// which the cell is entered, until visit answers true. Whether it did.
template <class Visit>
bool walk(const AxisRay& line, const Lattice& lattice, Visit visit) {
  const std::optional<PlaneCrossing> first = way_in(line, lattice.whole());
  if (!first) return false;
  PlaneCrossing event = *first;
  Cell cell;
  for (int axis = 0; axis < 3; ++axis) cell[axis] = lattice.place_after(line, axis, event);
  PlaneCrossing out[3];
  const auto out_of_cell = [&](int axis) {
    return line.crossing(axis, lattice.plane(axis, cell[axis] + (line.backwards(axis) ? 0 : 1)));
  };
  for (int axis = 0; axis < 3; ++axis) out[axis] = out_of_cell(axis);
  for (;;) {
    if (visit(cell, event)) return true;
    const Next next = first_of(line, out);
    event = next.event;
    for (int axis = 0; axis < 3; ++axis) {
      if ((next.axes >> axis & 1) == 0) continue;
      cell[axis] += line.backwards(axis) ? -1 : 1;
      if (cell[axis] < 0 || cell[axis] >= lattice.count[axis]) return false;
      out[axis] = out_of_cell(axis);
    }
  }
}

}  // namespace durero::accel
