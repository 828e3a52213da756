#pragma once
/// The operators of the toolkit on whole numbers that are kept. Each throws NotInterned of a number beyond 64 bits.

#include "interned_values.hpp"

namespace durero::spec {

/// @{ a + b, a − b, a · b and −a.
ValueId number_sum(InternedValues& values, ValueId a, ValueId b);
ValueId number_difference(InternedValues& values, ValueId a, ValueId b);
ValueId number_product(InternedValues& values, ValueId a, ValueId b);
ValueId negative_of(InternedValues& values, ValueId a);
/// @}
/// @{ a div b, rounded down, and a mod b with the sign of b. Throws NotInterned where b is 0 or −1.
ValueId number_quotient(InternedValues& values, ValueId a, ValueId b);
ValueId number_remainder(InternedValues& values, ValueId a, ValueId b);
/// @}
/// a‥b. Throws NotInterned where it has more than 1,000,001 members.
ValueId number_interval(InternedValues& values, ValueId a, ValueId b);
/// The number after one that is not negative. Throws NotInterned of any other.
ValueId successor(InternedValues& values, ValueId a);
/// @{ The least and the greatest number of a set. Throws NotInterned where it is empty.
ValueId least_of(InternedValues& values, ValueId set);
ValueId greatest_of(InternedValues& values, ValueId set);
/// @}

}  // namespace durero::spec
