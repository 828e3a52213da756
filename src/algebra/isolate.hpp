#pragma once
/// Isolates the positive real roots of a polynomial.

#include "integer_polynomial.hpp"

namespace durero::algebra {

/// Returns the roots t > 0, ascending, each once. Precondition: the polynomial is not 0.
std::vector<Root> isolated(const IntegerPolynomial& of);

/// Halves the interval of a root; true where its middle is the root, which then is `low`.
bool halve(Isolated& root);

}  // namespace durero::algebra
