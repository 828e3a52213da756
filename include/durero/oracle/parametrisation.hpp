#pragma once
/// A surface as parametrised points, which is all that the sampled oracle knows of an element: a curve, its profile,
/// turned around an axis. A sphere is a half circle turned around, a cylinder and a cone a segment, and so is a disc
/// around its centre, and what is seen of a plane: a patch of it. A triangle is a fan of segments from a vertex to the
/// points of the opposite edge. There is no equation here: what a point, a direction or a distance in the surface is
/// follows from the two parameters.
///
/// Numbers are binary64, and a stored axis may miss unit length by 2⁻⁵⁰: both move a point by less than
/// 2⁻⁴⁵·(|centro| + size), which rounding() is.

#include <glm/vec3.hpp>
#include <type_traits>
#include <variant>

#include "durero/scene/shape_view.hpp"

namespace durero::oracle {

/// A point of a surface and what the surface is like around it.
struct SurfacePoint {
  glm::dvec3 point;   ///< rounded
  glm::dvec3 normal;  ///< of length 1, across the lines of both parameters
  double edge;        ///< a lower bound of the distance in the surface to its nearest rim or apex; ∞ without any
  double curvature;   ///< an upper bound of the curvature at every point of the surface within edge/2 of this one
};

/// The points of one element, by two parameters. It refers to nothing.
class Parametrisation {
 public:
  /// The radius of what is seen of a plane by whoever names none.
  static constexpr double default_patch = 64;

  /// patch: the radius of what is seen of a plane.
  explicit Parametrisation(scene::ShapeView shape, double patch = default_patch);
  /// Of a shape of the closed set.
  template <class Shape>
    requires std::is_same_v<decltype(Shape::tipo), const model::Tipo>
  Parametrisation(const Shape& shape) : Parametrisation(scene::ShapeView(shape)) {}

  /// At least the length of each line of equal v: that of the profile, or of the longest segment of a fan.
  double length() const noexcept { return length_; }
  /// The largest radius of a circle of the surface; half the length of a fan.
  double widest() const noexcept { return widest_; }
  /// The centre of a sphere, a patch or a disc, that of the base of what has an axis, the vertex of a fan.
  const glm::dvec3& center() const noexcept { return center_; }
  /// At least the sum of the magnitudes of what leads from there to a point.
  double size() const noexcept { return size_; }
  /// How far a point may be off.
  double rounding() const noexcept;
  /// Whether the surface goes on beyond its rim, as a plane does.
  bool is_patch() const noexcept { return is_patch_; }

  // 0 ≤ u ≤ 1 runs along the profile, in proportion to its length; 0 ≤ v ≤ 1 once around the axis, or over the fan.
  /// The point of these parameters.
  glm::dvec3 point(double u, double v) const;
  /// The same, and what the surface is like around it.
  SurfacePoint at(double u, double v) const;
  /// The length of the line of equal u: a circle, or a segment parallel to the edge opposite to a fan's vertex.
  double around(double u) const;
  /// At least the length of each line of equal u that this one is no farther from than `way`, along the lines of equal
  /// v.
  double around_within(double u, double way) const;
  /// The middle of the line of equal u.
  glm::dvec3 middle(double u) const;
  /// At least the distance of its points from a point between the middles of lines of equal u.
  double reach(double u, const glm::dvec3& from) const;

 private:
  struct Arc {
    double radius;
  };
  struct Segment {
    double first_radius, last_radius, height;  // from (first_radius, 0) to (last_radius, height)
  };
  struct Fan {
    glm::dvec3 first, last;  // from the vertex, to the ends of the opposite edge, which is the shortest
    double width() const;
  };
  struct Circle {
    double radius, height;  // on the axis
  };
  struct Profile;
  struct ProfileOf;
  explicit Parametrisation(const Profile& profile);
  void measure(const Arc& arc);
  void measure(const Segment& segment);
  void measure(const Fan& fan);
  void set_frame(const glm::dvec3& axis);
  static Circle circle(const Arc& arc, double u);
  static Circle circle(const Segment& segment, double u);
  glm::dvec3 outwards(double v) const;
  glm::dvec3 on(const Circle& circle, const glm::dvec3& outwards) const;
  glm::dvec3 on(const Fan& fan, double u, double v) const;
  SurfacePoint at(const Arc& arc, double u, double v) const;
  SurfacePoint at(const Segment& segment, double u, double v) const;
  SurfacePoint at(const Fan& fan, double u, double v) const;

  glm::dvec3 center_, axis_, across_, sideways_;  // the last three of length 1, at right angles
  std::variant<Arc, Segment, Fan> profile_;
  bool is_patch_;
  double length_, widest_, size_;
};

}  // namespace durero::oracle
