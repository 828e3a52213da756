#pragma once
/// The allowance is the amount by which the data of an element and a ray may be off; this file derives exactly how far
/// such errors move a point against the surface.
///
/// With u = 16ε, or the multiple of ε that the profile claims, and δ = u·M + the thickness that the system declares +
/// the cost of the least subnormal, each coordinate of the origin, of t·v, of a centre or a vertex, and each length, is
/// off by at most δ; each coordinate of a unit vector by u; a proportion k by u·max(1, k). A point given by coordinates
/// off by δ is off by at most √3·δ, and a point p + t·v by 2√3·δ against a fixed surface. A claimed t, or point, is
/// besides rounded once to the system's format, and its length is divided by |v| with one rounding: ≤ √3·(1/16 +
/// 1/16)·δ, 0.22·δ. Together with the centre this gives 3√3·δ + 0.22·δ < 5.42·δ: below, *the ray's share*.

#include <algorithm>
#include <cmath>

#include "durero/conform/ask/profile.hpp"
#include "durero/number/dyadic.hpp"
#include "durero/scene/attributes.hpp"
#include "durero/scene/query.hpp"
#include "durero/scene/shapes.hpp"

namespace durero::conform {

using number::Dyadic;

/// The unit of rounding ε of a format: half the distance from 1 to the next number.
constexpr double unit(NumberFormat format) { return format == NumberFormat::binary32 ? 0x1p-24 : 0x1p-53; }
/// The least positive number of a format, a subnormal.
constexpr double least(NumberFormat format) { return format == NumberFormat::binary32 ? 0x1p-149 : 0x1p-1074; }

/// The precision that a system claims.
struct Precision {
  NumberFormat format;
  double thickness = 0;        ///< Profile::thickness
  double error = usual_error;  ///< Profile::error
};

inline double largest(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

inline Dyadic absolute(const Dyadic& a) { return number::sign(a) < 0 ? -a : a; }

/// Whether the component of the specification holds positions or lengths; a unit vector and a ratio are neither.
template <class Component>
constexpr bool is_length(Component component) {
  if constexpr (std::is_same_v<Component, decltype(&scene::AnyEscena::mi_vector)>)
    return component != &scene::AnyEscena::mi_vector;
  else if constexpr (std::is_same_v<Component, decltype(&scene::AnyEscena::mi_proporcion)>)
    return component != &scene::AnyEscena::mi_proporcion;
  else
    return true;
}

inline double largest(double x) { return std::abs(x); }
inline double largest(const scene::Corners& corners) {
  return std::max({largest(corners[0]), largest(corners[1]), largest(corners[2])});
}

/// The largest magnitude of a shape's positions and lengths.
template <class Shape>
double largest_length(const Shape& shape) {
  double most = 0;
  scene::for_each_attribute<Shape>([&](const auto& attribute) {
    if (is_length(attribute.component)) most = std::max(most, largest(shape.*attribute.field));
  });
  return most;
}

/// The proportion k of a shape, 0 where the shape does not narrow.
template <class Shape>
double proportion(const Shape& shape) {
  if constexpr (scene::has_attribute<Shape, &scene::AnyEscena::mi_proporcion>())
    return shape.proporcion;
  else
    return 0;
}

/// The radius at centro of a shape with an axis: radio + k·altura.
template <class Shape>
Dyadic radius_at_centre(const Shape& shape) {
  Dyadic radius = Dyadic(proportion(shape)) * Dyadic(shape.altura);
  if constexpr (scene::has_attribute<Shape, &scene::AnyEscena::mi_radio>()) radius += Dyadic(shape.radio);
  return radius;
}

/// The magnitude M, the largest among the data of the shape, the origin and t·v, whose coordinates are at most `way`.
/// The radius of the base counts where the shape has an axis.
template <class Shape>
Dyadic magnitude(const Shape& shape, const model::Rayo& rayo, const Dyadic& way) {
  Dyadic most = std::max(Dyadic(std::max(largest_length(shape), largest(rayo.p().xyz()))), way);
  if constexpr (scene::has_attribute<Shape, &scene::AnyEscena::mi_altura>())
    most = std::max(most, radius_at_centre(shape));
  return most;
}

/// The greatest errors that the data of one element and a ray may have.
struct Allowance {
  Dyadic u;      ///< the error of a coordinate of a unit vector
  Dyadic delta;  ///< δ, the error of a position's coordinate and of a length

  /// The last summand pays for subnormals: a subnormal result is rounded by half the least number, whatever its size. A
  /// coordinate is off by that directly, and t·v by that times v.
  Allowance(const Precision& precision, const Dyadic& M, const model::Rayo& rayo)
      : u(Dyadic(precision.error) * Dyadic(unit(precision.format))),
        delta(u * M + Dyadic(precision.thickness) +
              Dyadic(precision.error) * Dyadic(least(precision.format)) *
                  Dyadic(std::max(1.0, largest(rayo.v().xyz())))) {}

  /// The multiple of δ.
  Dyadic times(const Dyadic& multiple) const { return multiple * delta; }
};

}  // namespace durero::conform
