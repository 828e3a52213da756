#include "conform/families/drawn_mesh.hpp"

#include <cmath>

namespace durero::conform {

void DrawnMesh::add_quad(model::Ordinal a, model::Ordinal b, model::Ordinal c, model::Ordinal d,
                         bool is_other_diagonal) {
  if (is_other_diagonal) {
    faces.push_back({b, c, d});
    faces.push_back({b, d, a});
  } else {
    faces.push_back({a, b, c});
    faces.push_back({a, c, d});
  }
}

void DrawnMesh::add_apart(const scene::Corners& vertices) {
  const model::Ordinal a = add(vertices[0]), b = add(vertices[1]), c = add(vertices[2]);
  faces.push_back({a, b, c});
}

scene::Corners corners(const DrawnMesh& mesh, std::size_t face) {
  const auto [i, j, k] = mesh.faces[face];
  return {mesh.points[i], mesh.points[j], mesh.points[k]};
}

DrawnMesh scaled(DrawnMesh mesh, int k) {
  for (glm::dvec3& point : mesh.points) point = times_power(point, k);
  mesh.middle = times_power(mesh.middle, k);
  mesh.unit = std::ldexp(mesh.unit, k);
  return mesh;
}

glm::dvec3 snapped(const glm::dvec3& point, int k) {
  const auto nearest = [&](double x) { return std::ldexp(std::nearbyint(std::ldexp(x, k)), -k); };
  return {nearest(point.x), nearest(point.y), nearest(point.z)};
}

glm::dvec3 any_target(Draws& random, const DrawnMesh& mesh) {
  const scene::Corners vertices = corners(mesh, random.below(mesh.faces.size()));
  const auto& [a, b, c] = vertices;
  switch (random.below(4)) {
    case 0:
      return a;
    case 1:
      return a + random.integer(1, 7) / 8.0 * (b - a);
    default: {
      const int i = random.integer(1, 6), j = random.integer(1, 7 - i);
      return a + i / 8.0 * (b - a) + j / 8.0 * (c - a);
    }
  }
}

glm::dvec3 axis_way(Draws& random, const DrawnMesh& mesh) {
  const int axis = random.integer(0, 2);
  glm::dvec3 way;
  for (int i = 0; i < 3; ++i) way[i] = (i == axis ? mesh.unit : 0.0) * random.sign();
  return way;
}

glm::dvec3 any_way(Draws& random, const DrawnMesh& mesh) {
  switch (random.below(8)) {
    case 0:
    case 1:
      return axis_way(random, mesh);
    case 2: {
      glm::dvec3 way = axis_way(random, mesh);
      for (int i = 0; i < 3; ++i) {
        if (way[i] != 0) continue;
        const double sign = random.sign();
        way[i] = mesh.unit * sign * random.integer(1, 4);
        return way;
      }
      return way;
    }
    case 3:
    case 4:
      return mesh.unit * random.direction();
    default:
      return mesh.unit * random.lattice_vector(4);
  }
}

DrawnRay towards(Draws& random, const DrawnMesh& mesh, const glm::dvec3& target, const glm::dvec3& way, int e) {
  return one_in_three_nudged(random, arriving(random, target, way, steps(way, mesh.unit, e)));
}

}  // namespace durero::conform
