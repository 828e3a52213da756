#pragma once
/// The roots of polynomials in one number are where these change their sign; rational numbers between roots stand for
/// the intervals.

#include <optional>
#include <span>
#include <vector>

#include "durero/zed/value/value.hpp"

namespace durero::zed {

/// A list of numbers in ascending order, each once.
using Cuts = std::vector<Real>;

/// Returns the real roots of the polynomials, each of degree two at most; a constant has none. Nothing where the
/// coefficients of one of degree two are irrational.
std::optional<Cuts> roots(std::span<const Polynomial> polynomials);

/// Returns ⌊value⌋.
number::Integer floor_of(const Real& value);

/// @{ Returns a rational number below this one, above it, or strictly between two. Precondition: low < high.
Real below(const Real& high);
Real above(const Real& low);
Real between(const Real& low, const Real& high);
/// @}

}  // namespace durero::zed
