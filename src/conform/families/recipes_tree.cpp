// Triangles whose boxes are hard on a tree.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "conform/families/recipes_mesh.hpp"

namespace durero::conform::recipes {
namespace {

/// Adds the two triangles of each side of a cube, with points that only this cube has.
void add_cube(Draws& random, DrawnMesh& mesh, const glm::dvec3& corner) {
  std::array<model::Ordinal, 8> at{};
  for (unsigned i = 0; i < at.size(); ++i) {
    const double x = i & 1U, y = i >> 1U & 1U, z = i >> 2U;
    at[i] = mesh.add(corner + glm::dvec3(x, y, z));
  }
  constexpr std::array<std::array<std::size_t, 4>, 6> sides{
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  for (const auto& [a, b, c, d] : sides) mesh.add_quad(at[a], at[b], at[c], at[d], random.chance(1, 2));
}

/// Vertices of a triangle in another order: a sign of the normal and a first vertex are drawn.
scene::Corners turned(Draws& random, const scene::Corners& of) {
  const std::size_t first = random.below(3);
  const bool is_back = random.chance(1, 2);
  return {of[first], of[(first + (is_back ? 2 : 1)) % 3], of[(first + (is_back ? 1 : 2)) % 3]};
}

}  // namespace

/// Cubes of the lattice that share sides, edges and corners: every box ends where others do.
DrawnMesh box_faces(Draws& random, int, std::size_t faces) {
  const auto cubes = std::max<std::size_t>(1, faces / 12);
  int side = 1;
  while (static_cast<std::size_t>(side) * side * side < cubes + cubes / 2) ++side;
  DrawnMesh mesh;
  for (std::size_t i = 0; i < cubes; ++i) {
    const int x = random.integer(0, side - 1), y = random.integer(0, side - 1), z = random.integer(0, side - 1);
    add_cube(random, mesh, glm::dvec3(x, y, z) - std::floor(side / 2.0));
  }
  return mesh;
}

/// A ray along an axis or a diagonal, in the sides of the boxes or between them.
DrawnRay box_faces(Draws& random, int log2_distance, const DrawnMesh& mesh) {
  const glm::dvec3 corner = random.any_of(mesh.points);
  const std::uint64_t kind = random.below(4);
  glm::dvec3 target = corner;
  if (kind != 0) {
    // Rays in a plane of boxes, in two of them, or in none.
    for (int i = 0; i < 3; ++i) {
      if (kind == 1 || random.chance(1, 2)) target[i] += random.integer(1, 7) / 8.0;
    }
  }
  glm::dvec3 way = axis_way(random, mesh);
  if (random.chance(1, 4)) {
    for (int i = 0; i < 3; ++i) way[i] += random.sign();
    if (way == glm::dvec3(0)) way = {1, 1, 1};
  } else if (random.chance(1, 6)) {
    way = any_way(random, mesh);
  }
  return towards(random, mesh, target, way, log2_distance);
}

/// Triangles whose sizes run through so many powers of two, each as far from 0 as it is large, in any direction or in a
/// row along x, across it: a tree of them is as deep as there are sizes, and a huge one stands beside a tiny one.
DrawnMesh nested(Draws& random, int log2_ratio, std::size_t faces) {
  const bool is_row = random.chance(1, 2);
  const std::array<glm::dvec3, 3> across{{{8, -3, -2}, {8, 3, -1}, {8, 0, 3}}};
  DrawnMesh mesh;
  for (std::size_t i = 0; i < faces; ++i) {
    const auto step = static_cast<int>(i % static_cast<std::size_t>(log2_ratio + 1));
    const int k = step - log2_ratio / 2;
    scene::Corners vertices{};
    do {
      const glm::dvec3 place = random.lattice_vector(8);
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const glm::dvec3 off = random.lattice_vector(3);
        vertices[corner] = times_power(is_row ? across[corner] + off / 8.0 : place + off, k - 3);
      }
    } while (!are_corners(vertices));
    mesh.add_apart(turned(random, vertices));
  }
  return mesh;
}

/// A ray to a target of any size, from as far as another is large; or from the least outwards along x.
DrawnRay nested(Draws& random, int log2_ratio, const DrawnMesh& mesh) {
  if (random.chance(1, 4)) {
    const double y = random.integer(-4, 4) / 32.0, z = random.integer(-4, 4) / 32.0;
    const double sign = random.sign(), before = std::ldexp(sign, -log2_ratio / 2 - random.integer(2, 8));
    return one_in_three_nudged(random, {{before, 0, 0}, {1, y, z}});
  }
  const glm::dvec3 target = any_target(random, mesh);
  const glm::dvec3 way = any_way(random, mesh);
  const double size = std::max({std::abs(target.x), std::abs(target.y), std::abs(target.z), 0x1p-90});
  const int e = random.chance(1, 2) ? std::ilogb(size) + random.integer(0, 2)
                                    : random.integer(-log2_ratio / 2, log2_ratio / 2 + 2);
  return towards(random, mesh, target, way, e);
}

/// Long and narrow triangles through the middle in all directions: every box is large, and meets most others.
DrawnMesh long_boxes(Draws& random, int minus_log2_width, std::size_t faces) {
  constexpr int long_grid = 10;
  DrawnMesh mesh;
  for (std::size_t i = 0; i < faces; ++i) {
    scene::Corners vertices{};
    do {
      const glm::dvec3 way = random.in_cube(1), middle = 0.25 * random.in_cube(1);
      const glm::dvec3 end = snapped(middle + way, long_grid);
      const glm::dvec3 aside = std::ldexp(1, -minus_log2_width) * random.lattice_vector(3);
      vertices = random.rounded(scene::Corners{snapped(middle - way, long_grid), end, end + aside});
    } while (!are_corners(vertices));
    mesh.add_apart(turned(random, vertices));
  }
  return mesh;
}

DrawnRay long_boxes(Draws& random, int, const DrawnMesh& mesh) {
  const glm::dvec3 target = any_target(random, mesh), way = any_way(random, mesh);
  if (random.chance(3, 4)) return towards(random, mesh, target, way, random.integer(-3, 4));
  const glm::dvec3 p = random.rounded(2.0 * random.in_cube(1));
  return one_in_three_nudged(random, {p, target - p});
}

/// Sheets over one place, so that no split of their boxes parts them: level ones, each at a height of its own, or
/// tilted ones, sixteen of the same middle; one in four twice.
DrawnMesh stack(Draws& random, int minus_log2_spacing, std::size_t faces) {
  const auto sheets = std::max<std::size_t>(2, faces * 4 / 5);
  const int axis = random.integer(0, 2);
  const bool is_tilted = random.chance(1, 3);
  DrawnMesh mesh;
  for (std::size_t i = 0; i < sheets; ++i) {
    const std::size_t place = is_tilted ? i / 16 * 16 : i;
    const double level = std::ldexp(static_cast<double>(place) - static_cast<double>(sheets / 2), -minus_log2_spacing);
    scene::Corners vertices{{{-4, -4, level}, {4, -4, level}, {0, 4, level}}};
    if (is_tilted) {
      const double rise = random.integer(-16, 16) / 8.0;
      vertices[0].z += rise, vertices[1].z -= rise;
    }
    for (glm::dvec3& vertex : vertices) {
      const glm::dvec3 level_up = vertex;
      vertex[axis] = level_up.z, vertex[(axis + 1) % 3] = level_up.x, vertex[(axis + 2) % 3] = level_up.y;
    }
    const scene::Corners way_round = turned(random, vertices);
    mesh.add_apart(way_round);
    if (random.chance(1, 4)) mesh.add_apart(turned(random, way_round));
  }
  return mesh;
}

/// A ray across the sheets, from above, from below or from between.
DrawnRay stack(Draws& random, int, const DrawnMesh& mesh) {
  const glm::dvec3 target = any_target(random, mesh), way = any_way(random, mesh);
  return towards(random, mesh, target, way, random.integer(-8, 8));
}

}  // namespace durero::conform::recipes
