#include "durero/accel/grid.hpp"

#include <cmath>
#include <optional>

#include "durero/accel/touch.hpp"

namespace durero::accel {
namespace {

/// The cubes of one side over a box; nothing where a plane would be farther than 2⁴⁴ sides, or there were too many
/// cubes. A plane lies beyond the box's last point, since a point in a plane is above the plane.
std::optional<Lattice> cubes_of_side(const surface::Box& box, double h) {
  Lattice lattice{{}, h, {}};
  for (int axis = 0; axis < 3; ++axis) {
    double first = std::floor(box.low[axis] / h), last = std::floor(box.high[axis] / h);
    if (first * h > box.low[axis]) --first;
    if ((last + 1) * h <= box.high[axis]) ++last;
    if (std::abs(first) > 0x1p44 || std::abs(last) >= 0x1p44 || last - first >= 0x1p20) return {};
    lattice.low[axis] = first * h;
    lattice.count[axis] = static_cast<int>(last - first) + 1;
  }
  return lattice;
}

/// Calls visit(cell) for the cells of a lattice that an element touches.
template <class Visit>
void for_each_cell(const Contents& contents, std::uint32_t number, const Lattice& lattice, Visit visit) {
  const surface::Box box = contents.box_of(number);
  Cell first, last;
  for (int axis = 0; axis < 3; ++axis) {
    first[axis] = lattice.place(axis, box.low[axis]);
    last[axis] = lattice.place(axis, box.high[axis]);
    // An element that touches a plane is in the cells at both sides of it.
    if (first[axis] > 0 && lattice.plane(axis, first[axis]) == box.low[axis]) --first[axis];
  }
  contents.scene->visit(contents.elements[number], [&](const auto& shape) {
    for (int z = first.z; z <= last.z; ++z)
      for (int y = first.y; y <= last.y; ++y)
        for (int x = first.x; x <= last.x; ++x)
          if (touches(shape, lattice.box({x, y, z}))) visit(Cell(x, y, z));
  });
}

/// The number of cells that the elements' boxes reach into, an upper bound of the references.
double references_at_most(const Contents& contents, const Lattice& lattice) {
  double sum = 0;
  for (std::uint32_t number = 0; number < contents.elements.size(); ++number) {
    const surface::Box box = contents.box_of(number);
    double cells = 1;
    for (int axis = 0; axis < 3; ++axis) cells *= (box.high[axis] - box.low[axis]) / lattice.h + 1;
    sum += cells;
  }
  return sum;
}

Lattice chosen(const Contents& contents, const GridOptions& options) {
  const auto n = static_cast<double>(contents.elements.size());
  double cells = std::max(1.0, options.cells_per_element * n);
  const double most = static_cast<double>(options.references_per_element) * n + 4096;
  Lattice lattice = cubes_over(contents.box, cells);
  while (lattice.size() > 1 && references_at_most(contents, lattice) > most)
    lattice = cubes_over(contents.box, cells /= 8);
  return lattice;
}

Lists listed(const Contents& contents, const Lattice& lattice) {
  std::vector<Reference> references;
  for (std::uint32_t number = 0; number < contents.elements.size(); ++number) {
    for_each_cell(contents, number, lattice, [&](const Cell& cell) {
      references.push_back({number, static_cast<std::uint32_t>(lattice.number(cell))});
    });
  }
  return Lists::elements_of_cells(references, lattice.size());
}

}  // namespace

// The sides tried are m·2ᵏ with m from 15 down to 8, for one k after another: the first that gives enough cubes, or the
// last that gives few enough where none does.
Lattice cubes_over(const surface::Box& box, double cells) {
  double extent = 0;
  for (int axis = 0; axis < 3; ++axis)
    extent = std::max({extent, box.high[axis] - box.low[axis], 0x1p-140, 0x1p-44 * std::abs(box.low[axis]),
                       0x1p-44 * std::abs(box.high[axis])});
  int exponent = std::ilogb(extent) + 1;
  std::optional<Lattice> best = cubes_of_side(box, std::ldexp(1, exponent));
  while (!best) best = cubes_of_side(box, std::ldexp(1, ++exponent));
  for (exponent -= 4; static_cast<double>(best->size()) < cells && exponent > -144; --exponent) {
    for (int m = 15; m >= 8 && static_cast<double>(best->size()) < cells; --m) {
      const std::optional<Lattice> finer = cubes_of_side(box, std::ldexp(m, exponent));
      if (!finer || static_cast<double>(finer->size()) > 4 * cells + 8) return *best;
      best = finer;
    }
  }
  return *best;
}

Grid::Grid(const scene::Scene& scene, const GridOptions& options)
    : InCells(scene), lattice_(chosen(contents_, options)) {
  lists_ = listed(contents_, lattice_);
}

Size Grid::size() const {
  Size size = size_of_lists();
  size.cells = lists_.rows();
  size.depth = 1;
  size.bytes += sizeof(*this);
  return size;
}

}  // namespace durero::accel
