#pragma once
/// Surds as decimals, for people to read: as many digits as asked, rounded once.
#include <string>

#include "durero/number/surd.hpp"

namespace durero::number {

/// The value in that many decimal digits, correctly rounded (a tie goes up): 1.25, -0.003, 4.5e-31; zeros at the end of
/// the fraction are left out. Precondition: digits ≥ 1.
std::string decimal_text(const Surd& value, int digits);

/// `x + y√Δ` with fractions as they are: 3/2 + 1/2·√5. A rational is itself.
std::string surd_text(const Surd& value);

}  // namespace durero::number
