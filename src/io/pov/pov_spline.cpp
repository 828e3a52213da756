#include "pov_spline.hpp"

#include <algorithm>

namespace durero::io {
namespace {

/// One component of a spline: its values at numbers that ascend.
struct SplineComponent {
  std::vector<double> at, value;

  std::size_t last() const { return at.size() - 1; }
  double step(std::size_t i) const { return at[i + 1] - at[i]; }
  /// The slope from the value at i to the next.
  double slope(std::size_t i) const { return (value[i + 1] - value[i]) / step(i); }
  /// The place i whose stretch to i + 1 has x. Precondition: x lies between the first and the last number.
  std::size_t stretch(double x) const {
    const auto above = static_cast<std::size_t>(std::ranges::upper_bound(at, x) - at.begin());
    return std::clamp<std::size_t>(above, 1, last()) - 1;
  }
};

double linear(const SplineComponent& c, double x) {
  const std::size_t i = c.stretch(x);
  return c.value[i] + (x - c.at[i]) * c.slope(i);
}

/// The parabola through the ends of the stretch and the value before it; on the first stretch the one behind it.
double quadratic(const SplineComponent& c, double x) {
  const std::size_t i = std::max<std::size_t>(c.stretch(x), 1);
  double sum = 0;
  for (std::size_t k = i - 1; k <= i + 1; ++k) {
    double weight = 1;
    for (std::size_t other = i - 1; other <= i + 1; ++other)
      if (other != k) weight *= (x - c.at[other]) / (c.at[k] - c.at[other]);
    sum += weight * c.value[k];
  }
  return sum;
}

/// The cubic whose slope at each end of the stretch is the mean of the slopes on both sides.
double cubic(const SplineComponent& c, double x) {
  const std::size_t i = c.stretch(x);
  const double h = c.step(i), u = (x - c.at[i]) / h;
  const double begin = h * (c.slope(i - 1) + c.slope(i)) / 2, end = h * (c.slope(i) + c.slope(i + 1)) / 2;
  return c.value[i] * (2 * u * u * u - 3 * u * u + 1) + c.value[i + 1] * (3 * u * u - 2 * u * u * u) +
         begin * (u * u * u - 2 * u * u + u) + end * (u * u * u - u * u);
}

/// The second derivatives of the natural spline, 0 at both ends: a system of three diagonals, eliminated downwards.
std::vector<double> second_derivatives(const SplineComponent& c) {
  std::vector<double> second(c.at.size(), 0), upper(c.at.size(), 0);
  for (std::size_t i = 1; i < c.last(); ++i) {
    const double pivot = 2 * (c.step(i - 1) + c.step(i)) - c.step(i - 1) * upper[i - 1];
    upper[i] = c.step(i) / pivot;
    second[i] = (6 * (c.slope(i) - c.slope(i - 1)) - c.step(i - 1) * second[i - 1]) / pivot;
  }
  for (std::size_t i = c.last(); i-- > 1;) second[i] -= upper[i] * second[i + 1];
  return second;
}

double natural(const SplineComponent& c, double x) {
  const std::vector<double> second = second_derivatives(c);
  const std::size_t i = c.stretch(x);
  const double h = c.step(i), behind = c.at[i + 1] - x, ahead = x - c.at[i];
  return (second[i] * behind * behind * behind + second[i + 1] * ahead * ahead * ahead) / (6 * h) +
         (c.value[i] / h - second[i] * h / 6) * behind + (c.value[i + 1] / h - second[i + 1] * h / 6) * ahead;
}

double value_of(const SplineComponent& c, double x, PovSplineKind by) {
  const bool is_cubic = by == PovSplineKind::cubic;
  if (is_cubic && c.last() == 1) return (c.value[0] + c.value[1]) / 2;
  const std::size_t inset = is_cubic && c.last() > 0 ? 1 : 0;
  if (x <= c.at[inset]) return c.value[inset];
  if (x >= c.at[c.last() - inset]) return c.value[c.last() - inset];
  if (is_cubic) return cubic(c, x);
  if (by == PovSplineKind::linear || c.last() == 1) return linear(c, x);
  return by == PovSplineKind::quadratic ? quadratic(c, x) : natural(c, x);
}

}  // namespace

std::optional<PovSplineKind> pov_spline_kind(std::string_view word) {
  if (word == "linear_spline") return PovSplineKind::linear;
  if (word == "quadratic_spline") return PovSplineKind::quadratic;
  if (word == "cubic_spline") return PovSplineKind::cubic;
  if (word == "natural_spline") return PovSplineKind::natural;
  return std::nullopt;
}

void PovSpline::put(double at, const PovNumbers& value) {
  const auto place = std::ranges::lower_bound(points_, at, {}, &Point::at);
  if (place != points_.end() && place->at == at)
    place->value = value;
  else
    points_.insert(place, {at, value});
  width_ = std::max(width_, value.count);
}

double PovSpline::component(double at, PovSplineKind by, std::size_t i) const {
  SplineComponent curve;
  for (const Point& point : points_) {
    curve.at.push_back(point.at);
    curve.value.push_back(point.value.widened(width_).of[i]);
  }
  return value_of(curve, at, by);
}

PovNumbers PovSpline::value(double at, PovSplineKind by) const {
  PovNumbers value;
  value.count = width_;
  for (std::size_t i = 0; i < width_; ++i) value.of[i] = component(at, by, i);
  return value;
}

}  // namespace durero::io
