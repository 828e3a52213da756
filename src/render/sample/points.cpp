#include "points.hpp"

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

/// Owen's scrambling turns each digit or not by a coin of its own for the digits before it. No two of fewer than 2¹⁶
/// points have the same first 16 digits in one coordinate, so that one draw of coins suffices for all digits after
/// these.
std::uint32_t scrambled(std::uint32_t digits, std::uint64_t key) {
  constexpr int apart = 16;
  std::uint32_t turned = 0;
  for (int place = 0; place < apart; ++place) {
    const std::uint32_t before = place == 0 ? 0 : digits >> (32 - place);
    const std::uint32_t node = (1U << place) | before;  // a node of the binary tree of prefixes
    turned |= (high(mixed(key ^ node)) & 1U) << (31 - place);
  }
  const std::uint32_t leaf = (1U << apart) | (digits >> (32 - apart));
  return digits ^ (turned | (high(mixed(key ^ leaf)) >> apart));
}

/// Van der Corput's sequence: the binary digits of i behind the point.
std::uint32_t mirrored_digits(std::uint32_t i) {
  std::uint32_t digits = 0;
  for (std::uint32_t place = 1U << 31; i != 0; i >>= 1, place >>= 1)
    if (i & 1) digits |= place;
  return digits;
}

/// The second coordinate of Sobol's sequence: the digits of i times Pascal's triangle modulo 2.
std::uint32_t pascal_digits(std::uint32_t i) {
  std::uint32_t digits = 0;
  for (std::uint32_t column = 1U << 31; i != 0; i >>= 1, column ^= column >> 1)
    if (i & 1) digits ^= column;
  return digits;
}

/// The shuffled number of a sample: turned digit by digit by those before it, the first digits stay together.
std::uint32_t shuffled(std::uint32_t i, std::uint64_t key) { return scrambled(i << 16, key) >> 16; }

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
