#pragma once
/// The quantities of a ray and of an element that every step needs: an upper bound of the ray's speed, and whether the
/// numbers are in the range of the steps' bounds. The functions are templates over double and over the symbolic numbers
/// that write proofs/Formas.v.

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "durero/scene/attributes.hpp"

namespace durero::trace {

/// The sum of the magnitudes of a direction's components: at least its length, but for roundings.
template <class Vector>
inline auto speed_of(const Vector& v) {
  using std::abs;
  return abs(v.x) + abs(v.y) + abs(v.z);
}

/// @{ The least and the greatest magnitude of ordinary numbers, of which 0 is one too.
inline constexpr double least_ordinary = 0x1p-100, greatest_ordinary = 0x1p100;
/// @}

/// Two binary64 in a register, and two truth values.
struct DoublePairs {
  using Pair [[gnu::vector_size(16)]] = double;
  using Truths [[gnu::vector_size(16)]] = std::int64_t;

  static Pair magnitudes(Pair x) {
    return std::bit_cast<Pair>(std::bit_cast<Truths>(x) & std::numeric_limits<std::int64_t>::max());
  }
  static bool both(Truths truths) { return (truths[0] & truths[1]) != 0; }
};

/// Whether each of two numbers is 0 or of magnitude 2⁻¹⁰⁰ … 2¹⁰⁰. The test has no branches and takes two numbers at
/// once, because every ray needs it.
template <class Pairs>
inline typename Pairs::Truths pair_in_range(typename Pairs::Pair x) {
  const typename Pairs::Pair size = Pairs::magnitudes(x);
  const typename Pairs::Truths above = size >= least_ordinary, below = size <= greatest_ordinary, zero = size == 0;
  return (above & below) | zero;
}

/// Whether each number of a ray from p along v is in range.
template <class Pairs, class Vector>
inline auto ray_in_range(const Vector& p, const Vector& v) {
  using Pair = typename Pairs::Pair;
  return Pairs::both(pair_in_range<Pairs>(Pair{p.x, p.y}) & pair_in_range<Pairs>(Pair{p.z, v.x}) &
                     pair_in_range<Pairs>(Pair{v.y, v.z}));
}

/// Whether each number of an attribute is in range: of a number, a vector, or the vertices of a triangle.
template <class Pairs, class Stored>
inline auto attribute_in_range(const Stored& a) {
  using Pair = typename Pairs::Pair;
  if constexpr (requires { a[0].x; })
    return attribute_in_range<Pairs>(a[0]) && attribute_in_range<Pairs>(a[1]) && attribute_in_range<Pairs>(a[2]);
  else if constexpr (requires { a.x; })
    return Pairs::both(pair_in_range<Pairs>(Pair{a.x, a.y}) & pair_in_range<Pairs>(Pair{a.z, a.z}));
  else
    return Pairs::both(pair_in_range<Pairs>(Pair{a, a}));
}

/// Whether each number of an element is in range; value(attribute) gives its attributes.
template <class Pairs, class Shape, class Value>
inline bool shape_in_range(Value value) {
  bool all = true;
  scene::for_each_attribute<Shape>(
      [&](const auto& attribute) { all = all && attribute_in_range<Pairs>(value(attribute)); });
  return all;
}

}  // namespace durero::trace
