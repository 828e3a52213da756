#pragma once
/// SEADS (Fujimoto): space in equal cubes, each with the list of the elements whose surfaces touch it, and 3DDDA
/// through them. Where the cubes lie depends on the box of the scene and on how many elements it has, and not on where
/// in it they are.

#include "durero/accel/cells.hpp"
#include "durero/accel/lattice.hpp"

namespace durero::accel {

/// How fine a grid is.
struct GridOptions {
  /// Cubes for each element, about. Of the measured curve, which falls towards few elements a cell and rises towards
  /// many cells to cross, the bottom.
  double cells_per_element = 8;
  /// No more references to elements than this for each element, and 4096: where elements are so large that there would
  /// be, the cubes are made larger.
  std::size_t references_per_element = 32;
};

/// A structure (accel/structure.hpp).
class Grid : public InCells {
 public:
  /// O(cells + references).
  explicit Grid(const scene::Scene& scene, const GridOptions& options = {});

  /// The cubes.
  const Lattice& lattice() const noexcept { return lattice_; }
  Size size() const;  ///< as of every structure

  /// Cell by cell in the order of the ray (search_cells).
  template <class Limit, class Visit>
  bool any(const trace::Ray& ray, Limit limit, Visit visit, Work& work) const {
    return search_cells(contents_, lists_, ray, limit, visit, work, [&](const Line& line, auto look) {
      walk(line, lattice_, [&](const Cell& cell, const Crossing& event) { return look(lattice_.number(cell), event); });
    });
  }

 private:
  Lattice lattice_;
};

/// Cubes over a box, so many that there are `cells` of them or up to a fourth more along an axis, where their planes
/// are binary64 numbers.
Lattice cubes_over(const surface::Box& box, double cells);

}  // namespace durero::accel
