#include "number/quick_round.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "number/binary64.hpp"
#include "number/integers.hpp"

// Integers of 128 bits, each step with a bound in units of its last place. A magnitude is its bits times 2^exponent.
namespace durero::number {
namespace {

__extension__ using Wide = unsigned __int128;
__extension__ using SignedWide = __int128;

constexpr Wide wide(std::uint64_t high, std::uint64_t low) { return Wide{high} << 64 | low; }
constexpr std::uint64_t high(Wide value) { return static_cast<std::uint64_t>(value >> 64); }
constexpr std::uint64_t low(Wide value) { return static_cast<std::uint64_t>(value); }

struct Magnitude {
  Wide bits = 0;
  std::int64_t exponent = 0;
};

/// |value| is in [bits, bits + 1), and bits ≥ 2¹²⁷. Precondition: value ≠ 0.
Magnitude leading_128(const Dyadic& value) {
  const auto& backend = value.significand().backend();
  const auto size = static_cast<std::int64_t>(backend.size());
  const auto limb = [&](std::int64_t i) { return size > i ? std::uint64_t{backend.limbs()[size - 1 - i]} : 0; };
  const int shift = std::countl_zero(limb(0));
  Wide bits = wide(limb(0), limb(1)) << shift;
  if (shift > 0) bits |= limb(2) >> (64 - shift);
  return {bits, value.exponent() + 64 * (size - 2) - shift};
}

/// |√value| is in [bits, bits + 2), and bits ≥ 2¹²⁷. Precondition: value > 0.
/// The root of bits·2^k, k = 127 or 128, loses less than 1 to being cut; the 1 by which value may exceed its bits adds
/// less than 2^k/(2√(bits·2^k)) = 2^(k/2)/(2√bits) ≤ 2⁶⁴/2^64.5 < 1.
Magnitude root_128(const Dyadic& value) {
  auto [bits, exponent] = leading_128(value);
  const int k = exponent % 2 == 0 ? 128 : 127;
  const Wide top = k == 128 ? bits : bits >> 1;
  const Limbs<2> root = root_of_limbs({0, k == 128 ? 0 : low(bits) << 63, low(top), high(top)});
  return {wide(root[1], root[0]), (exponent - k) / 2};
}

/// ⌊ab/2¹²⁸⌋
Wide high_product(Wide a, Wide b) {
  const Wide ll = Wide{low(a)} * low(b), lh = Wide{low(a)} * high(b);
  const Wide hl = Wide{high(a)} * low(b), hh = Wide{high(a)} * high(b);
  const Wide middle = Wide{high(ll)} + low(lh) + low(hl);
  return hh + high(lh) + high(hl) + high(middle);
}

/// value·2^−shift, cut.
Wide shifted_down(Wide value, std::int64_t shift) { return shift < 128 ? value >> shift : 0; }

/// x + y√delta is within 4 of bits, which is less than 2¹²⁷ in size.
struct Numerator {
  SignedWide bits;
  std::int64_t exponent;
};

Numerator numerator(const DyadicSurd& value) {
  const auto with_sign_of = [](const Dyadic& of, Wide bits) {
    return sign(of) < 0 ? -static_cast<SignedWide>(bits) : static_cast<SignedWide>(bits);
  };
  if (sign(value.y) == 0 || sign(value.delta) == 0) {
    const Magnitude x = leading_128(value.x);  // within 1, and a quarter of it within 5/4
    return {with_sign_of(value.x, x.bits >> 2), x.exponent + 2};
  }
  // (y + 1)(√delta + 2) − y√delta = 2y + √delta + 2 < 3 · 2¹²⁸ + 2, and the product is cut: y√delta is in [term, term +
  // 5).
  const Magnitude y = leading_128(value.y);
  const Magnitude root = root_128(value.delta);
  const Magnitude term{high_product(y.bits, root.bits), y.exponent + root.exponent + 128};
  const Magnitude x = sign(value.x) == 0 ? Magnitude{0, term.exponent} : leading_128(value.x);
  // Two places below the greater exponent: each part then is less than 2¹²⁶, a quarter of its error is left, and being
  // cut costs less than 1: x errs by less than 5/4, the term by less than 9/4, the sum by less than 4.
  const std::int64_t exponent = std::max(x.exponent, term.exponent) + 2;
  return {with_sign_of(value.x, shifted_down(x.bits, exponent - x.exponent)) +
              with_sign_of(value.y, shifted_down(term.bits, exponent - term.exponent)),
          exponent};
}

/// ⌊a · 2¹²⁸/b⌋. Precondition: a < 2¹²⁷ ≤ b.
Wide quotient(Wide a, Wide b) {
  const Limbs<3> result = quotient_of_limbs({0, 0, low(a), high(a)}, {low(b), high(b)});
  return wide(result[1], result[0]);
}

double rounded(bool negative, Wide bits, std::int64_t exponent) {
  const int shift = std::countl_zero(high(bits));
  bits <<= shift;
  return round_to_binary64(negative, {high(bits), exponent + 64 - shift, low(bits) != 0});
}

}  // namespace

std::optional<double> quick_round(const DyadicSurd& value) {
  const Numerator n = numerator(value);
  const Wide size = static_cast<Wide>(n.bits < 0 ? -n.bits : n.bits);
  if (size < Wide{1} << 70) return std::nullopt;
  const Magnitude w = leading_128(value.w);
  // With n the numerator, |n − size| ≤ 4, and w the denominator, in [w.bits, w.bits + 1):
  //   n/w ≤ (size + 4)/w.bits, and 4 · 2¹²⁸/w.bits ≤ 8, the cut 1: at most 9 above the quotient;
  //   n/w ≥ (size − 4)/(w.bits + 1), where the 1 costs at most size · 2¹²⁸/w.bits² ≤ 2: at most 10 below it.
  // The quotient is at least size ≥ 2⁷⁰, and less than 2¹²⁸ because size < 2¹²⁷ ≤ w.bits.
  const Wide q = quotient(size, w.bits);
  const std::int64_t exponent = n.exponent - w.exponent - 128;
  const bool negative = (n.bits < 0) != (sign(value.w) < 0);
  if (q > ~Wide{0} - 10) return std::nullopt;
  const double one = rounded(negative, q - 10, exponent);
  const double other = rounded(negative, q + 10, exponent);
  if (one != other) return std::nullopt;
  return one;
}

}  // namespace durero::number
