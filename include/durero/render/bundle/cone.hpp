#pragma once
/// A cone is the set of rays that make no greater angle with an axis than a given one (Amanatides; Kirk;
/// cono_de_rayos.def.1). Shares of a cone are those of its solid angle.

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace durero::render {

/// A cone with a frame: the direction of (x, y) is axis + x·first + y·second, and the cone is where x² + y² ≤ tangent².
struct RayCone {
  /// Precondition: `towards` is a unit vector, and 0 ≤ half_angle < π/2.
  RayCone(const glm::dvec3& from, const glm::dvec3& towards, double half_angle);

  /// The direction of (x, y), of any length.
  glm::dvec3 direction(const glm::dvec2& at) const { return axis + at.x * first + at.y * second; }

  glm::dvec3 apex, axis, first, second;  ///< the frame: three unit vectors at right angles, from the apex
  double half, tangent;                  ///< the half-angle, and its tangent
  double start = 0;  ///< what is nearer to the apex than this is not seen: the cone goes on from a surface
};

/// The solid angle of a cone of that half-angle, up to π.
double solid_angle(double half);

/// The half-angle of the cone of that solid angle, up to 4π.
double half_angle(double solid);

/// The share of a cone that another cone of the same apex covers, the overlap of two circles on the unit sphere: their
/// half-angles, and the angle between their axes. Preconditions: 0 < half < π/2, 0 ≤ other ≤ π/2, 0 ≤ between ≤ π.
double cone_overlap(double half, double other, double between);

/// The share of a cone that a triangle covers whose corners lie there from the apex. Precondition: 0 < half.
double triangle_share(const RayCone& cone, const std::array<glm::dvec3, 3>& corners);

}  // namespace durero::render
