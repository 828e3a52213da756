#include "durero/surface/exact_element.hpp"

#include <utility>

#include "durero/surface/surfaces.hpp"

namespace durero::surface::exact {
namespace {

using number::shifted;
using number::sign;
using number::square;

/// Where avance is the given height. Precondition: s1 ≠ 0.
Parameter at_height(const Coefficients& f, const Dyadic& height) { return {.x = height - f.s0, .w = f.s1}; }

/// A ray inside the surface: the part of it between the two clip planes.
Reach reach_of_line(const Coefficients& f) {
  if (!f.altura) return {.segment = Segment{}};
  if (sign(f.s1) == 0) {
    const bool inside = sign(f.s0) >= 0 && f.s0 <= *f.altura;
    return inside ? Reach{.segment = Segment{}} : Reach{};
  }
  Parameter begin = at_height(f, 0);
  Parameter end = at_height(f, *f.altura);
  if (sign(f.s1) < 0) std::swap(begin, end);
  if (number::sign(end) <= 0) return {};
  if (number::sign(begin) <= 0) return {.segment = Segment{std::nullopt, std::move(end)}};
  return {.segment = Segment{std::move(begin), std::move(end)}};
}

/// A potencia along a ray, as a quadratic: that of a plane is linear, and its A is 0.
Quadratic<Dyadic> quadratic(Quadratic<Dyadic> power) { return power; }
Quadratic<Dyadic> quadratic(const Linear<Dyadic>& power) { return {0, shifted(power.slope, -1), power.at_zero}; }

template <class Shape>
Coefficients coefficients_of(const Shape& shape, const model::Rayo& rayo) {
  const auto w = along<Dyadic>(rayo);
  auto [A, B, C] = quadratic(potencia(shape, w));
  if constexpr (Axial<Shape>) {
    const auto s = avance(shape, w);
    return {std::move(A), std::move(B), std::move(C), s.at_zero, s.slope, shape.altura};
  } else {
    return {std::move(A), std::move(B), std::move(C), 0, 0, std::nullopt};
  }
}

}  // namespace

Coefficients coefficients(scene::ShapeView view, const model::Rayo& rayo, bool on) {
  Coefficients f = view.visit([&](const auto& shape) { return coefficients_of(shape, rayo); });
  if (on) f.C = Dyadic();
  return f;
}

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

bool within_clip(const Coefficients& f, const Parameter& t) {
  if (!f.altura) return true;
  return number::sign(number::linear(f.s0, f.s1, t)) >= 0 &&
         number::sign(number::linear(*f.altura - f.s0, -f.s1, t)) >= 0;
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

}  // namespace durero::surface::exact
