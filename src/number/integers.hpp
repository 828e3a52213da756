#pragma once
/// Between the two libraries' integers, limb by limb.
#include "durero/number/dyadic.hpp"

namespace durero::number {

Integer to_integer(const Dyadic::Significand& value);
Dyadic::Significand to_significand(const Integer& value);

}  // namespace durero::number
