#include <algorithm>
#include <cmath>

#include "conform/families/recipes_mesh.hpp"

namespace durero::conform::recipes {
namespace {

/// The number of cells along a side of a square grid of about so many faces, two a cell.
int cells_of(std::size_t faces) { return std::max(2, static_cast<int>(std::sqrt(static_cast<double>(faces) / 2))); }

/// A square grid of points, each given by its place.
template <class Point>
DrawnMesh grid_mesh(Draws& random, int cells, Point point) {
  DrawnMesh mesh;
  for (int i = 0; i <= cells; ++i) {
    for (int j = 0; j <= cells; ++j) mesh.add(point(i, j));
  }
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      const auto at = [&](int di, int dj) { return static_cast<model::Ordinal>((i + di) * (cells + 1) + j + dj); };
      mesh.add_quad(at(0, 0), at(1, 0), at(1, 1), at(0, 1), !random.asks_grids() && random.chance(1, 2));
    }
  }
  return mesh;
}

/// Puts each of the faces that the condition holds for on points of its own, each next to the shared one.
void split_seams(Draws& random, DrawnMesh& mesh, std::uint64_t of) {
  for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
    if (!random.chance(1, of)) continue;
    for (model::Ordinal* corner : {&mesh.faces[face].i, &mesh.faces[face].j, &mesh.faces[face].k}) {
      glm::dvec3 point = mesh.points[*corner];
      const int axis = random.integer(0, 2);
      point[axis] = random.next(point[axis], random.sign());
      *corner = mesh.add(point);
    }
  }
}

void repeat_some(Draws& random, DrawnMesh& mesh, std::uint64_t of) {
  for (std::size_t face = 0, count = mesh.faces.size(); face < count; ++face) {
    const auto [i, j, k] = mesh.faces[face];
    if (random.chance(1, of)) mesh.faces.push_back({i, k, j});
  }
}

}  // namespace

/// A height field over the integer lattice; a third of its points lie at the height 0, where whole cells are flat.
DrawnMesh terrain(Draws& random, int log2_height, std::size_t faces) {
  const int cells = cells_of(faces), half = cells / 2;
  return grid_mesh(random, cells, [&](int i, int j) {
    const double height = random.chance(1, 3) ? 0 : std::ldexp(random.integer(-64, 64), log2_height - 6);
    return glm::dvec3(i - half, j - half, height);
  });
}

/// A ray down or up, along the lines of the grid or its diagonals, level or not, or any.
DrawnRay terrain(Draws& random, int log2_height, const DrawnMesh& mesh) {
  const glm::dvec3 target = any_target(random, mesh);
  glm::dvec3 way = any_way(random, mesh);
  const std::uint64_t kind = random.below(4);
  if (kind == 0) {
    const double x = 0.0 * random.sign(), y = 0.0 * random.sign();
    way = {x, y, random.sign()};
  } else if (kind == 1) {
    const int x = random.integer(-1, 1), y = random.integer(-1, 1);
    const double fall = random.chance(1, 2) ? 0.0 * random.sign() : std::ldexp(random.sign(), log2_height - 4);
    way = x == 0 && y == 0 ? glm::dvec3(1, 0, fall) : glm::dvec3(x, y, fall);
  }
  return towards(random, mesh, target, way, random.integer(0, 5));
}

/// A range image with noise: holes, faces twice, and seams of points that are not shared.
DrawnMesh scan(Draws& random, int minus_log2_noise, std::size_t faces) {
  constexpr int scan_grid = 16;
  const int cells = cells_of(faces), half = cells / 2;
  const double pitch = std::ldexp(1, -std::ilogb(cells));
  DrawnMesh mesh = grid_mesh(random, cells, [&](int i, int j) {
    const double noise = std::ldexp(1, -minus_log2_noise);
    const glm::dvec3 off = noise * pitch * random.in_cube(1);
    const double x = pitch * (i - half), y = pitch * (j - half);
    return snapped(glm::dvec3(x, y, 0.25 * (x * x - y * y) + 0.5 * x * y) + off, scan_grid + minus_log2_noise / 2);
  });
  std::erase_if(mesh.faces, [&](const model::Cara&) { return random.chance(1, 50); });
  repeat_some(random, mesh, 50);
  split_seams(random, mesh, 25);
  return mesh;
}

/// A ray from the scanner to a point of the mesh, or to a target.
DrawnRay scan(Draws& random, int, const DrawnMesh& mesh) {
  const glm::dvec3 target = any_target(random, mesh), way = any_way(random, mesh);
  if (random.chance(1, 3)) return towards(random, mesh, target, way, random.integer(0, 6));
  const glm::dvec3 scanner(0, 0, 4);
  const glm::dvec3 point = random.chance(1, 2) ? random.any_of(mesh.points) : target;
  return one_in_three_nudged(random, {scanner, point - scanner});
}

/// A box whose six sides are divided apart, so that points of one lie on edges of the next; with sheets in its planes,
/// and faces twice.
DrawnMesh seams(Draws& random, int log2_pieces, std::size_t faces) {
  const int most = std::max(1, std::ilogb(std::max(2.0, std::sqrt(static_cast<double>(faces) / 12))));
  DrawnMesh mesh;
  for (int side = 0; side < 6; ++side) {
    const int axis = side % 3, pieces = 1 << (side == 0 ? most : random.integer(std::max(0, most - log2_pieces), most));
    const double level = side < 3 ? 1 : -1;
    const auto first = static_cast<model::Ordinal>(mesh.points.size());
    DrawnMesh sheet = grid_mesh(random, pieces, [&](int i, int j) {
      glm::dvec3 point(level);
      point[(axis + 1) % 3] = 2.0 * i / pieces - 1;
      point[(axis + 2) % 3] = 2.0 * j / pieces - 1;
      return point;
    });
    for (const glm::dvec3& point : sheet.points) mesh.add(point);
    for (const auto& [i, j, k] : sheet.faces) mesh.faces.push_back({first + i, first + j, first + k});
    if (!random.chance(1, 3)) continue;
    glm::dvec3 a(level), b(level), c(level);
    a[(axis + 1) % 3] = -0.75, b[(axis + 1) % 3] = 0.5, b[(axis + 2) % 3] = -0.5, c[(axis + 2) % 3] = 0.75;
    mesh.add_apart({a, b, c});
  }
  repeat_some(random, mesh, 16);
  return mesh;
}

/// A ray from inside, to a point of a side or along an edge; or from outside.
DrawnRay seams(Draws& random, int, const DrawnMesh& mesh) {
  const glm::dvec3 target = random.chance(1, 2) ? random.any_of(mesh.points) : any_target(random, mesh);
  const glm::dvec3 way = any_way(random, mesh);
  if (random.chance(1, 2)) return towards(random, mesh, target, way, random.integer(-2, 5));
  const int x = random.integer(-7, 7), y = random.integer(-7, 7), z = random.integer(-7, 7);
  const glm::dvec3 p = glm::dvec3(x, y, z) / 8.0;
  return one_in_three_nudged(random, {p, target - p});
}

}  // namespace durero::conform::recipes
