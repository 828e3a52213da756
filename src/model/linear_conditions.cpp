#include "linear_conditions.hpp"

#include <algorithm>

namespace durero::model {
namespace {

using number::Rational;
using Conditions = std::vector<LinearCondition>;

/// a·x + b·y, without the first number, which has no part in it any more.
std::vector<Rational> without_first(const Rational& a, const std::vector<Rational>& x, const Rational& b,
                                    const std::vector<Rational>& y) {
  std::vector<Rational> sum;
  for (std::size_t i = 1; i < x.size(); ++i) sum.push_back(a * x[i] + b * y[i]);
  return sum;
}

int first_sign(const LinearCondition& condition) { return number::sign(condition.sum.front()); }

Conditions where_first_has(int sign, const Conditions& conditions) {
  Conditions found;
  std::ranges::copy_if(conditions, std::back_inserter(found),
                       [&](const LinearCondition& each) { return first_sign(each) == sign; });
  return found;
}

/// The conditions on the other numbers, where an equation says the first by these.
Conditions substituted(const LinearCondition& equation, const Conditions& conditions) {
  Conditions others;
  for (const LinearCondition& each : conditions)
    others.push_back(
        {without_first(1, each.sum, -each.sum.front() / equation.sum.front(), equation.sum), each.standing});
  return others;
}

/// The conditions on the other numbers, where each lower bound of the first is to be below each upper one.
Conditions bounded(const Conditions& conditions) {
  Conditions others;
  for (const LinearCondition& each : where_first_has(0, conditions))
    others.push_back({without_first(1, each.sum, 0, each.sum), each.standing});
  for (const LinearCondition& lower : where_first_has(1, conditions))
    for (const LinearCondition& upper : where_first_has(-1, conditions))
      others.push_back({without_first(-upper.sum.front(), lower.sum, lower.sum.front(), upper.sum),
                        std::max(lower.standing, upper.standing)});
  return others;
}

Conditions without_first(const Conditions& conditions) {
  const auto equation = std::ranges::find_if(
      conditions, [](const LinearCondition& each) { return each.standing == Standing::zero && first_sign(each) != 0; });
  return equation == conditions.end() ? bounded(conditions) : substituted(*equation, conditions);
}

/// Of a condition that is a constant alone.
bool holds(const LinearCondition& condition) {
  const int sign = first_sign(condition);
  switch (condition.standing) {
    case Standing::zero:
      return sign == 0;
    case Standing::at_least_zero:
      return sign >= 0;
    case Standing::above_zero:
      return sign > 0;
  }
  return false;
}

}  // namespace

bool have_solution(Conditions conditions) {
  if (conditions.empty()) return true;
  for (std::size_t numbers = conditions.front().sum.size() - 1; numbers > 0; --numbers)
    conditions = without_first(conditions);
  return std::ranges::all_of(conditions, holds);
}

}  // namespace durero::model
