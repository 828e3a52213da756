#pragma once
/// The laws of a power define a function of an axiomatic box.

#include "durero/zed/syntax/ast.hpp"

namespace durero::zed {

/// Says whether the box states of f that f(x, 0) = 1, f(x, 1) = x, f(1, a) = 1 and f(x, a + b) = f(x, a) * f(x, b), for
/// all x, a and b of sets that it names, and whether it declares f on pairs of two sets. For x that are not negative
/// only one function has these values at the whole exponents and, itself not negative, at their halves.
bool states_power(const Name& f, const Axiomatic& form);

/// Writes ∀ x : S; a : T • f(x, a) = (x, a), where f is declared on S × T: the head, and the arguments of the power.
/// Precondition: states_power(f, form).
Term power_head(const Name& f, const Axiomatic& form);

}  // namespace durero::zed
