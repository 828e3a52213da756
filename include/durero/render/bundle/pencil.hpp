#pragma once
/// A pencil is an axial ray and the paraxial matrix of the rays beside it (Shinya, Takahashi and Naito; Pincel of
/// spec/haces.tex). The matrix is right to the first order: a ray that is off by δ at the start arrives within O(δ²) of
/// the point and the direction that the matrix says.

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace durero::render {

/// The deviation of a ray from an axis (Desvio): x and y, how far it is off along the two directions across the axis,
/// and then u and v, how much its direction leans to them.
using Deviation = glm::dvec4;

/// A pencil on its way.
class Pencil {
 public:
  /// The pencil at its start, with the matrix one. Precondition: `direction` is a unit vector.
  Pencil(const glm::dvec3& origin, const glm::dvec3& direction);

  /// @{ The axis here, and the two directions across it.
  const glm::dvec3& point() const noexcept { return point_; }
  const glm::dvec3& direction() const noexcept { return direction_; }
  const glm::dvec3& first() const noexcept { return first_; }
  const glm::dvec3& second() const noexcept { return second_; }
  /// @}
  /// The matrix from the start to here: it takes a deviation there to one here.
  const glm::dmat4& matrix() const noexcept { return matrix_; }

  /// Goes on to a point of the axis (traslado.def.1).
  void transfer(const glm::dvec3& to);

  // At a surface: its unit normal n on the side of the axis, and its curvature for that normal. Precondition: the axis
  // does not graze it.

  /// Is mirrored.
  void reflect(const glm::dvec3& n, const glm::dmat3& curvature);
  /// Is refracted; `ratio` is the index before the surface over that beyond. Returns false, and changes nothing, in
  /// total reflection.
  bool refract(const glm::dvec3& n, const glm::dmat3& curvature, double ratio);

  /// The start of the ray that deviates so at the start of the pencil, seen here: beside the point, across the axis.
  glm::dvec3 offset(const Deviation& at_start) const;
  /// The deviating ray's direction here, which is a unit vector to the first order.
  glm::dvec3 leaning(const Deviation& at_start) const;
  /// The step from the point to where the deviating ray meets the plane across n through it.
  glm::dvec3 on_plane(const Deviation& at_start, const glm::dvec3& n) const;

 private:
  /// Takes a new direction at the surface: turned(lean, step) is the change of the new direction where the old one
  /// changes by `lean` and the meeting by `step`.
  template <class Turned>
  void turn(const glm::dvec3& n, const glm::dvec3& direction, Turned&& turned);

  glm::dvec3 point_, direction_, first_, second_;
  glm::dmat4 matrix_{1};
};

/// A bound on how far any ray of a cell ends from where the matrix says, to the second order: the tolerance region of a
/// pencil is where it is at most the tolerance. The cell holds the deviations s·first + t·second with |s|, |t| ≤ ½. The
/// three are the differences found for (½, 0), (0, ½) and (½, ½). They are quadratic forms a·s² + b·st + c·t², so no
/// difference is above (|a| + |b| + |c|)/4.
double second_order(const glm::dvec3& at_first, const glm::dvec3& at_second, const glm::dvec3& at_both);

}  // namespace durero::render
