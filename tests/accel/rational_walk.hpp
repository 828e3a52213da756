#pragma once
/// The cells that hold a point of a ray, by rational points of it: at every crossing of a plane and between each two.
/// It knows nothing of the order of crossings nor of what happens at once.

#include <algorithm>
#include <vector>

#include "durero/accel/lattice.hpp"
#include "durero/number/rational.hpp"
#include "support/shapes.hpp"

namespace durero::test {

using number::Rational;

/// The parameters at which to look: 0, every crossing of a plane, halfway between each two, and beyond the last.
inline std::vector<Rational> places_to_look(const model::Rayo& rayo, const std::vector<double> (&planes)[3]) {
  std::vector<Rational> crossings{0};
  for (int axis = 0; axis < 3; ++axis) {
    const double v = rayo.v().xyz()[axis];
    if (v == 0) continue;
    for (const double plane : planes[axis]) {
      const Rational t = (number::exact(plane) - number::exact(rayo.p().xyz()[axis])) / number::exact(v);
      if (t > 0) crossings.push_back(t);
    }
  }
  std::sort(crossings.begin(), crossings.end());
  std::vector<Rational> places;
  for (const Rational& t : crossings) {
    if (!places.empty()) places.push_back((places.back() + t) / 2);
    places.push_back(t);
  }
  places.push_back(crossings.back() + 1);
  return places;
}

/// A coordinate at a parameter.
inline Rational coordinate(const model::Rayo& rayo, int axis, const Rational& t) {
  return number::exact(rayo.p().xyz()[axis]) + t * number::exact(rayo.v().xyz()[axis]);
}

/// The cells of a lattice, in the order of the ray.
inline std::vector<accel::Cell> rational_walk(const model::Rayo& rayo, const accel::Lattice& lattice) {
  std::vector<double> planes[3];
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i <= lattice.count[axis]; ++i) planes[axis].push_back(lattice.plane(axis, i));
  std::vector<accel::Cell> cells;
  for (const Rational& t : places_to_look(rayo, planes)) {
    accel::Cell cell;
    bool within = true;
    for (int axis = 0; axis < 3; ++axis) {
      const Rational x = coordinate(rayo, axis, t);
      int below = 0;
      for (const double plane : planes[axis]) below += number::exact(plane) <= x ? 1 : 0;
      cell[axis] = below - 1;
      within = within && cell[axis] >= 0 && cell[axis] < lattice.count[axis];
    }
    if (within && (cells.empty() || cells.back() != cell)) cells.push_back(cell);
  }
  return cells;
}

/// Of half-open boxes, which ones hold points of the ray, in its order, by their places in the list. Each point must be
/// in no more than one of them; −1 stands for a repeated or doubled one.
inline std::vector<int> rational_walk(const model::Rayo& rayo, const std::vector<surface::Box>& boxes) {
  std::vector<double> planes[3];
  for (const surface::Box& box : boxes)
    for (int axis = 0; axis < 3; ++axis)
      for (const double plane : {box.low[axis], box.high[axis]})
        if (std::ranges::find(planes[axis], plane) == planes[axis].end()) planes[axis].push_back(plane);
  std::vector<int> found;
  for (const Rational& t : places_to_look(rayo, planes)) {
    // The greatest plane below decides as well as the point: planes are few, and fractions slow.
    glm::dvec3 below;
    for (int axis = 0; axis < 3; ++axis) {
      const Rational x = coordinate(rayo, axis, t);
      below[axis] = -std::numeric_limits<double>::infinity();
      for (const double plane : planes[axis])
        if (plane > below[axis] && number::exact(plane) <= x) below[axis] = plane;
    }
    int here = -2;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      bool within = true;
      for (int axis = 0; axis < 3; ++axis)
        within = within && boxes[i].low[axis] <= below[axis] && below[axis] < boxes[i].high[axis];
      if (within) here = here == -2 ? static_cast<int>(i) : -1;
    }
    if (here != -2 && (found.empty() || found.back() != here)) found.push_back(here);
  }
  return found;
}

}  // namespace durero::test
