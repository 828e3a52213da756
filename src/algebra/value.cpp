#include "durero/algebra/value.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "durero/number/quotient.hpp"
#include "eliminant.hpp"
#include "isolate.hpp"

namespace durero::algebra {
namespace {

using number::Dyadic;
using number::DyadicSurd;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// low ≤ v ≤ high
struct Enclosure {
  Dyadic low, high;
};

/// Horner's rule on an interval whose ends are not negative.
Enclosure range(const Polynomial& p, const Enclosure& t) {
  Enclosure sum;
  for (std::size_t i = p.size(); i-- > 0;)
    sum = {sum.low * (number::sign(sum.low) < 0 ? t.high : t.low) + p[i],
           sum.high * (number::sign(sum.high) < 0 ? t.low : t.high) + p[i]};
  return sum;
}

/// A dyadic number not above, or not below, the number: cut to some bits.
Dyadic cut(const Dyadic& number, std::int64_t bits, bool up) {
  if (number::sign(number) == 0) return number;
  const std::int64_t unit = number::floor_log2(number) - bits;
  if (number.exponent() >= unit) return number;
  const auto shift = static_cast<unsigned>(unit - number.exponent());
  Dyadic::Significand whole = abs(number.significand()) >> shift;
  if ((number::sign(number) > 0) == up) ++whole;
  return {number::sign(number) < 0 ? Dyadic::Significand(-whole) : whole, unit};
}

/// A quotient of dyadic numbers, cut; precondition: the divisor is positive.
Dyadic quotient(const Dyadic& n, const Dyadic& d, std::int64_t bits, bool up) {
  if (number::sign(n) == 0) return n;
  const std::int64_t shift =
      std::max<std::int64_t>(0, bits + number::floor_log2(d) - d.exponent() - number::floor_log2(n) + n.exponent());
  const Dyadic::Significand dividend = abs(n.significand()) << static_cast<unsigned>(shift);
  Dyadic::Significand whole = dividend / d.significand();
  if ((number::sign(n) > 0) == up) ++whole;
  return {number::sign(n) < 0 ? Dyadic::Significand(-whole) : whole, n.exponent() - d.exponent() - shift};
}

Enclosure interval_of(const DyadicSurd& value, std::int64_t bits) {
  Enclosure sum{value.x, value.x};
  if (number::sign(value.y) != 0 && number::sign(value.delta) != 0) {
    const number::SquareRoot root = number::square_root(value.delta, bits);
    const Dyadic one = value.y * root.value, other = root.exact ? one : one + value.y * root.unit;
    sum = {value.x + std::min(one, other), value.x + std::max(one, other)};
  }
  if (number::sign(value.w) > 0)
    return {quotient(sum.low, value.w, bits, false), quotient(sum.high, value.w, bits, true)};
  return {quotient(-sum.high, -value.w, bits, false), quotient(-sum.low, -value.w, bits, true)};
}

Enclosure interval_of(const Root& root, std::int64_t bits) {
  if (const auto* const surd = std::get_if<DyadicSurd>(&root)) return interval_of(*surd, bits);
  const Root fine = refined(root, bits);
  if (const auto* const surd = std::get_if<DyadicSurd>(&fine)) return interval_of(*surd, bits);
  const auto& isolated = std::get<Isolated>(fine);
  return {isolated.low, isolated.high};
}

/// Nothing where so many bits do not yet tell the sign of the denominator.
std::optional<Enclosure> interval_of(const Fraction& value, std::int64_t bits) {
  Enclosure t = interval_of(value.at, bits);
  if (number::sign(t.low) < 0) t.low = Dyadic();
  t = {cut(t.low, bits, false), cut(t.high, bits, true)};
  Enclosure n = range(value.numerator, t), d = range(value.denominator, t);
  if (number::sign(d.high) < 0) {
    d = {-d.high, -d.low};
    n = {-n.high, -n.low};
  }
  if (number::sign(d.low) <= 0) return std::nullopt;
  return Enclosure{quotient(n.low, number::sign(n.low) < 0 ? d.low : d.high, bits, false),
                   quotient(n.high, number::sign(n.high) < 0 ? d.high : d.low, bits, true)};
}

std::optional<Enclosure> interval_of(const Value& value, std::int64_t bits) {
  if (const auto* const surd = std::get_if<DyadicSurd>(&value)) return interval_of(*surd, bits);
  return interval_of(std::get<Fraction>(value), bits);
}

/// The bits with which a search begins; it doubles them.
constexpr std::int64_t first_bits = 160;

Enclosure known_interval(const Value& value, std::int64_t& bits) {
  for (;; bits *= 2)
    if (auto interval = interval_of(value, bits)) return *interval;
}

/// Which of the roots of a polynomial, all of them positive, the value plus `more` is.
std::size_t place_among(const std::vector<Root>& roots, const Value& value, const Dyadic& more) {
  for (std::int64_t bits = first_bits;; bits *= 2) {
    const Enclosure in = known_interval(value, bits);
    std::size_t place = 0, count = 0;
    for (std::size_t i = 0; i < roots.size(); ++i) {
      if (compare(roots[i], DyadicSurd{in.low + more}) < 0 || compare(roots[i], DyadicSurd{in.high + more}) > 0)
        continue;
      place = i;
      ++count;
    }
    if (count == 1) return place;
  }
}

Polynomial product(const Polynomial& a, const Polynomial& b) {
  Polynomial all(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) all[i + j] += a[i] * b[j];
  return all;
}

Polynomial eliminant_of(const Value& value, const Dyadic& more) {
  return std::visit([&](const auto& of) { return eliminant(of, more); }, value);
}

/// Whether two values that some hundred bits do not tell apart are equal: both, moved to the positive numbers, are
/// roots of one polynomial, and equal where they are the same root of it.
bool are_equal(const Value& a, const Value& b) {
  std::int64_t bits = first_bits;
  Dyadic more = 1;
  while (number::sign(known_interval(a, bits).low + more) <= 0 || number::sign(known_interval(b, bits).low + more) <= 0)
    more = number::shifted(more, 1);
  const std::vector<Root> roots = positive_roots(product(eliminant_of(a, more), eliminant_of(b, more)));
  return place_among(roots, a, more) == place_among(roots, b, more);
}

// The binary64 numbers in their order, as integers: −0 and +0 are both 0, and the infinities come after the greatest.
std::int64_t number_of(double value) {
  const auto bits = std::bit_cast<std::int64_t>(std::abs(value));
  return std::signbit(value) ? -bits : bits;
}
double of_number(std::int64_t number) {
  const auto value = std::bit_cast<double>(number < 0 ? -number : number);
  return number < 0 ? -value : value;
}

/// The number at which rounding goes from one binary64 to the next. The greatest rounds as if 2¹⁰²⁴ came next.
Dyadic boundary_above(std::int64_t number) {
  const auto value = [](double x) {
    return std::isinf(x) ? Dyadic(Dyadic::Significand(x > 0 ? 1 : -1), 1024) : Dyadic(x);
  };
  return number::shifted(value(of_number(number)) + value(of_number(number + 1)), -1);
}

/// The nearest binary64, ties to even, of the number that `order` compares with dyadic ones: searched for from a guess,
/// by steps that double and then by halves.
template <class Order>
double nearest(Order order, double guess) {
  const std::int64_t end = number_of(infinity);
  const auto rounds_above = [&](std::int64_t n) {  // whether the result comes after n
    if (n < -end) return true;
    if (n >= end) return false;
    const auto side = order(boundary_above(n));
    return side > 0 || (side == 0 && n % 2 != 0);
  };
  std::int64_t low = number_of(guess) - 1, high = low + 1, step = 1;
  for (; !rounds_above(low); low = std::max(low - step, -end - 1), step *= 2) high = low;
  for (step = 1; rounds_above(high); high = std::min(high + step, end), step *= 2) low = high;
  while (high - low > 1) {
    const std::int64_t middle = low + (high - low) / 2;
    (rounds_above(middle) ? low : high) = middle;
  }
  return of_number(high);
}

/// A binary64 near √number.
double root_near(const Dyadic& number) {
  return number::sign(number) <= 0 ? 0 : number::round_to_binary64(number::square_root(number, 60).value);
}

}  // namespace

Root refined(Root root, std::int64_t bits) {
  auto* const isolated = std::get_if<Isolated>(&root);
  if (isolated == nullptr) return root;
  while (isolated->high - isolated->low > number::shifted(isolated->high, -bits))
    if (halve(*isolated)) return DyadicSurd{isolated->low};
  return root;
}

int sign(const Value& value) {
  const auto order = compare(value, Dyadic());
  return order < 0 ? -1 : order > 0 ? 1 : 0;
}

std::strong_ordering compare(const Value& a, const Dyadic& b) {
  if (const auto* const surd = std::get_if<DyadicSurd>(&a)) return number::compare(*surd, {b});
  const auto& [numerator, denominator, of, at] = std::get<Fraction>(a);
  if (const auto known = interval_of(a, first_bits)) {
    if (known->low > b) return std::strong_ordering::greater;
    if (known->high < b) return std::strong_ordering::less;
  }
  Polynomial difference = numerator;
  difference.resize(std::max(numerator.size(), denominator.size()));
  for (std::size_t i = 0; i < denominator.size(); ++i) difference[i] -= b * denominator[i];
  normalise(difference);
  return difference.empty() ? std::strong_ordering::equal : sign_at(difference, at) * sign_at(denominator, at) <=> 0;
}

std::strong_ordering compare(const Value& a, const Value& b) {
  const auto *const x = std::get_if<DyadicSurd>(&a), *const y = std::get_if<DyadicSurd>(&b);
  if (x && y) return number::compare(*x, *y);
  bool may_be_equal = true;
  for (std::int64_t bits = first_bits;; bits *= 2) {
    const Enclosure in = known_interval(a, bits), other = known_interval(b, bits);
    if (in.high < other.low) return std::strong_ordering::less;
    if (in.low > other.high) return std::strong_ordering::greater;
    if (may_be_equal && are_equal(a, b)) return std::strong_ordering::equal;
    may_be_equal = false;
  }
}

double round_to_binary64(const Value& value) {
  if (const auto* const surd = std::get_if<DyadicSurd>(&value)) return number::round_to_binary64(*surd);
  std::int64_t bits = first_bits;
  const Enclosure in = known_interval(value, bits);
  const double one = number::round_to_binary64(in.low), other = number::round_to_binary64(in.high);
  if (one == other && std::signbit(one) == std::signbit(other)) return one;
  const double found = nearest([&](const Dyadic& b) { return compare(value, b); }, one);
  return found == 0 && compare(value, Dyadic()) < 0 ? -0.0 : found;
}

double rounded_root(const Value& value) {
  std::int64_t bits = first_bits;
  const Enclosure in = known_interval(value, bits);
  return nearest(
      [&](const Dyadic& b) {
        if (number::sign(b) < 0) return std::strong_ordering::greater;
        const Dyadic squared = number::square(b);
        if (in.low > squared) return std::strong_ordering::greater;
        if (in.high < squared) return std::strong_ordering::less;
        return compare(value, squared);
      },
      root_near(in.low));
}

}  // namespace durero::algebra
