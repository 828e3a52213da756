#pragma once
/// A point whose coordinates are named exactly: "a coordinate of an intersection is x + y√Δ over the rationals".

#include <compare>
#include <utility>

#include "durero/model/tipos.hpp"
#include "durero/number/surd.hpp"

namespace durero::model {

using number::Rational;
using number::Surd;

/// The three coordinates lie in one field; what mixes fields throws std::domain_error, from the arithmetic of Surd.
struct ExactPoint {
  Surd x, y, z;  ///< the coordinates

  /// Of its coordinates. Precondition: they lie in one field.
  ExactPoint(Surd x0, Surd y0, Surd z0) : x(std::move(x0)), y(std::move(y0)), z(std::move(z0)) {}
  /// The rational point that a stored one denotes.
  ExactPoint(const Punto& p) : x(p.x()), y(p.y()), z(p.z()) {}

  /// Whether the coordinates are the same numbers.
  bool operator==(const ExactPoint& other) const { return x == other.x && y == other.y && z == other.z; }
};

/// A vector with rational components.
struct ExactVector {
  Rational x, y, z;  ///< the components

  /// Of its components.
  ExactVector(Rational x0, Rational y0, Rational z0) : x(std::move(x0)), y(std::move(y0)), z(std::move(z0)) {}
  /// The rational vector that a stored one denotes.
  ExactVector(const Vector& v) : x(number::exact(v.x())), y(number::exact(v.y())), z(number::exact(v.z())) {}
};

/// p + t·v. Precondition: t lies in the field of p.
inline ExactPoint along(const ExactPoint& p, const ExactVector& v, const Surd& t) {
  return {p.x + t * Surd(v.x), p.y + t * Surd(v.y), p.z + t * Surd(v.z)};
}

}  // namespace durero::model
