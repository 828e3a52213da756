#include "pov_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace durero::io {

using number::Rational;

PovCurveKind take_curve_kind(PovWords& in) {
  constexpr std::pair<std::string_view, PovCurveKind> words[] = {{"linear_spline", PovCurveKind::linear},
                                                                 {"quadratic_spline", PovCurveKind::quadratic},
                                                                 {"cubic_spline", PovCurveKind::cubic},
                                                                 {"bezier_spline", PovCurveKind::bezier}};
  for (const auto& [word, kind] : words)
    if (in.take(word)) return kind;
  return PovCurveKind::linear;
}

std::size_t least_points(PovCurveKind kind) {
  switch (kind) {
    case PovCurveKind::linear:
      return 2;
    case PovCurveKind::quadratic:
      return 3;
    case PovCurveKind::cubic:
    case PovCurveKind::bezier:
      return 4;
  }
  __builtin_unreachable();  // a kind is one of its enumerators
}

namespace {

/// Twice each coefficient of the parameter's powers, from 0 on, by the points: POV-Ray's own splines.
using Weights = std::array<std::array<int, 4>, 4>;
constexpr Weights linear_weights{{{2, 0, 0, 0}, {-2, 2, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}}},
    quadratic_weights{{{0, 2, 0, 0}, {-1, 0, 1, 0}, {1, -2, 1, 0}, {0, 0, 0, 0}}},
    cubic_weights{{{0, 2, 0, 0}, {-1, 0, 1, 0}, {2, -5, 4, -1}, {-1, 3, -3, 1}}},
    bezier_weights{{{2, 0, 0, 0}, {-6, 6, 0, 0}, {6, -12, 6, 0}, {-2, 6, -6, 2}}};

const Weights& weights_of(PovCurveKind kind) {
  switch (kind) {
    case PovCurveKind::linear:
      return linear_weights;
    case PovCurveKind::quadratic:
      return quadratic_weights;
    case PovCurveKind::cubic:
      return cubic_weights;
    case PovCurveKind::bezier:
      return bezier_weights;
  }
  __builtin_unreachable();  // a kind is one of its enumerators
}

PovStretch stretch_of(const Weights& weights, const glm::dvec2* points, std::size_t count) {
  PovStretch stretch;
  for (std::size_t i = 0; i < 4; ++i)
    for (int axis = 0; axis < 2; ++axis) {
      Rational sum = 0;
      for (std::size_t k = 0; k < count; ++k) sum += weights.at(i).at(k) * number::exact(points[k][axis]);
      sum /= 2;
      const double near = number::round_to_binary64(sum);
      stretch.is_rounded = stretch.is_rounded || number::exact(near) != sum;
      stretch.coefficients.at(i)[axis] = near;
    }
  return stretch;
}

}  // namespace

std::vector<PovStretch> stretches_of(PovCurveKind kind, const std::vector<glm::dvec2>& points) {
  const std::size_t width = least_points(kind), step = kind == PovCurveKind::bezier ? 4 : 1;
  std::vector<PovStretch> all;
  for (std::size_t i = 0; i + width <= points.size(); i += step)
    all.push_back(stretch_of(weights_of(kind), &points[i], width));
  return all;
}

bool PovStretch::is_straight() const {
  const auto cross = [&](std::size_t i, std::size_t k) {
    const glm::dvec2 &a = coefficients.at(i), &b = coefficients.at(k);
    return number::exact(a.x) * number::exact(b.y) - number::exact(a.y) * number::exact(b.x);
  };
  return cross(1, 2) == 0 && cross(1, 3) == 0 && cross(2, 3) == 0;
}

// The four weights of the derivative by the Bernstein polynomials of degree two are a, a + b and a + 2·b + 3·c for the
// coefficients a, b and c of t, t² and t³: where none differs in sign, the derivative does not change it.
std::optional<std::array<glm::dvec2, 2>> PovStretch::line() const {
  std::array<glm::dvec2, 2> ends{coefficients[0], coefficients[0]};
  for (int axis = 0; axis < 2; ++axis) {
    const Rational start = number::exact(coefficients[0][axis]), a = number::exact(coefficients[1][axis]),
                   b = number::exact(coefficients[2][axis]), c = number::exact(coefficients[3][axis]);
    const Rational slopes[] = {a, a + b, a + 2 * b + 3 * c};
    const auto is_above = [](const Rational& x) { return x > 0; };
    const auto is_below = [](const Rational& x) { return x < 0; };
    if (std::ranges::any_of(slopes, is_above) && std::ranges::any_of(slopes, is_below)) return std::nullopt;
    ends[1][axis] = number::round_to_binary64(start + a + b + c);
  }
  return ends;
}

ValuesByWord PovStretch::attributes() const {
  ValuesByWord values;
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    values[fmt::format("r_{}", i)] = coefficients.at(i).x;
    values[fmt::format("h_{}", i)] = coefficients.at(i).y;
  }
  return values;
}

}  // namespace durero::io
