#pragma once
/// Whether numbers exist that satisfy linear conditions, by elimination of one number after the other. Exact, and slow:
/// the conditions may be squared in number for each number that is eliminated.

#include <vector>

#include "durero/number/rational.hpp"

namespace durero::model {

/// How a sum stands to zero.
enum class Standing { zero, at_least_zero, above_zero };

/// A sum of multiples of the numbers that are looked for, the constant last, and how it is to stand to zero.
struct LinearCondition {
  std::vector<number::Rational> sum;
  Standing standing;
};

/// Whether some numbers satisfy all conditions. Precondition: the sums are of one length, which is not 0.
bool have_solution(std::vector<LinearCondition> conditions);

}  // namespace durero::model
