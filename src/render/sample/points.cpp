#include "points.hpp"

#include <utility>

namespace durero::render {
namespace {

/// The mixing function of SplitMix64 (Steele, Lea and Flood, 2014): a bijection whose bits look independent.
std::uint64_t mixed(std::uint64_t key) {
  key += 0x9E3779B97F4A7C15;
  key = (key ^ (key >> 30)) * 0xBF58476D1CE4E5B9;
  key = (key ^ (key >> 27)) * 0x94D049BB133111EB;
  return key ^ (key >> 31);
}

std::uint32_t high(std::uint64_t bits) { return static_cast<std::uint32_t>(bits >> 32); }

/// The coordinate from −1/2 that 32 binary digits give: the middle of the interval that they begin.
double coordinate(std::uint32_t digits) { return (digits + 0.5) * 0x1p-32 - 0.5; }

/// The number of digits that Owen's scrambling turns each by itself: no two of fewer than 2¹⁶ points have the same
/// first 16 digits in one coordinate.
constexpr int apart = 16;

/// Owen's scrambling turns each digit or not by a coin of its own for the digits before it. The coins of the digits
/// from `from` on are those of a binary tree, which has 2ʲ for the digit j places on: 63 for six digits, one word.
template <int from, int... j>
std::uint32_t turned(std::uint32_t digits, std::uint64_t key, std::integer_sequence<int, j...>) {
  static_assert(sizeof...(j) <= 6);
  const std::uint64_t own = std::uint64_t{digits} << (32 + from), before = from == 0 ? 0 : digits >> (32 - from) % 32;
  const std::uint64_t coins = mixed(key ^ ((1U << from) | before));
  const auto coin = [&](int at) { return coins >> ((1U << at) - 1 + (at == 0 ? 0 : own >> (64 - at) % 64)) & 1; };
  return static_cast<std::uint32_t>(((coin(j) << (31 - from - j)) | ...));
}

/// The coins of the first 16 digits, in their places.
std::uint32_t first_turned(std::uint32_t digits, std::uint64_t key) {
  constexpr std::make_integer_sequence<int, 6> six;
  constexpr std::make_integer_sequence<int, 5> five;
  return turned<0>(digits, key, six) | turned<6>(digits, key, five) | turned<11>(digits, key, five);
}

/// One draw of coins suffices for all digits after those that are turned by themselves.
std::uint32_t scrambled(std::uint32_t digits, std::uint64_t key) {
  const std::uint32_t leaf = (1U << apart) | (digits >> (32 - apart));
  return digits ^ (first_turned(digits, key) | (high(mixed(key ^ leaf)) >> apart));
}

/// Van der Corput's sequence: the binary digits of i behind the point, the lowest first.
std::uint32_t mirrored_digits(std::uint32_t i) {
  i = (i >> 1 & 0x55555555) | (i & 0x55555555) << 1;
  i = (i >> 2 & 0x33333333) | (i & 0x33333333) << 2;
  i = (i >> 4 & 0x0F0F0F0F) | (i & 0x0F0F0F0F) << 4;
  return __builtin_bswap32(i);
}

/// The second coordinate of Sobol's sequence: the digits of i times Pascal's triangle modulo 2, whose entry (j, b) is 1
/// where b has every binary digit of j (Lucas's theorem). So digit j is the sum of those digits, and each line takes
/// those that differ from j in one place of its number.
std::uint32_t pascal_digits(std::uint32_t i) {
  i ^= i >> 1 & 0x55555555;
  i ^= i >> 2 & 0x33333333;
  i ^= i >> 4 & 0x0F0F0F0F;
  i ^= i >> 8 & 0x00FF00FF;
  i ^= i >> 16;
  return mirrored_digits(i);
}

/// The shuffled number of a sample: turned digit by digit by those before it, the first digits stay together.
std::uint32_t shuffled(std::uint32_t i, std::uint64_t key) {
  const std::uint32_t digits = i << apart;
  return (digits ^ first_turned(digits, key)) >> apart;
}

}  // namespace

std::uint64_t key_of(std::uint32_t x, std::uint32_t y, std::uint32_t set) {
  return mixed(mixed((std::uint64_t(x) << 32) | y) + set);
}

glm::dvec2 in_grid(std::uint32_t side, std::uint32_t i) {
  const auto centre = [&](std::uint32_t part) { return (2.0 * part + 1 - side) / (2.0 * side); };
  return {centre(i % side), centre(i / side)};
}

glm::dvec2 in_strata(std::uint32_t side, std::uint32_t i, std::uint64_t key) {
  const std::uint64_t across = mixed(key ^ i), down = mixed(across);
  const glm::dvec2 in_part(coordinate(high(across)), coordinate(high(down)));
  return in_grid(side, i) + in_part / double(side);
}

glm::dvec2 in_net(std::uint32_t i, std::uint64_t key) {
  return {coordinate(scrambled(mirrored_digits(i), key)), coordinate(scrambled(pascal_digits(i), mixed(key)))};
}

glm::dvec2 SampleSource::pair(std::uint64_t dimension) const {
  const std::uint64_t own = mixed(key ^ mixed(dimension));
  if (independent) {
    const std::uint64_t first = mixed(own ^ number);
    return {coordinate(high(first)) + 0.5, coordinate(high(mixed(first))) + 0.5};
  }
  return in_net(shuffled(number, mixed(own + 1)), own) + 0.5;
}

std::uint64_t of_meeting(std::uint64_t branch) { return mixed(branch) & ~std::uint64_t{0xFFFF}; }

double time_of(std::uint32_t number, std::uint64_t seed) {
  const std::uint64_t key = mixed(seed);
  return coordinate(scrambled(mirrored_digits(shuffled(number, mixed(key))), key)) + 0.5;
}

}  // namespace durero::render
