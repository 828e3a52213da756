#pragma once
/// A mesh under construction: points that faces share, on a grid so coarse that rays through them are exact, and the
/// points of the mesh that rays are drawn to.

#include <cstdint>
#include <vector>

#include "conform/families/drawn_ray.hpp"
#include "durero/model/cara.hpp"

namespace durero::conform {

struct DrawnMesh {
  std::vector<glm::dvec3> points{};
  std::vector<model::Cara> faces{};
  glm::dvec3 middle{};  ///< a point around which the mesh lies; of a closed mesh a point inside, from which all is seen
  double unit = 1;      ///< the power of two in which the mesh was drawn: vectors of rays are multiples of it

  /// Adds a point, and answers its number.
  model::Ordinal add(const glm::dvec3& point) {
    points.push_back(point);
    return static_cast<model::Ordinal>(points.size() - 1);
  }
  /// Adds the faces of a quadrilateral, whose points are gone round, on either side of one of its diagonals.
  void add_quad(model::Ordinal a, model::Ordinal b, model::Ordinal c, model::Ordinal d, bool is_other_diagonal);
  /// Adds a triangle with points of its own.
  void add_apart(const scene::Corners& vertices);
};

/// The vertices of a face.
scene::Corners corners(const DrawnMesh& mesh, std::size_t face);

/// The mesh with all lengths times 2^k.
DrawnMesh scaled(DrawnMesh mesh, int k);

/// The coordinate on the grid of 2^−k that is nearest.
glm::dvec3 snapped(const glm::dvec3& point, int k);

/// A vertex, a point at eighths of an edge, or one inside a face.
glm::dvec3 any_target(Draws& random, const DrawnMesh& mesh);
/// A vector in units of the mesh: along an axis, with zeros of either sign; in a coordinate plane; of the lattice; or
/// any.
glm::dvec3 any_way(Draws& random, const DrawnMesh& mesh);
/// A vector along an axis, with zeros of either sign.
glm::dvec3 axis_way(Draws& random, const DrawnMesh& mesh);

/// A ray to a target along the vector, from about 2^e units before it; one in three is nudged.
DrawnRay towards(Draws& random, const DrawnMesh& mesh, const glm::dvec3& target, const glm::dvec3& way, int e);

}  // namespace durero::conform
