#pragma once
/// How much the data of an element and a ray may be off, exactly, and how far that moves a point against the surface.
///
/// With u = 16ε and δ = u·M + the thickness that the system declares + what the least subnormal costs, each coordinate
/// of the origin, of t·v, of a centre or a vertex, and each length, is off by at most δ; each coordinate of a unit
/// vector by u; a proportion k by u·max(1, k). A point given by coordinates off by δ is off by at most √3·δ. So a point
/// p + t·v is off by 2√3·δ against a fixed surface; a claimed t, or point, is besides that rounded once to the system's
/// format, and its length is divided by |v| with one rounding: ≤ √3·(1/16 + 1/16)·δ, 0.22·δ. Together with the centre
/// 3√3·δ + 0.22·δ < 5.42·δ: below, *the ray's share*.

#include <algorithm>
#include <cmath>

#include "durero/conform/profile.hpp"
#include "durero/number/dyadic.hpp"
#include "durero/scene/attributes.hpp"
#include "durero/scene/query.hpp"
#include "durero/scene/shapes.hpp"

namespace durero::conform {

using number::Dyadic;

/// ε of a format, half the distance from 1 to the next number.
constexpr double unit(Format format) { return format == Format::binary32 ? 0x1p-24 : 0x1p-53; }
/// The least number of a format that is not 0.
constexpr double least(Format format) { return format == Format::binary32 ? 0x1p-149 : 0x1p-1074; }

/// How precise a system claims to be.
struct Precision {
  Format format;
  double thickness = 0;  ///< Profile::thickness
};

inline double largest(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// Whether what this component of the specification holds is a position or a length, and not a unit vector or a ratio.
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

/// The largest magnitude of its positions and lengths.
template <class Shape>
double largest_length(const Shape& shape) {
  double most = 0;
  scene::for_each_attribute<Shape>([&](const auto& attribute) {
    if (is_length(attribute.component)) most = std::max(most, largest(shape.*attribute.field));
  });
  return most;
}

/// k, which is 0 where the shape does not narrow.
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

/// M, where t·v is known to be at most `way` in each coordinate. Of a shape with an axis the radius of its base counts.
template <class Shape>
Dyadic magnitude(const Shape& shape, const model::Rayo& rayo, const Dyadic& way) {
  Dyadic most = std::max(Dyadic(std::max(largest_length(shape), largest(rayo.p().xyz()))), way);
  if constexpr (scene::has_attribute<Shape, &scene::AnyEscena::mi_altura>())
    most = std::max(most, radius_at_centre(shape));
  return most;
}

struct Allowance {
  Dyadic u;      ///< 16ε
  Dyadic delta;  ///< δ

  /// A subnormal result is rounded by half the least number, whatever its size: a coordinate directly, and t by that
  /// times v.
  Allowance(const Precision& precision, const Dyadic& M, const model::Rayo& rayo)
      : u(16 * unit(precision.format)),
        delta(u * M + Dyadic(precision.thickness) +
              Dyadic(16) * Dyadic(least(precision.format)) * Dyadic(std::max(1.0, largest(rayo.v().xyz())))) {}

  Dyadic times(const Dyadic& multiple) const { return multiple * delta; }
};

}  // namespace durero::conform
