#include "durero/model/on_ray.hpp"

#include <algorithm>

namespace durero::model {
namespace {

bool is_inside(const Interval& interval, const Surd& t) {
  const Surd first(interval.first);
  return (interval.has_first ? first <= t : first < t) && (!interval.last || t <= Surd(*interval.last));
}

}  // namespace

bool Parameters::contains(const Surd& t) const {
  if (interval) return is_inside(*interval, t);
  return std::find(points.begin(), points.end(), t) != points.end();
}

std::optional<Surd> Parameters::minimum() const {
  if (interval) return interval->has_first ? std::optional<Surd>(interval->first) : std::nullopt;
  return points.empty() ? std::nullopt : std::optional<Surd>(points.front());
}

bool Parameters::any_below(const Surd& bound) const {
  // An interval without its first parameter has others as near to it as one likes.
  if (interval) return Surd(interval->first) < bound;
  return !points.empty() && points.front() < bound;
}

std::optional<Interval> stretch(const Rational& at_zero, const Rational& slope, const Rational& h) {
  const Interval all{0, false, std::nullopt};
  if (slope.is_zero()) return at_zero >= 0 && at_zero <= h ? std::optional(all) : std::nullopt;
  const Rational at_base = -at_zero / slope, at_top = (h - at_zero) / slope;
  const Rational &first = std::min(at_base, at_top), &last = std::max(at_base, at_top);
  if (last <= 0) return std::nullopt;
  if (first <= 0) return Interval{0, false, last};
  return Interval{first, true, last};
}

Parameters zeros(const Quadratic& q, const Interval& interval) {
  if (q.is_zero()) return {{}, interval};
  Parameters found;
  for (const Surd& t : roots(q))
    if (is_inside(interval, t)) found.points.push_back(t);
  return found;
}

}  // namespace durero::model
