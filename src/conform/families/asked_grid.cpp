#include "durero/conform/families/asked_grid.hpp"

#include <algorithm>

namespace durero::conform {
namespace {

/// The faces of the cells, by the numbers of their points.
std::vector<model::Cara> faces_of(std::size_t columns, std::size_t rows) {
  std::vector<model::Cara> faces;
  for (std::size_t i = 0; i + 1 < columns; ++i) {
    for (std::size_t j = 0; j + 1 < rows; ++j) {
      const auto at = [&](std::size_t k) { return static_cast<model::Ordinal>(i * rows + j + k); };
      faces.push_back({at(0), at(rows), at(rows + 1)});
      faces.push_back({at(0), at(rows + 1), at(1)});
    }
  }
  return faces;
}

glm::dvec3 point_of(const AskedGrid& grid, std::size_t number) {
  const std::size_t i = number / grid.rows, j = number % grid.rows;
  return {grid.x + static_cast<double>(i) * grid.dx, grid.y + static_cast<double>(j) * grid.dy, grid.heights[number]};
}

/// The grid of so many rows that the first points of the mesh make.
AskedGrid first_grid(const scene::Mesh& mesh, std::size_t rows) {
  AskedGrid grid{.name = std::string(mesh.m.name()), .columns = mesh.puntos.size() / rows, .rows = rows};
  const glm::dvec3 first = mesh.puntos[0];
  grid.x = first.x, grid.y = first.y;
  grid.dx = mesh.puntos[rows].x - first.x, grid.dy = mesh.puntos[1].y - first.y;
  for (std::size_t k = 0; k < mesh.puntos.size(); ++k) grid.heights.push_back(mesh.puntos[k].z);
  return grid;
}

}  // namespace

std::optional<AskedGrid> grid_of(const scene::Scene& scene) {
  if (scene.meshes().size() != 1 || scene.size() != scene.meshes()[0].caras.size()) return std::nullopt;
  const scene::Mesh& mesh = scene.meshes()[0];
  const std::size_t count = mesh.puntos.size();
  std::size_t rows = 0;
  while (rows < count && mesh.puntos[rows].x == mesh.puntos[0].x) ++rows;
  if (rows < 2 || count % rows != 0 || count / rows < 2) return std::nullopt;
  AskedGrid grid = first_grid(mesh, rows);
  bool is = grid.dx > 0 && grid.dy > 0 && mesh.caras == faces_of(grid.columns, rows);
  for (std::size_t k = 0; is && k < count; ++k) is = mesh.puntos[k] == point_of(grid, k);
  return is ? std::optional(std::move(grid)) : std::nullopt;
}

scene::Mesh mesh_of(const AskedGrid& grid) {
  scene::Mesh mesh{.m = model::Elemento(grid.name), .caras = faces_of(grid.columns, grid.rows)};
  for (std::size_t k = 0; k < grid.heights.size(); ++k) mesh.puntos.push_back(point_of(grid, k));
  return mesh;
}

}  // namespace durero::conform
