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

std::uint32_t low(std::uint64_t bits) { return static_cast<std::uint32_t>(bits); }

std::uint32_t high(std::uint64_t bits) { return static_cast<std::uint32_t>(bits >> 32); }

/// The coordinate from −1/2 that 32 binary digits give: the middle of the interval that they begin.
double coordinate(std::uint32_t digits) { return (digits + 0.5) * 0x1p-32 - 0.5; }

/// The second coordinate of Sobol's sequence, for the first of Van der Corput's, which is i itself: each coordinate is
/// a number whose lowest digit stands first behind the point. Its digits are those of i times Pascal's triangle modulo
/// 2, whose entry (j, b) is 1 where b has every binary digit of j (Lucas's theorem). So digit j is the sum of those
/// digits, and each line takes those that differ from j in one place of its number.
std::uint32_t pascal_digits(std::uint32_t i) {
  i ^= i >> 1 & 0x55555555;
  i ^= i >> 2 & 0x33333333;
  i ^= i >> 4 & 0x0F0F0F0F;
  i ^= i >> 8 & 0x00FF00FF;
  return i ^ i >> 16;
}

/// Scrambling of a coordinate whose lowest digit stands first: x becomes m·(x + s) modulo 2³², by a random number s and
/// a random odd number m. No digit depends on those after it, so a net stays a net. Pairs of points go together as by
/// Owen's scrambling: over all s the image of one point is any number, evenly; and if two points have k digits in
/// common and differ in the next, their difference is 2ᵏ times an odd number, and over all m that of their images is
/// any such number, evenly, whatever the image of the one. So the images have k digits in common and differ in the
/// next, and the others are coins. A variance is a sum over pairs, hence it is that of Owen's scrambling. The fixed
/// steps before and after turn digits by those before them, as Laine and Karras do (*Stratified Sampling for Stochastic
/// Transparency*, 2011), which changes nothing of this: they keep the points from standing in arithmetic progressions.
std::uint32_t scrambled(std::uint32_t x, std::uint64_t coins) {
  x ^= x * 0x3D20ADEA;
  x = (x + low(coins)) * (high(coins) | 1);
  return x ^ x * 0x05526C56;
}

/// The binary digits turned round.
std::uint32_t mirrored(std::uint32_t i) {
  i = (i >> 1 & 0x55555555) | (i & 0x55555555) << 1;
  i = (i >> 2 & 0x33333333) | (i & 0x33333333) << 2;
  i = (i >> 4 & 0x0F0F0F0F) | (i & 0x0F0F0F0F) << 4;
  return __builtin_bswap32(i);
}

/// The shuffled number of a sample: scrambled from its highest digit on, so that blocks of 2ᵐ stay together.
std::uint32_t shuffled(std::uint32_t i, std::uint64_t coins) { return mirrored(scrambled(mirrored(i), coins)); }

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
  return {coordinate(mirrored(scrambled(i, mixed(key)))),
          coordinate(mirrored(scrambled(pascal_digits(i), mixed(key + 1))))};
}

glm::dvec2 SampleSource::pair(std::uint64_t dimension) const {
  const std::uint64_t own = mixed(key ^ mixed(dimension));
  if (independent) {
    const std::uint64_t first = mixed(own ^ number);
    return {coordinate(high(first)) + 0.5, coordinate(high(mixed(first))) + 0.5};
  }
  return in_net(shuffled(number, mixed(own + 2)), own) + 0.5;
}

std::uint64_t of_meeting(std::uint64_t branch) { return mixed(branch) & ~std::uint64_t{0xFFFF}; }

double time_of(std::uint32_t number, std::uint64_t seed) {
  const std::uint64_t key = mixed(seed);
  return coordinate(mirrored(scrambled(shuffled(number, mixed(key + 2)), mixed(key)))) + 0.5;
}

}  // namespace durero::render
