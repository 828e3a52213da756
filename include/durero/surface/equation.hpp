#pragma once
/// The number types of the surfaces' equations. Each surface is defined once, in surface/shape/, over any number type:
/// by potencia, which is 0 on it, and avance, the place along the axis of a shape that has one (spec/puntos.tex). Over
/// Linear, the numbers along a ray, potencia gives the coefficients of the ray's quadratic; over Dual, numbers with a
/// gradient, the normal; over double, a value.
///
/// Five opinions stay independent of this header, which show a fault in it: durero::model, the evaluated Z text, the
/// sampled oracle, which knows a surface as points and never as an equation, the tests' own reference, and the
/// extracted Coq.

#include <glm/vec3.hpp>

#include "durero/model/tipos.hpp"
#include "durero/scene/shapes.hpp"

namespace durero::surface {

/// A number along a ray, at_zero + t·slope.
template <class N>
struct Linear {
  N at_zero, slope;  ///< the coefficients

  /// @{ Arithmetic, coefficient by coefficient.
  friend Linear operator+(const Linear& a, const Linear& b) { return {a.at_zero + b.at_zero, a.slope + b.slope}; }
  friend Linear operator-(const Linear& a, const N& b) { return {a.at_zero - b, a.slope}; }
  friend Linear operator-(const N& a, const Linear& b) { return {a - b.at_zero, -b.slope}; }
  friend Linear operator*(const Linear& a, const N& b) { return {a.at_zero * b, a.slope * b}; }
  /// @}
};

/// A quadratic along a ray, A·t² + 2B·t + C: a sum of squares of numbers along it.
template <class N>
struct Quadratic {
  N A, B, C;  ///< the coefficients; B is half that of t

  /// @{ Arithmetic, coefficient by coefficient.
  friend Quadratic operator+(const Quadratic& a, const Quadratic& b) { return {a.A + b.A, a.B + b.B, a.C + b.C}; }
  friend Quadratic operator-(const Quadratic& a, const Quadratic& b) { return {a.A - b.A, a.B - b.B, a.C - b.C}; }
  friend Quadratic operator-(const Quadratic& a, const N& b) { return {a.A, a.B, a.C - b}; }
  friend Quadratic operator*(const Quadratic& a, const N& b) { return {a.A * b, a.B * b, a.C * b}; }
  /// @}
};

/// @{ The square.
template <class N>
N square(const N& a) {
  return a * a;
}
template <class N>
Quadratic<N> square(const Linear<N>& a) {
  return {square(a.slope), a.at_zero * a.slope, square(a.at_zero)};
}
/// @}

/// A function near a point, by its value and its gradient there.
template <class N>
struct Dual {
  N value, dx, dy, dz;  ///< the value, and the gradient

  /// @{ Arithmetic, coefficient by coefficient.
  friend Dual operator+(const Dual& a, const Dual& b) {
    return {a.value + b.value, a.dx + b.dx, a.dy + b.dy, a.dz + b.dz};
  }
  friend Dual operator-(const Dual& a, const Dual& b) {
    return {a.value - b.value, a.dx - b.dx, a.dy - b.dy, a.dz - b.dz};
  }
  friend Dual operator-(const Dual& a, const N& b) { return {a.value - b, a.dx, a.dy, a.dz}; }
  friend Dual operator-(const N& a, const Dual& b) { return {a - b.value, -b.dx, -b.dy, -b.dz}; }
  friend Dual operator*(const Dual& a, const N& b) { return {a.value * b, a.dx * b, a.dy * b, a.dz * b}; }
  /// @}
};

/// The square, with its gradient.
template <class N>
Dual<N> square(const Dual<N>& a) {
  const N twice = a.value + a.value;
  return {a.value * a.value, twice * a.dx, twice * a.dy, twice * a.dz};
}

/// The number type of constants in a computation with T, to which stored numbers are converted.
template <class T>
struct ConstantOf {
  using type = T;  ///< a number's constants are of its own type
};
/// Constants along a ray.
template <class N>
struct ConstantOf<Linear<N>> {
  using type = N;  ///< a number that does not change along it
};
/// Constants beside functions of a point.
template <class N>
struct ConstantOf<Dual<N>> {
  using type = N;  ///< a number whose gradient is 0
};
/// The type of the constants.
template <class T>
using Constant = typename ConstantOf<T>::type;

/// A point whose coordinates are numbers T.
template <class T>
struct Point {
  T x, y, z;  ///< the coordinates
};

/// The points of a ray: p + t·v (punto_en.def.1).
template <class N>
Point<Linear<N>> along(const model::Rayo& rayo) {
  const glm::dvec3 &p = rayo.p().xyz(), &v = rayo.v().xyz();
  return {{N(p.x), N(v.x)}, {N(p.y), N(v.y)}, {N(p.z), N(v.z)}};
}

/// q = w − centro (desde.def.1)
template <class T>
Point<T> from(const glm::dvec3& centro, const Point<T>& w) {
  using C = Constant<T>;
  return {w.x - C(centro.x), w.y - C(centro.y), w.z - C(centro.z)};
}

/// |q|²
template <class T>
auto squared_length(const Point<T>& q) {
  return square(q.x) + square(q.y) + square(q.z);
}

/// q·d (producto.def.1)
template <class T>
T dot(const Point<T>& q, const glm::dvec3& d) {
  using C = Constant<T>;
  return q.x * C(d.x) + q.y * C(d.y) + q.z * C(d.z);
}

/// A shape along an axis, which is clipped to 0 ≤ avance ≤ altura.
template <class Shape>
concept Axial = requires(const Shape& shape) { shape.altura; };

/// s = q·d (avance.def.1)
template <class T, Axial Shape>
T avance(const Shape& shape, const Point<T>& w) {
  return dot(from(shape.centro, w), shape.vector);
}

/// |q − s·d|² = |q|² − (2 − d·d)·s², for any d (alejamiento.def.1)
template <class T, Axial Shape>
auto alejamiento(const Shape& shape, const Point<T>& w) {
  using C = Constant<T>;
  const C x(shape.vector.x), y(shape.vector.y), z(shape.vector.z);
  const C less = C(2) - (x * x + y * y + z * z);
  return squared_length(from(shape.centro, w)) - square(avance(shape, w)) * less;
}

}  // namespace durero::surface
