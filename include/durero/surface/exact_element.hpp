#pragma once
/// The points of a ray on one element, exactly: coefficients, roots, and those that remain within the clip and at t >
/// 0. Every number is a Dyadic or a root of a quadratic over Dyadics, and every decision is the sign of one. There is
/// no tolerance.

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

/// The functions of t whose signs decide. potencia at p + t·v is A·t² + 2B·t + C, less its value at the origin where
/// the ray starts on the element. avance at p + t·v is s0 + t·s1, which must lie in 0 … altura where the element is
/// clipped along an axis. `bounds` must not be negative either, each A·t² + 2B·t + C with A ≤ 0. Along a line in the
/// plane of a disc the bound is the negative power of the disc's ball; of a triangle the bounds are its three lados;
/// along any other line they are numbers with the signs of these where the line crosses the plane.
struct Coefficients {
  Dyadic A, B, C;                           ///< of potencia
  Dyadic s0{}, s1{};                        ///< of avance
  std::optional<Dyadic> altura{};           ///< nothing where the element is not clipped along an axis
  std::vector<Quadratic<Dyadic>> bounds{};  ///< of a disc or triangle
};

/// The coefficients of a ray and a shape. `on`: the origin lies on the element (alcance: puntos_desde), so C is 0.
Coefficients coefficients(scene::ShapeView shape, const model::Rayo& rayo, bool on = false);

/// The real t with A·t² + 2B·t + C = 0, ascending and without repetition; `every` when A = B = C = 0.
struct Roots {
  bool every = false;            ///< whether every t is a root
  std::uint8_t count = 0;        ///< 0, 1 or 2
  std::array<Parameter, 2> t{};  ///< the first `count` of them

  /// The roots themselves. Precondition: not `every`.
  std::span<const Parameter> values() const { return std::span(t).first(count); }
};
/// The roots of potencia.
Roots roots(const Coefficients& f);

/// The order of two parameters, also of different elements.
inline std::strong_ordering order(const Parameter& a, const Parameter& b) { return number::compare(a, b); }

/// Whether 0 ≤ avance ≤ altura and no bound is negative at the parameter. Precondition: it is a root of potencia, and
/// not every t is.
bool within_clip(const Coefficients& f, const Parameter& t);

/// A closed stretch of the ray inside a surface. It starts at `begin`; without one it starts at t → 0⁺, and no nearest
/// point exists. It ends at `end`; without one it has no end.
struct Segment {
  std::optional<Parameter> begin, end;  ///< absent as above
};

/// alcance, as parameters t > 0: up to two points, ascending, or one segment.
struct Reach {
  std::uint8_t count = 0;            ///< 0, 1 or 2
  std::array<Parameter, 2> t{};      ///< the first `count` of them
  std::optional<Segment> segment{};  ///< if there is one, there are no points

  /// The points, without a segment.
  std::span<const Parameter> points() const { return std::span(t).first(count); }
  /// Whether the ray does not meet the element.
  bool empty() const { return count == 0 && !segment; }
  /// Whether the ray meets the element at points as near to its origin as one likes.
  bool no_minimum() const { return segment && !segment->begin; }
  /// The nearest point. Precondition: not empty, and not no_minimum.
  const Parameter& first() const { return segment ? *segment->begin : t[0]; }
};
/// The stretch of a ray that a light is seen along: up to the parameter one, where it stands, or without end.
enum class RayStretch : std::uint8_t { segment, whole };

/// The reach by the signs of potencia, avance and bounds.
Reach reach(const Coefficients& f);
/// The reach of a shape; `on` is that of coefficients.
Reach reach(scene::ShapeView shape, const model::Rayo& rayo, bool on = false);

/// Whether a parameter t > 0 lies on the stretch.
bool lies_on(RayStretch stretch, const Parameter& t);
/// The parameters at which a ray meets what it reaches, on a stretch. Nothing where the ray runs along it there.
std::optional<std::vector<Parameter>> parameters_on(const Reach& found, RayStretch stretch);

}  // namespace durero::surface::exact
