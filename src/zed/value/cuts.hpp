#pragma once
/// A truth that depends on one number t only by the signs of polynomials in t is the same between two neighbouring
/// roots. So the roots cut the line of numbers into points and stretches, and what is so at one number of a stretch is
/// so on all of it.

#include <functional>
#include <optional>
#include <vector>

#include "durero/zed/value/roots.hpp"
#include "zed/value/context.hpp"

namespace durero::zed {

/// Says whether something is so at a number, and is so at every number of the stretch in which it lies.
using At = std::function<Truth(const Real& t)>;

/// Says whether it is so at some of the numbers.
Truth some_number(Numbers numbers, const Cuts& cuts, const At& at);

/// Returns all numbers at which it is not denied, ascending. Nothing where they are infinitely many, or more than
/// `most_numbers`.
std::optional<std::vector<Real>> every_number(Numbers numbers, const Cuts& cuts, const At& at);
inline constexpr int most_numbers = 1 << 20;

/// Returns the least number at which it is so, or the greatest; undefined where there is none, as in a stretch without
/// an end. Nothing where it is not decided at a number.
std::optional<Value> extreme_number(Numbers numbers, const Cuts& cuts, const At& at, bool greatest);

/// Says whether it is so at infinitely many numbers, as far as is decided.
bool is_infinite(Numbers numbers, const Cuts& cuts, const At& at);

/// Returns where `truth`, evaluated with an unknown number t, may change with t. Nothing where it depends on t in a way
/// that is not followed.
std::optional<Cuts> cuts_of(std::uint32_t t, Numbers numbers, Context& context, const std::function<Truth()>& truth);

/// Returns the members that the sets have in common, where the first is a curve (Set::curve) and they are finitely
/// many.
std::optional<Value> points_in_common(const Set& curve, const Set& other, Steps& steps);

}  // namespace durero::zed
