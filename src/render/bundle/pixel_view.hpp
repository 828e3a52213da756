#pragma once
/// A view of the pixel plane: the rays of a picture, exactly, from the eye or from its mirror image.

#include <glm/vec3.hpp>

#include "durero/number/rational.hpp"
#include "durero/polygon/convex.hpp"
#include "durero/scene/camera.hpp"

namespace durero::render {

/// A multiple of a linear function.
inline polygon::PlaneSide scaled(const polygon::Rational& s, const polygon::PlaneSide& f) {
  return {s * f.normal, s * f.offset};
}

/// The rays origin + t·(corner + x·across + y·down): the ray through the point (x, y) of the window, without the
/// rounding that the engine's ray of a pixel has.
struct PixelView {
  explicit PixelView(const scene::PrimaryRays& rays)
      : origin(polygon::exact(rays.eye())),
        corner(polygon::exact(rays.upper_left())),
        across(polygon::exact(rays.step_x())),
        down(polygon::exact(rays.step_y())) {}

  /// n·direction, as a function of x and y.
  polygon::PlaneSide along(const polygon::RationalPoint& n) const {
    return {{polygon::dot(n, across), polygon::dot(n, down), 0}, -polygon::dot(n, corner)};
  }

  /// The view from the mirror image of the origin in the plane through a across n (imagen.def.1). Each of its rays
  /// meets the mirror where the ray of the same point does, and goes on as the mirror sends that one.
  PixelView mirrored(const polygon::RationalPoint& a, const polygon::RationalPoint& n) const {
    const polygon::Rational squared = polygon::dot(n, n);
    const auto image = [&](const polygon::RationalPoint& v) { return v - (2 * polygon::dot(v, n) / squared) * n; };
    PixelView view = *this;
    view.origin = a + image(origin - a);
    view.corner = image(corner);
    view.across = image(across);
    view.down = image(down);
    return view;
  }

  /// The point of the pixel plane whose ray has a direction. Precondition: the direction leads through the window's
  /// plane.
  polygon::RationalPoint point_of(const polygon::RationalPoint& direction) const {
    const polygon::Rational w = polygon::dot(direction, polygon::cross(across, down));
    return {polygon::dot(direction, polygon::cross(down, corner)) / w,
            polygon::dot(direction, polygon::cross(corner, across)) / w, 0};
  }

  polygon::RationalPoint origin, corner, across, down;
};

}  // namespace durero::render
