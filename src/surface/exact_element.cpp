#include "durero/surface/exact_element.hpp"

#include <algorithm>
#include <utility>

#include "durero/number/ball.hpp"
#include "surface/flat.hpp"

namespace durero::surface::exact {
namespace {

using number::RealBall;
using number::shifted;
using number::sign;
using number::square;

/// A stretch of a line, which bounds narrow.
struct ClippedSegment {
  Segment segment{};
  bool empty = false;

  void from(const Parameter& t) {
    if (number::sign(t) > 0 && (!segment.begin || order(*segment.begin, t) < 0)) segment.begin = t;
  }
  void to(const Parameter& t) {
    if (!segment.end || order(t, *segment.end) < 0) segment.end = t;
  }
  /// Narrows the stretch to the part where the bound is not negative.
  void keep(const Quadratic<Dyadic>& bound) {
    const Roots ends = roots({bound.A, bound.B, bound.C});
    if (ends.count == 0) {
      empty = empty || (!ends.every && sign(bound.C) < 0);
      return;
    }
    const bool concave = sign(bound.A) != 0;
    if (concave || sign(bound.B) > 0) from(ends.values().front());
    if (concave || sign(bound.B) < 0) to(ends.values().back());
  }
  Reach reach() const {
    if (empty || (segment.end && number::sign(*segment.end) <= 0)) return {};
    if (!segment.begin || !segment.end) return {.segment = segment};
    const auto way = order(*segment.begin, *segment.end);
    if (way > 0) return {};
    if (way == 0) return {.count = 1, .t = {*segment.begin}};
    return {.segment = segment};
  }
};

/// The reach of a ray inside the surface: its part within all bounds.
Reach reach_of_line(const Coefficients& f) {
  ClippedSegment left;
  if (f.altura) {
    left.keep({0, shifted(f.s1, -1), f.s0});
    left.keep({0, shifted(-f.s1, -1), *f.altura - f.s0});
  }
  for (const Quadratic<Dyadic>& bound : f.bounds) left.keep(bound);
  return left.reach();
}

template <class Shape>
Coefficients coefficients_of(const Shape& shape, const model::Rayo& rayo) {
  const auto w = along<Dyadic>(rayo);
  auto [A, B, C] = potencia(shape, w);
  if constexpr (Axial<Shape>) {
    const auto s = avance(shape, w);
    return {std::move(A), std::move(B), std::move(C), s.at_zero, s.slope, shape.altura};
  } else {
    return {std::move(A), std::move(B), std::move(C)};
  }
}

/// The bounds of a flat element along a line in its plane. A plane has none.
std::vector<Quadratic<Dyadic>> bounds_in_plane(const scene::Plane&, const model::Rayo&) { return {}; }

std::vector<Quadratic<Dyadic>> bounds_in_plane(const scene::Disc& disc, const model::Rayo& rayo) {
  const auto ball = squared_length(from(disc.centro, along<Dyadic>(rayo)));
  return {{-ball.A, -ball.B, square(Dyadic(disc.radio)) - ball.C}};
}

/// The lados at a + q + t·v. With the products of the edges, the lado of ab is e1²·(w·e2) − (e1·e2)(w·e1), that of ca
/// is e2²·(w·e1) − (e1·e2)(w·e2), and the three add up to e1²·e2² − (e1·e2)² (lado.def.1).
std::vector<Quadratic<Dyadic>> bounds_in_plane(const scene::Triangle& triangle, const model::Rayo& rayo) {
  const auto [e1, e2, q, v] = over_edges<Dyadic>(triangle, rayo);
  const Dyadic e11 = dot(e1, e1), e12 = dot(e1, e2), e22 = dot(e2, e2);
  const Linear<Dyadic> w1{dot(q, e1), dot(v, e1)}, w2{dot(q, e2), dot(v, e2)};
  const auto less = [](const Linear<Dyadic>& a, const Linear<Dyadic>& b) {
    return Linear<Dyadic>{a.at_zero - b.at_zero, a.slope - b.slope};
  };
  const Linear<Dyadic> ab = less(w2 * e11, w1 * e12), ca = less(w1 * e22, w2 * e12);
  const Linear<Dyadic> bc = e11 * e22 - square(e12) - (ab + ca);
  std::vector<Quadratic<Dyadic>> bounds;
  for (const Linear<Dyadic>& lado : {ab, bc, ca}) bounds.push_back({0, shifted(lado.slope, -1), lado.at_zero});
  return bounds;
}

/// The coefficients of a flat element, whose potencia is linear: A = 0.
template <Flat Shape>
Coefficients coefficients_of(const Shape& shape, const model::Rayo& rayo) {
  auto at = crossing<Dyadic>(shape, rayo);
  Coefficients f{0, shifted(at.potencia.slope, -1), std::move(at.potencia.at_zero)};
  if (sign(f.B) == 0) {
    f.bounds = bounds_in_plane(shape, rayo);
  } else {
    for (Dyadic& margin : at.margins) f.bounds.push_back({0, 0, std::move(margin)});
  }
  return f;
}

/// Whether the line certainly crosses the plane at no t > 0, or beside the element, by ball arithmetic. Most rays meet
/// no flat element, and few come so near to one that the balls leave it open.
template <class Shape>
bool certainly_missed(const Shape& shape, const model::Rayo& rayo, bool on) {
  if constexpr (Flat<Shape>) {
    const auto at = crossing<RealBall>(shape, rayo);
    const int slope = at.potencia.slope.decided_sign();
    if (slope == 0) return false;
    return on || at.potencia.at_zero.decided_sign() == slope ||
           std::any_of(at.margins.begin(), at.margins.end(), [](const RealBall& b) { return b.decided_sign() < 0; });
  } else {
    return false;
  }
}

}  // namespace

Coefficients coefficients(scene::ShapeView view, const model::Rayo& rayo, bool on) {
  Coefficients f = view.visit([&](const auto& shape) { return coefficients_of(shape, rayo); });
  if (on) f.C = Dyadic();
  return f;
}

Reach reach(scene::ShapeView view, const model::Rayo& rayo, bool on) {
  const bool missed = view.visit([&](const auto& shape) { return certainly_missed(shape, rayo, on); });
  return missed ? Reach{} : reach(coefficients(view, rayo, on));
}

// The quotients of raices.def.1, as numbers x + y√Δ.
Roots roots(const Coefficients& f) {
  const int of_A = sign(f.A);
  if (of_A == 0) {
    if (sign(f.B) == 0) return {.every = sign(f.C) == 0};
    return {.count = 1, .t = {Parameter{.x = -f.C, .w = shifted(f.B, 1)}}};
  }
  if (sign(f.C) == 0) {
    const Parameter other{.x = shifted(-f.B, 1), .w = f.A};
    const int of_other = number::sign(other);
    if (of_other == 0) return {.count = 1, .t = {other}};
    if (of_other > 0) return {.count = 2, .t = {Parameter{}, other}};
    return {.count = 2, .t = {other, Parameter{}}};
  }
  const Dyadic D = square(f.B) - f.A * f.C;
  const int of_D = sign(D);
  if (of_D < 0) return {};
  if (of_D == 0) return {.count = 1, .t = {Parameter{.x = -f.B, .w = f.A}}};
  return {.count = 2, .t = {Parameter{-f.B, -of_A, D, f.A}, Parameter{-f.B, of_A, D, f.A}}};
}

// recorte.def.1, and the bounds of a disc and a triangle.
bool within_clip(const Coefficients& f, const Parameter& t) {
  if (f.altura &&
      (number::sign(number::linear(f.s0, f.s1, t)) < 0 || number::sign(number::linear(*f.altura - f.s0, -f.s1, t)) < 0))
    return false;
  // At a root the line crosses the surface, and there the bounds are constants.
  return std::all_of(f.bounds.begin(), f.bounds.end(),
                     [](const Quadratic<Dyadic>& bound) { return sign(bound.C) >= 0; });
}

Reach reach(const Coefficients& f) {
  const Roots found = roots(f);
  if (found.every) return reach_of_line(f);
  Reach result;
  for (const Parameter& t : found.values()) {
    if (number::sign(t) > 0 && within_clip(f, t)) result.t[result.count++] = t;
  }
  return result;
}

bool lies_on(RayStretch stretch, const Parameter& t) {
  return stretch == RayStretch::whole || order(t, Parameter{.x = 1}) < 0;
}

std::optional<std::vector<Parameter>> parameters_on(const Reach& found, RayStretch stretch) {
  if (found.segment && (found.no_minimum() || lies_on(stretch, *found.segment->begin))) return std::nullopt;
  std::vector<Parameter> on;
  for (const Parameter& t : found.points())
    if (lies_on(stretch, t)) on.push_back(t);
  return on;
}

}  // namespace durero::surface::exact
