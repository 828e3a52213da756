#pragma once
/// The polynomials of which rational functions of roots are roots.

#include "durero/algebra/value.hpp"

namespace durero::algebra {

/// A polynomial in x that is not 0 and has numerator(α)/denominator(α) + more as a root, for every root α of `of`: the
/// resultant of `of` and numerator + (more − x)·denominator.
Polynomial eliminant(const Fraction& value, const number::Dyadic& more);

/// The eliminant for (x + y√delta)/w.
Polynomial eliminant(const number::DyadicSurd& value, const number::Dyadic& more);

}  // namespace durero::algebra
