#pragma once
/// RapidCheck generators of binary64 numbers. They draw from their whole range at every size: RapidCheck's own
/// start with small sizes, where the first tests of a property would all see the same few exponents.
#include <rapidcheck.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

namespace durero::test {

/// Every finite binary64: all exponents equally often, subnormals and both zeros among them, and often the numbers next
/// to a power of two, the least and the greatest.
inline rc::Gen<double> anyFinite() {
  const auto make = [](bool negative, std::uint64_t exponent, std::uint64_t fraction) {
    return std::bit_cast<double>((std::uint64_t{negative} << 63) | (exponent << 52) | (fraction >> 12));
  };
  const auto full = rc::gen::arbitrary<std::uint64_t>();
  const auto exponents = rc::gen::inRange<std::uint64_t>(0, 2047);
  const auto signs = rc::gen::arbitrary<bool>();
  const auto edge =
      rc::gen::element<std::uint64_t>(0, std::uint64_t{1} << 12, ~std::uint64_t{0}, std::uint64_t{1} << 63);
  return rc::gen::resize(100, rc::gen::weightedOneOf<double>({
                                  {12, rc::gen::apply(make, signs, exponents, full)},
                                  {3, rc::gen::apply(make, signs, exponents, edge)},
                                  {2, rc::gen::apply(make, signs, rc::gen::element<std::uint64_t>(0, 1, 2046), full)},
                                  {1, rc::gen::apply(make, signs, rc::gen::element<std::uint64_t>(0, 1, 2046), edge)},
                                  {1, rc::gen::element(0.0, -0.0, 1.0, -1.0)},
                              }));
}

/// Numbers of an ordinary scene: magnitude 0 or 2⁻⁸ … 2⁸, all 53 bits in use.
inline rc::Gen<double> moderate() {
  const auto make = [](bool negative, int exponent, std::uint64_t bits) {
    const double magnitude = std::ldexp(1 + static_cast<double>(bits >> 12) * 0x1p-52, exponent);
    return negative ? -magnitude : magnitude;
  };
  return rc::gen::resize(100, rc::gen::weightedOneOf<double>({
                                  {19, rc::gen::apply(make, rc::gen::arbitrary<bool>(), rc::gen::inRange(-8, 8),
                                                      rc::gen::arbitrary<std::uint64_t>())},
                                  {1, rc::gen::just(0.0)},
                              }));
}

/// Multiples of 1/8 from −16 to 16: coincidences (tangents, ties, squares) are frequent among them.
inline rc::Gen<double> dyadicGrid() {
  return rc::gen::resize(100, rc::gen::map(rc::gen::inRange(-128, 129), [](int eighths) { return eighths / 8.0; }));
}

/// The numbers of a generator but the zeros.
inline rc::Gen<double> nonZero(rc::Gen<double> numbers) {
  return rc::gen::suchThat(std::move(numbers), [](double value) { return value != 0; });
}

}  // namespace durero::test
