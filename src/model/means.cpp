#include "means.hpp"

#include <algorithm>
#include <array>

#include "linear_conditions.hpp"

namespace durero::model {
namespace {

using number::Rational;
using Weighted = std::vector<Rational>;  // multiples of weights of corners, the constant last
using WeightedPoint = std::array<Weighted, 3>;

/// x + factor · y
Weighted plus(Weighted x, const Rational& factor, const Weighted& y) {
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += factor * y[i];
  return x;
}

std::array<Rational, 3> coordinates(const Punto& p) { return {Rational(p.x()), Rational(p.y()), Rational(p.z())}; }

/// A constant alone, among so many multiples.
Weighted constant(std::size_t length, const Rational& value) {
  Weighted sum(length, 0);
  sum.back() = value;
  return sum;
}

/// The mean of some corners, whose weights stand from `first` on; the weights are held to be weights.
WeightedPoint mean_of(const std::vector<Punto>& corners, std::size_t first, std::size_t length,
                      std::vector<LinearCondition>& conditions) {
  WeightedPoint mean{constant(length, 0), constant(length, 0), constant(length, 0)};
  Weighted all = constant(length, -1);
  for (const Punto& corner : corners) {
    Weighted weight = constant(length, 0);
    weight[first] = all[first] = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) mean[axis][first] = coordinates(corner)[axis];
    conditions.push_back({weight, Standing::at_least_zero});
    ++first;
  }
  conditions.push_back({all, Standing::zero});
  return mean;
}

void require_same(const WeightedPoint& x, const WeightedPoint& y, std::vector<LinearCondition>& conditions) {
  for (std::size_t axis = 0; axis < 3; ++axis) conditions.push_back({plus(x[axis], -1, y[axis]), Standing::zero});
}

void add_both(std::vector<Weighted>& sums, const Weighted& sum) {
  sums.push_back(sum);
  sums.push_back(plus(constant(sum.size(), 0), -1, sum));
}

/// w − p
WeightedPoint step_from(const Punto& p, WeightedPoint w) {
  for (std::size_t axis = 0; axis < 3; ++axis) w[axis].back() -= coordinates(p)[axis];
  return w;
}

/// Sums of which one is positive where w does not lie between two points, and is neither.
std::vector<Weighted> beside(const Punto& p, const Punto& q, const WeightedPoint& w) {
  std::vector<Weighted> sums;
  const WeightedPoint from_p = step_from(p, w), from_q = step_from(q, w);
  if (p == q) {
    for (const Weighted& each : from_p) add_both(sums, each);
    return sums;
  }
  const std::array<Rational, 3> a = coordinates(p), b = coordinates(q);
  Weighted before = constant(w[0].size(), 0), behind = before;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t next = (axis + 1) % 3;
    const Rational step = b[axis] - a[axis], other = b[next] - a[next];
    before = plus(before, -step, from_p[axis]);
    behind = plus(behind, step, from_q[axis]);
    add_both(sums, plus(plus(constant(before.size(), 0), step, from_p[next]), -other, from_p[axis]));
  }
  sums.push_back(before);
  sums.push_back(behind);
  return sums;
}

/// Sums of which one is positive where w is no point of the corners, of which there are two at most.
std::vector<Weighted> outside(const std::vector<Punto>& corners, const WeightedPoint& w) {
  if (corners.empty()) return {constant(w[0].size(), 1)};
  return beside(corners.front(), corners.back(), w);
}

}  // namespace

bool is_mean(const std::vector<Punto>& corners, const Punto& w) {
  std::vector<LinearCondition> conditions;
  const WeightedPoint mean = mean_of(corners, 0, corners.size() + 1, conditions);
  for (const Weighted& each : step_from(w, mean)) conditions.push_back({each, Standing::zero});
  return have_solution(std::move(conditions));
}

bool meets_mean(const Punto& from, const std::array<int, 3>& direction, const std::vector<Punto>& corners) {
  std::vector<LinearCondition> conditions;
  const std::size_t length = corners.size() + 2;  // the parameter of the ray stands first
  WeightedPoint difference = step_from(from, mean_of(corners, 1, length, conditions));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    difference[axis].front() = -direction[axis];
    conditions.push_back({difference[axis], Standing::zero});
  }
  Weighted parameter = constant(length, 0);
  parameter.front() = 1;
  conditions.push_back({parameter, Standing::above_zero});
  return have_solution(std::move(conditions));
}

bool have_mean_outside(const std::vector<Punto>& a, const std::vector<Punto>& b, const std::vector<Punto>& common) {
  std::vector<LinearCondition> conditions;
  const std::size_t length = a.size() + b.size() + 1;
  const WeightedPoint w = mean_of(a, 0, length, conditions);
  require_same(w, mean_of(b, a.size(), length, conditions), conditions);
  return std::ranges::any_of(outside(common, w), [&](const Weighted& sum) {
    std::vector<LinearCondition> all = conditions;
    all.push_back({sum, Standing::above_zero});
    return have_solution(std::move(all));
  });
}

}  // namespace durero::model
