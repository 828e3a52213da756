#pragma once
/// The points of a ray on one element, exactly: coefficients, roots, and what the clip and t > 0 leave of them.
/// Every number is a Dyadic or a root of a quadratic over them; every decision is the sign of one. No tolerance.

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "durero/model/tipos.hpp"
#include "durero/number/dyadic_surd.hpp"
#include "durero/scene/shape_view.hpp"
#include "durero/surface/equation.hpp"

namespace durero::surface::exact {

using number::Dyadic;

/// A parameter t of a ray: the number (x + y√delta)/w.
using Parameter = number::DyadicSurd;

/// potencia at p + t·v, less that at the origin where the ray starts on the element: A·t² + 2B·t + C.
/// avance at p + t·v: s0 + t·s1, which must lie in 0 … altura where the element has a stretch of an axis.
/// bounds: what must not be negative besides, each A·t² + 2B·t + C with A ≤ 0. Along a line in the plane of a disc it
/// is the negative power of its ball, of a triangle its three lados; along any other line, numbers that have the signs
/// of these where the line crosses the plane.
struct Coefficients {
  Dyadic A, B, C;                           ///< of potencia
  Dyadic s0{}, s1{};                        ///< of avance
  std::optional<Dyadic> altura{};           ///< nothing where it has no stretch of an axis
  std::vector<Quadratic<Dyadic>> bounds{};  ///< none where it has none
};

/// on: the origin lies on the element (alcance: puntos_desde), so C is 0.
Coefficients coefficients(scene::ShapeView shape, const model::Rayo& rayo, bool on = false);

/// The real t with A·t² + 2B·t + C = 0, ascending and without repetition; `every` when A = B = C = 0.
struct Roots {
  bool every = false;            ///< every t is one
  std::uint8_t count = 0;        ///< 0, 1 or 2
  std::array<Parameter, 2> t{};  ///< the first `count` of them

  /// The roots themselves. Precondition: not `every`.
  std::span<const Parameter> values() const { return std::span(t).first(count); }
};
/// The roots of potencia.
Roots roots(const Coefficients& f);

/// Order of two parameters, of whatever elements.
inline std::strong_ordering order(const Parameter& a, const Parameter& b) { return number::compare(a, b); }

/// 0 ≤ avance ≤ altura, and no bound negative, at the parameter. Precondition: it is a root.
bool within_clip(const Coefficients& f, const Parameter& t);

/// A stretch of the ray inside a surface, closed: from begin, or from t → 0⁺ where that is absent and no nearest point
/// exists; to end, or without end.
struct Segment {
  std::optional<Parameter> begin, end;  ///< absent as above
};

/// alcance, as parameters t > 0: up to two points, ascending, or one segment.
struct Reach {
  std::uint8_t count = 0;            ///< 0, 1 or 2
  std::array<Parameter, 2> t{};      ///< the first `count` of them
  std::optional<Segment> segment{};  ///< then there are no points

  /// The points, without a segment.
  std::span<const Parameter> points() const { return std::span(t).first(count); }
  /// Whether nothing is met.
  bool empty() const { return count == 0 && !segment; }
  /// Whether points are met as near to the origin as one likes.
  bool no_minimum() const { return segment && !segment->begin; }
  /// The nearest point. Precondition: not empty, and not no_minimum.
  const Parameter& first() const { return segment ? *segment->begin : t[0]; }
};
/// What is met, of potencia, avance and bounds.
Reach reach(const Coefficients& f);
/// Of an element; `on` as above.
Reach reach(scene::ShapeView shape, const model::Rayo& rayo, bool on = false);

}  // namespace durero::surface::exact
