#include "durero/model/on_ray.hpp"

#include <algorithm>

namespace durero::model {
namespace {

bool is_inside(const Interval& interval, const Surd& t) {
  return (interval.has_first ? interval.first <= t : interval.first < t) && (!interval.last || t <= *interval.last);
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
  if (interval) return interval->first < bound;
  return !points.empty() && points.front() < bound;
}

std::optional<Interval> not_negative(const RationalQuadratic& q) {
  if (q.a.is_zero() && q.b.is_zero()) return q.c >= 0 ? std::optional(all_positive()) : std::nullopt;
  const std::vector<Surd> ends = roots(q);
  if (ends.empty()) return std::nullopt;
  // q is at least 0 from its first root to its last; where it is linear, on the side to which it rises.
  const bool from_first = !q.a.is_zero() || q.b.sign() > 0, to_last = !q.a.is_zero() || q.b.sign() < 0;
  if (to_last && ends.back() <= 0) return std::nullopt;
  Interval result = all_positive();
  if (from_first && ends.front() > 0) result = {ends.front(), true, std::nullopt};
  if (to_last) result.last = ends.back();
  return result;
}

std::optional<Interval> intersection(const Interval& a, const Interval& b) {
  Interval both = a.first < b.first || (a.first == b.first && a.has_first) ? b : a;
  const auto& other_last = a.last && (!b.last || *a.last < *b.last) ? a.last : b.last;
  both.last = other_last;
  if (both.last && (both.has_first ? *both.last < both.first : *both.last <= both.first)) return std::nullopt;
  return both;
}

Parameters zeros(const RationalQuadratic& q, const Interval& interval) {
  if (q.is_zero()) return {{}, interval};
  Parameters found;
  for (const Surd& t : roots(q))
    if (is_inside(interval, t)) found.points.push_back(t);
  return found;
}

}  // namespace durero::model
