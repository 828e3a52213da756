#pragma once
/// A surface as parametrised points, which is all that the sampled oracle knows of an element: a curve, its profile,
/// turned around an axis. A sphere is a half circle turned around, a cylinder and a cone a segment, and so is a disc
/// around its centre, which is what is seen of a plane: a patch of it. There is no equation here: what a point, a
/// direction or a distance in the surface is follows from the two parameters.
///
/// Numbers are binary64, and a stored axis may miss unit length by 2⁻⁵⁰: both move a point by less than
/// 2⁻⁴⁵·(|centro| + size), which rounding() is.

#include <glm/vec3.hpp>
#include <type_traits>
#include <variant>

#include "durero/scene/shape_view.hpp"

namespace durero::oracle {

/// A place of the profile: the radius of the circle that it turns around, and that circle's height on the axis.
struct Circle {
  double radius, height;
};

/// A point of a surface and what the surface is like around it.
struct SurfacePoint {
  glm::dvec3 point;
  glm::dvec3 normal;  ///< of length 1, across the lines of both parameters
  double edge;        ///< a lower bound of the distance in the surface to its nearest rim or apex; ∞ without any
  double curvature;   ///< an upper bound of the curvature at every point of the surface within edge/2 of this one
};

class Parametrisation {
 public:
  static constexpr double default_patch = 64;

  /// patch: the radius of what is seen of a plane.
  explicit Parametrisation(scene::ShapeView shape, double patch = default_patch);
  template <class Shape>
    requires std::is_same_v<decltype(Shape::tipo), const model::Tipo>
  Parametrisation(const Shape& shape) : Parametrisation(scene::ShapeView(shape)) {}

  /// The length of the profile, that of each line of equal v.
  double length() const noexcept { return length_; }
  /// The largest radius of a circle of the surface.
  double widest() const noexcept { return widest_; }
  /// At least the sum of the magnitudes of what leads from centro to a point: along the axis and away from it.
  double size() const noexcept { return size_; }
  double rounding() const noexcept;
  /// Whether the surface goes on beyond its rim, as a plane does.
  bool is_patch() const noexcept { return is_patch_; }

  // 0 ≤ u ≤ 1 runs along the profile, in proportion to its length; 0 ≤ v ≤ 1 once around the axis.
  Circle circle(double u) const;
  glm::dvec3 point(double u, double v) const { return on(circle(u), v); }
  SurfacePoint at(double u, double v) const;
  /// The point of the axis at a height.
  glm::dvec3 on_axis(double height) const { return center_ + axis_ * height; }

 private:
  struct Arc {
    double radius;
  };
  struct Segment {
    double first_radius, last_radius, height;  // from (first_radius, 0) to (last_radius, height)
  };
  struct Profile;
  struct ProfileOf;
  explicit Parametrisation(const Profile& profile);
  void measure(const Arc& arc);
  void measure(const Segment& segment);
  void set_frame(const glm::dvec3& axis);
  glm::dvec3 outwards(double v) const;
  glm::dvec3 on(const Circle& circle, double v) const;

  glm::dvec3 center_, axis_, across_, sideways_;  // the last three of length 1, at right angles
  std::variant<Arc, Segment> profile_;
  bool is_patch_;
  double length_, widest_, size_;
};

}  // namespace durero::oracle
