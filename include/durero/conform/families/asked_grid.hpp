#pragma once
/// A height field is a mesh that a system is asked about as a grid of heights: the judge knows its triangles alone.

#include <optional>
#include <string>
#include <vector>

#include "durero/scene/scene.hpp"

namespace durero::conform {

/// A grid of heights: the points (x + i·dx, y + j·dy, heights[i·rows + j]). The cell of i and j has two triangles, on
/// either side of its diagonal from (i, j) to (i + 1, j + 1), whose corners are gone round as those of (i, j),
/// (i + 1, j), (i + 1, j + 1) and (i, j + 1) are.
struct AskedGrid {
  std::string name;                   ///< the mesh's
  std::size_t columns = 0, rows = 0;  ///< the numbers of i and of j, 2 at least
  double x = 0, y = 0;                ///< of the first point
  double dx = 0, dy = 0;              ///< the ways from a point to the next, above 0
  std::vector<double> heights{};      ///< columns·rows of them
};

/// The grid that the scene's only mesh is, exactly; nothing where it is none, or where the scene has more.
std::optional<AskedGrid> grid_of(const scene::Scene& scene);

/// The mesh of a grid.
scene::Mesh mesh_of(const AskedGrid& grid);

}  // namespace durero::conform
