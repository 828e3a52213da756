#pragma once
/// Correctly rounded quotients and truncated square roots of dyadic numbers.
#include "durero/number/dyadic.hpp"

namespace durero::number {

/// n/d rounded once. Precondition: d ≠ 0.
double round_quotient(const Dyadic& n, const Dyadic& d);
/// The same of integers.
double round_quotient(const Integer& n, const Integer& d);

/// value ≤ √of < value + unit; exact means value = √of.
struct SquareRoot {
  Dyadic value, unit;  ///< value ≤ √of < value + unit
  bool exact;          ///< value = √of
};

/// The root to the given number of bits. Precondition: of > 0.
SquareRoot square_root(const Dyadic& of, std::int64_t bits);

}  // namespace durero::number
