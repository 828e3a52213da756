#pragma once
/// Linear conditions on whole numbers are Σ cᵢ·xᵢ + k ≤ 0 with whole coefficients. Elimination decides whether some
/// whole numbers satisfy all of them.
///
/// It is exact, as each condition that it makes follows from those before, for whole numbers:
///   - a·x ≥ l and b·x ≤ u with a, b > 0 give b·l ≤ a·b·x ≤ a·u, so b·l − a·u ≤ 0, in which x does not stand;
///   - Σ cᵢ·xᵢ ≤ m, where g > 0 divides each cᵢ, gives Σ (cᵢ/g)·xᵢ ≤ ⌊m/g⌋, since the sum is a whole number.
/// No such numbers exist if k ≤ 0 is among them for a k > 0. If it is not, numbers are chosen one by one,
/// and each condition is one of the bounds between which a number is chosen: numbers that are found satisfy all.

#include <map>
#include <optional>
#include <vector>

#include "durero/number/rational.hpp"
#include "durero/zed/value/steps.hpp"

namespace durero::zed {

using number::Integer;

/// A linear form Σ cᵢ·xᵢ + k: a variable whose coefficient is 0 does not stand in it.
struct IntegerForm {
  std::map<unsigned, Integer> coefficients;  ///< by the number of the variable
  Integer constant = 0;

  /// Adds `times` the other form.
  void add(const IntegerForm& other, const Integer& times);
};

/// Conditions: each of these forms is at most 0.
using LinearConditions = std::vector<IntegerForm>;

/// The whole numbers of some variables.
using IntegerPoint = std::map<unsigned, Integer>;

/// The answer about linear conditions: that no whole numbers satisfy all, or some that do; or neither.
struct LinearAnswer {
  bool is_impossible = false;
  std::optional<IntegerPoint> point{};  ///< variables that stand in no condition are not in it
};

/// Decides them, and counts its steps. Neither is said where they become too many, or where no numbers are found though
/// nothing contradicts.
LinearAnswer solved(const LinearConditions& conditions, Steps& steps);

/// Returns the conditions on the other variables that hold exactly where some whole numbers for these satisfy all;
/// nothing where that is not known. Of l ≤ a·x and b·x ≤ u it is b·l ≤ a·u where each a is 1, or each b: then a bound
/// of x is a whole number, and x may be that.
std::optional<LinearConditions> projected(const LinearConditions& conditions, const std::vector<unsigned>& variables,
                                          Steps& steps);

}  // namespace durero::zed
