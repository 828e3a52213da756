#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <span>

#include "conform/families/recipes_mesh.hpp"

namespace durero::conform::recipes {
namespace {

/// The grid of the points of solids: rays through them, from far and in eighths, are exact in binary32.
constexpr int solid_grid = 14;

/// A polyhedron of integer vertices around 0, with triangles as faces.
struct BaseSolid {
  std::span<const std::array<int, 3>> vertices;
  std::span<const std::array<std::size_t, 3>> faces;
  double reach;  ///< a power of two, its largest coordinate or a little more
};

constexpr std::array<std::array<int, 3>, 6> octahedron_vertices{
    {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};
constexpr std::array<std::array<std::size_t, 3>, 8> octahedron_faces{
    {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};

constexpr std::array<std::array<int, 3>, 8> cube_vertices{
    {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};
constexpr std::array<std::array<std::size_t, 3>, 12> cube_faces{{{0, 2, 1},
                                                                 {0, 3, 2},
                                                                 {4, 5, 6},
                                                                 {4, 6, 7},
                                                                 {0, 1, 5},
                                                                 {0, 5, 4},
                                                                 {2, 3, 7},
                                                                 {2, 7, 6},
                                                                 {0, 4, 7},
                                                                 {0, 7, 3},
                                                                 {1, 2, 6},
                                                                 {1, 6, 5}}};

// The ratio of the coordinates is the golden one but for 10⁻³.
constexpr std::array<std::array<int, 3>, 12> icosahedron_vertices{{{-13, 21, 0},
                                                                   {13, 21, 0},
                                                                   {-13, -21, 0},
                                                                   {13, -21, 0},
                                                                   {0, -13, 21},
                                                                   {0, 13, 21},
                                                                   {0, -13, -21},
                                                                   {0, 13, -21},
                                                                   {21, 0, -13},
                                                                   {21, 0, 13},
                                                                   {-21, 0, -13},
                                                                   {-21, 0, 13}}};
constexpr std::array<std::array<std::size_t, 3>, 20> icosahedron_faces{
    {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
     {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
     {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};

const std::array<BaseSolid, 3> base_solids{{{octahedron_vertices, octahedron_faces, 1},
                                            {cube_vertices, cube_faces, 1},
                                            {icosahedron_vertices, icosahedron_faces, 32}}};

/// The points of a subdivided solid, by their integer places, which neighbouring faces share.
class Subdivision {
 public:
  /// Divides each edge of the solid into n.
  Subdivision(const BaseSolid& solid, int n) {
    for (const auto& face : solid.faces) divide(solid, face, n);
  }

  std::vector<glm::dvec3> places{};  ///< of the points, n times as large as the solid
  std::vector<model::Cara> faces{};

 private:
  void divide(const BaseSolid& solid, const std::array<std::size_t, 3>& face, int n) {
    const auto number = [&](int j, int k) {
      std::array<int, 3> place{};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto along = [&](std::size_t vertex) { return solid.vertices[face[vertex]][axis]; };
        place[axis] = (n - j - k) * along(0) + j * along(1) + k * along(2);
      }
      const auto [known, is_new] = numbers_.try_emplace(place, static_cast<model::Ordinal>(places.size()));
      if (is_new) places.emplace_back(place[0], place[1], place[2]);
      return known->second;
    };
    for (int j = 0; j < n; ++j) {
      for (int k = 0; j + k < n; ++k) {
        const model::Ordinal b = number(j + 1, k), c = number(j, k + 1);
        faces.push_back({number(j, k), b, c});
        if (j + k + 1 < n) faces.push_back({b, number(j + 1, k + 1), c});
      }
    }
  }

  std::map<std::array<int, 3>, model::Ordinal> numbers_{};
};

/// A subdivided solid of about so many faces: as it is, made round, or round with each point moved along its radius,
/// which leaves all of the mesh to be seen from the middle.
DrawnMesh subdivided_solid(Draws& random, std::size_t faces) {
  const BaseSolid& solid = random.any_of(base_solids);
  const auto each = static_cast<double>(faces) / static_cast<double>(solid.faces.size());
  const int n = std::max(1, static_cast<int>(std::sqrt(each)));
  const Subdivision divided(solid, n);
  const std::uint64_t kind = random.below(3);
  DrawnMesh mesh{.faces = divided.faces};
  for (const glm::dvec3& place : divided.places) {
    const double rough = kind == 2 ? random.uniform(0.875, 1) : 1;
    const double length = kind == 0 ? solid.reach * n : std::sqrt(glm::dot(place, place));
    mesh.points.push_back(snapped(rough / length * place, solid_grid));
  }
  return mesh;
}

/// A ray along an axis to a vertex, from abreast of the middle: it lies in the planes where boxes end. The axis is that
/// of the vertex's largest coordinate, so that the ray starts inside or in a side.
DrawnRay along_axis_to_vertex(Draws& random, const DrawnMesh& mesh) {
  const glm::dvec3 vertex = random.any_of(mesh.points), way = glm::abs(vertex - mesh.middle);
  const int axis = way.x >= way.y && way.x >= way.z ? 0 : way.y >= way.z ? 1 : 2;
  DrawnRay ray{vertex, axis_way(random, mesh)};
  for (int i = 0; i < 3; ++i) ray.v[i] = std::copysign(0.0, ray.v[i]);
  ray.p[axis] = mesh.middle[axis];
  ray.v[axis] = std::copysign(mesh.unit, vertex[axis] - ray.p[axis]);
  return ray;
}

/// A point on the way from the middle to the mesh, on a grid.
glm::dvec3 point_inside(Draws& random, const DrawnMesh& mesh) {
  const glm::dvec3 target = any_target(random, mesh), way = target - mesh.middle;
  const double part = random.integer(0, 3) / 4.0;
  return mesh.middle + part * way;
}

}  // namespace

DrawnMesh mesh_solid(Draws& random, int, std::size_t faces) { return subdivided_solid(random, faces); }

/// A ray from outside to a target, or past the mesh.
DrawnRay mesh_solid(Draws& random, int log2_distance, const DrawnMesh& mesh) {
  const glm::dvec3 way = any_way(random, mesh);
  if (!random.chance(1, 8)) return towards(random, mesh, any_target(random, mesh), way, log2_distance);
  const glm::dvec3 beside = snapped(2.0 * random.in_cube(1), solid_grid);
  return towards(random, mesh, beside, way, log2_distance);
}

DrawnMesh mesh_inside(Draws& random, int log2_scale, std::size_t faces) {
  return scaled(subdivided_solid(random, faces), log2_scale);
}

/// A ray from inside to a target, or in any direction.
DrawnRay mesh_inside(Draws& random, int, const DrawnMesh& mesh) {
  if (random.chance(1, 6)) return along_axis_to_vertex(random, mesh);
  const glm::dvec3 p = random.rounded(point_inside(random, mesh));
  const glm::dvec3 way = random.chance(1, 4) ? any_way(random, mesh) : any_target(random, mesh) - p;
  return one_in_three_nudged(random, {p, std::ldexp(1, random.integer(-3, 3)) * way});
}

DrawnMesh mesh_surface(Draws& random, int, std::size_t faces) { return subdivided_solid(random, faces); }

/// A ray from a point of the mesh, or from beside it: to another, along an edge, or in any direction.
DrawnRay mesh_surface(Draws& random, int minus_log2_step, const DrawnMesh& mesh) {
  const scene::Corners vertices = corners(mesh, random.below(mesh.faces.size()));
  const glm::dvec3 target = random.chance(1, 3) ? vertices[0] : any_target(random, mesh);
  glm::dvec3 p = target;
  if (random.chance(1, 2)) p += std::ldexp(mesh.unit, -minus_log2_step) * random.lattice_vector(1);
  glm::dvec3 way = any_way(random, mesh);
  const std::uint64_t kind = random.below(6);
  if (kind == 0) way = vertices[1] - vertices[0];
  if (kind == 1 || kind == 2) way = any_target(random, mesh) - p;
  if (way == glm::dvec3(0)) way = glm::dvec3(mesh.unit, 0, 0);
  return one_in_three_nudged(random, {p, std::ldexp(1, random.integer(-3, 3)) * way});
}

/// A round bar as CAD programs mesh it: a fan of needles at each end, and a strip of long needles around. Its circle is
/// of rational points, (1 − s²)/(1 + s²) and 2s/(1 + s²).
DrawnMesh needles(Draws& random, int log2_ratio, std::size_t faces) {
  constexpr int needle_grid = 20;
  const int half = std::max(3, static_cast<int>(faces / 8)), sides = 2 * half;
  const double width = 4.0 / half, height = std::ldexp(1, std::ilogb(width) + log2_ratio);
  const int axis = random.integer(0, 2);
  const auto placed = [&](double x, double y, double z) {
    glm::dvec3 point(0);
    point[axis] = z, point[(axis + 1) % 3] = x, point[(axis + 2) % 3] = y;
    return snapped(point, needle_grid);
  };
  DrawnMesh mesh{.middle = placed(0, 0, height / 2)};
  for (const double z : {0.0, height}) {
    for (int i = 0; i < sides; ++i) {
      const double s = 2.0 * (i % half) / half - 1, w = 1 + s * s, turn = i < half ? 1 : -1;
      mesh.add(placed(turn * (1 - s * s) / w, turn * 2 * s / w, z));
    }
  }
  const model::Ordinal low = mesh.add(placed(0, 0, 0)), high = mesh.add(placed(0, 0, height));
  for (int i = 0; i < sides; ++i) {
    const auto a = static_cast<model::Ordinal>(i), b = static_cast<model::Ordinal>((i + 1) % sides);
    const auto up = static_cast<model::Ordinal>(sides);
    mesh.faces.push_back({low, b, a});
    mesh.faces.push_back({high, a + up, b + up});
    mesh.add_quad(a, b, b + up, a + up, random.chance(1, 2));
  }
  return mesh;
}

/// A ray across the bar, along it, from inside or from outside.
DrawnRay needles(Draws& random, int, const DrawnMesh& mesh) {
  const glm::dvec3 target = any_target(random, mesh), way = any_way(random, mesh);
  if (random.chance(1, 2)) return towards(random, mesh, target, way, random.integer(0, 6));
  const glm::dvec3 p = random.rounded(point_inside(random, mesh));
  return one_in_three_nudged(random, {p, target - p});
}

}  // namespace durero::conform::recipes
