#pragma once
/// What is computed of a ray and of an element before all else: how fast the ray is at most, and whether the numbers
/// are in the range within which the bounds of the steps hold. Over double, and over what writes proofs/Formas.v.

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "durero/scene/attributes.hpp"

namespace durero::trace {

/// The sum of the magnitudes of a direction: but for its roundings at least the length.
template <class Vector>
inline auto speed_of(const Vector& v) {
  using std::abs;
  return abs(v.x) + abs(v.y) + abs(v.z);
}

/// Two binary64 side by side, and what is true of them.
struct DoublePairs {
  using Pair [[gnu::vector_size(16)]] = double;
  using Truths [[gnu::vector_size(16)]] = std::int64_t;

  static Pair magnitudes(Pair x) {
    return std::bit_cast<Pair>(std::bit_cast<Truths>(x) & std::numeric_limits<std::int64_t>::max());
  }
  static bool both(Truths truths) { return (truths[0] & truths[1]) != 0; }
};

/// Of each of two numbers, that it is 0 or of magnitude 2⁻¹⁰⁰ … 2¹⁰⁰; without branches and two at a time, as it is
/// asked for every ray.
template <class Pairs>
inline typename Pairs::Truths pair_in_range(typename Pairs::Pair x) {
  const typename Pairs::Pair size = Pairs::magnitudes(x);
  const typename Pairs::Truths above = size >= 0x1p-100, below = size <= 0x1p100, zero = size == 0;
  return (above & below) | zero;
}

/// Whether each number of a ray from p along v is in range.
template <class Pairs, class Vector>
inline auto ray_in_range(const Vector& p, const Vector& v) {
  using Pair = typename Pairs::Pair;
  return Pairs::both(pair_in_range<Pairs>(Pair{p.x, p.y}) & pair_in_range<Pairs>(Pair{p.z, v.x}) &
                     pair_in_range<Pairs>(Pair{v.y, v.z}));
}

/// Whether each number of an attribute is: a number, a vector, or the vertices of a triangle.
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

/// Whether each number of an element is, of which `value` has the attributes.
template <class Pairs, class Shape, class Value>
inline bool shape_in_range(Value value) {
  bool all = true;
  scene::for_each_attribute<Shape>(
      [&](const auto& attribute) { all = all && attribute_in_range<Pairs>(value(attribute)); });
  return all;
}

}  // namespace durero::trace
