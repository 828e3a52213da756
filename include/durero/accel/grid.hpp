#pragma once
/// The uniform grid SEADS (Fujimoto): equal cubes, each with a list of the elements whose surfaces touch it, and
/// traversal by 3DDDA. The cubes depend on the box of the scene and on the number of elements, not on the elements'
/// places.

#include "durero/accel/cells.hpp"
#include "durero/accel/lattice.hpp"

namespace durero::accel {

/// The resolution of a grid.
struct GridOptions {
  /// The approximate number of cubes for each element, at the bottom of the measured curve: fewer cubes hold more
  /// elements each, and more cubes take longer to cross.
  double cells_per_element = 8;
  /// The greatest number of references for each element, beside 4096 more. Where elements are so large that there would
  /// be more, the cubes are made larger.
  std::size_t references_per_element = 32;
};

/// A grid over a scene: a structure (accel/structure.hpp).
class Grid : public InCells {
 public:
  /// Builds the grid of a scene, which must outlive it unedited. O(cells + references).
  explicit Grid(const scene::Scene& scene, const GridOptions& options = {});

  /// The cubes.
  const Lattice& lattice() const noexcept { return lattice_; }
  Size size() const;  ///< the grid's size

  /// Tests the elements of cell after cell in the order of the ray (search_cells).
  template <class Limit, class Visit>
  bool any(const trace::Ray& ray, Limit limit, Visit visit, Work& work) const {
    return search_cells(contents_, lists_, ray, limit, visit, work, [&](const AxisRay& line, auto look) {
      walk(line, lattice_,
           [&](const Cell& cell, const PlaneCrossing& event) { return look(lattice_.number(cell), event); });
    });
  }

 private:
  Lattice lattice_;
};

/// About `cells` equal cubes over a box, up to a fourth more along an axis, whose planes are binary64 numbers.
Lattice cubes_over(const surface::Box& box, double cells);

}  // namespace durero::accel
