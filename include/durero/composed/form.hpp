#pragma once
/// Polynomials of degree two at most in the coordinates of a point: the powers and bounds of shapes that a map has
/// moved.

#include <array>
#include <cstddef>

#include "durero/model/tipos.hpp"
#include "durero/number/dyadic_surd.hpp"
#include "durero/number/rational.hpp"
#include "durero/surface/equation.hpp"

namespace durero::composed {

using number::Dyadic;
using number::Rational;
using number::RealBall;

/// A polynomial of degree one over the rationals, as a number of surface/equation.hpp: x·w.x + y·w.y + z·w.z + one.
struct LinearForm {
  Rational x, y, z, one;  ///< the coefficients

  /// @{ Arithmetic, coefficient by coefficient.
  friend LinearForm operator+(const LinearForm& a, const LinearForm& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z, a.one + b.one};
  }
  friend LinearForm operator-(const LinearForm& a, const LinearForm& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z, a.one - b.one};
  }
  friend LinearForm operator-(const LinearForm& a, const Rational& b) { return {a.x, a.y, a.z, a.one - b}; }
  friend LinearForm operator-(const Rational& a, const LinearForm& b) { return {-b.x, -b.y, -b.z, a - b.one}; }
  friend LinearForm operator*(const LinearForm& a, const Rational& b) { return {a.x * b, a.y * b, a.z * b, a.one * b}; }
  /// @}
};

/// The places of a symmetric matrix over x, y, z and one.
inline constexpr std::size_t matrix_places = 10;

/// The place of row i and column j.
constexpr std::size_t matrix_place(std::size_t i, std::size_t j) {
  return i <= j ? j * (j + 1) / 2 + i : matrix_place(j, i);
}

/// A polynomial of degree two over the rationals, as (x, y, z, 1)·m·(x, y, z, 1).
struct QuadraticForm {
  std::array<Rational, matrix_places> m;  ///< by matrix_place()

  QuadraticForm() = default;                ///< 0
  QuadraticForm(const LinearForm& linear);  ///< the same polynomial

  /// @{ Arithmetic, coefficient by coefficient.
  friend QuadraticForm operator+(QuadraticForm a, const QuadraticForm& b) {
    for (std::size_t i = 0; i < matrix_places; ++i) a.m[i] += b.m[i];
    return a;
  }
  friend QuadraticForm operator-(QuadraticForm a, const QuadraticForm& b) {
    for (std::size_t i = 0; i < matrix_places; ++i) a.m[i] -= b.m[i];
    return a;
  }
  friend QuadraticForm operator-(QuadraticForm a, const Rational& b) {
    a.m[matrix_place(3, 3)] -= b;
    return a;
  }
  friend QuadraticForm operator*(QuadraticForm a, const Rational& b) {
    for (Rational& coefficient : a.m) coefficient *= b;
    return a;
  }
  /// @}
};

/// The square, for the equations of surface.
QuadraticForm square(const LinearForm& a);

/// A QuadraticForm with coefficients of that type, to be restricted to rays.
template <class N>
class SpaceForm {
 public:
  /// Of these coefficients, by matrix_place().
  explicit SpaceForm(std::array<N, matrix_places> m) : m_(std::move(m)) {}

  /// The coefficients, by matrix_place().
  const std::array<N, matrix_places>& coefficients() const { return m_; }

  /// The polynomial along a ray, A·t² + 2B·t + C.
  surface::Quadratic<N> along(const model::Rayo& rayo) const {
    const glm::dvec3 &o = rayo.p().xyz(), &d = rayo.v().xyz();
    const std::array<N, 3> p{N(o.x), N(o.y), N(o.z)}, v{N(d.x), N(d.y), N(d.z)};
    const auto of_v = [&](std::size_t i) { return v[0] * at(i, 0) + v[1] * at(i, 1) + v[2] * at(i, 2); };
    const auto of_p = [&](std::size_t i) { return p[0] * at(i, 0) + p[1] * at(i, 1) + p[2] * at(i, 2) + at(i, 3); };
    const std::array<N, 4> mv{of_v(0), of_v(1), of_v(2), of_v(3)};
    return {v[0] * mv[0] + v[1] * mv[1] + v[2] * mv[2], p[0] * mv[0] + p[1] * mv[1] + p[2] * mv[2] + mv[3],
            p[0] * of_p(0) + p[1] * of_p(1) + p[2] * of_p(2) + of_p(3)};
  }

 private:
  const N& at(std::size_t i, std::size_t j) const { return m_[matrix_place(i, j)]; }

  std::array<N, matrix_places> m_;
};

/// The form times a positive integer, without fractions: it has the same signs.
SpaceForm<Dyadic> whole(const QuadraticForm& form);
/// The form with coefficients that are known to about 50 bits.
SpaceForm<RealBall> roughly(const SpaceForm<Dyadic>& form);

/// The sign of A·t² + 2B·t + C at a parameter, exactly.
int sign_at(const surface::Quadratic<Dyadic>& f, const number::DyadicSurd& t);

}  // namespace durero::composed

namespace durero::surface {

/// Constants beside functions of a point.
template <>
struct ConstantOf<composed::LinearForm> {
  using type = composed::Rational;  ///< a number that does not change with it
};

}  // namespace durero::surface
