#include "durero/algebra/root.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "isolate.hpp"

namespace durero::algebra {
namespace {

using number::Dyadic;
using number::DyadicSurd;

/// The roots of c + b·t + a·t², of which one is not 0.
std::vector<Root> quadratic_roots(const Dyadic& c, const Dyadic& b, const Dyadic& a) {
  std::vector<Root> roots;
  const auto take = [&](DyadicSurd root) {
    if (number::sign(root) > 0) roots.emplace_back(std::move(root));
  };
  if (number::sign(a) == 0) {
    if (number::sign(b) != 0) take({-c, {}, {}, b});
    return roots;
  }
  const Dyadic discriminant = b * b - number::shifted(a * c, 2);
  const int sign = number::sign(discriminant);
  if (sign < 0) return roots;
  const Dyadic w = number::shifted(a, 1);
  if (sign == 0) {
    take({-b, {}, {}, w});
    return roots;
  }
  const int first = number::sign(a) > 0 ? -1 : 1;
  for (const int side : {first, -first}) take({-b, Dyadic(side), discriminant, w});
  return roots;
}

/// x + y√delta, without its denominator.
struct Sum {
  Dyadic x, y;
};

/// Horner's rule on (x + y√δ)/w: the value times wⁿ is Σ cᵢ·(x + y√δ)ⁱ·w^(n−i), which again is a sum of that kind.
int sign_at_surd(const Polynomial& p, const DyadicSurd& t) {
  Sum sum;
  Dyadic power = 1;  // of w
  for (std::size_t i = p.size(); i-- > 0;) {
    sum = {sum.x * t.x + sum.y * t.y * t.delta + p[i] * power, sum.x * t.y + sum.y * t.x};
    if (i > 0) power *= t.w;
  }
  const int sign = number::sign(DyadicSurd{sum.x, sum.y, t.delta, 1});
  return p.size() % 2 == 0 && number::sign(t.w) < 0 ? -sign : sign;
}

Polynomial coefficients_of(const IntegerPolynomial& p) {
  Polynomial of;
  for (slong i = 0; i <= p.degree(); ++i) of.emplace_back(p.coefficient(i), 0);
  return of;
}

/// Horner's rule on the interval, whose ends are not negative: −1 or 1 where all values have that sign, else 0.
int sign_on(const Polynomial& p, const Isolated& t) {
  Dyadic low, high;
  for (std::size_t i = p.size(); i-- > 0;) {
    low = low * (number::sign(low) < 0 ? t.high : t.low) + p[i];
    high = high * (number::sign(high) < 0 ? t.low : t.high) + p[i];
  }
  return number::sign(low) > 0 ? 1 : number::sign(high) < 0 ? -1 : 0;
}

/// Halves some times; the root itself where a middle is one.
std::optional<Dyadic> refine(Isolated& root, int times) {
  for (; times > 0; --times)
    if (halve(root)) return root.low;
  return std::nullopt;
}

constexpr int some_times = 8;

/// A common root of the two would be a simple one of the divisor and the only one between low and high, whose ends are
/// none: so there is one exactly where the divisor changes its sign.
bool has_common_root(const IntegerPolynomial& a, const IntegerPolynomial& b, const Dyadic& low, const Dyadic& high) {
  const IntegerPolynomial divisor = common_divisor(a, b);
  return divisor.degree() > 0 && divisor.sign_at(low) != divisor.sign_at(high);
}

int sign_at_isolated(const Polynomial& p, Isolated root) {
  bool may_be_zero = true;
  for (;;) {
    if (const int sign = sign_on(p, root)) return sign;
    if (may_be_zero && has_common_root(*root.polynomial, IntegerPolynomial(p), root.low, root.high)) return 0;
    may_be_zero = false;
    if (const auto exact = refine(root, some_times)) return sign_at(p, *exact);
  }
}

std::strong_ordering compare_isolated(Isolated a, Isolated b) {
  bool may_be_equal = true;
  for (;;) {
    if (a.high <= b.low) return std::strong_ordering::less;
    if (b.high <= a.low) return std::strong_ordering::greater;
    if (may_be_equal && has_common_root(*a.polynomial, *b.polynomial, std::max(a.low, b.low), std::min(a.high, b.high)))
      return std::strong_ordering::equal;
    may_be_equal = false;
    if (const auto exact = refine(a, some_times)) return compare(DyadicSurd{*exact}, b);
    if (const auto exact = refine(b, some_times)) return compare(a, DyadicSurd{*exact});
  }
}

/// The number lies in the interval and is a root of the polynomial exactly where it is that root.
std::strong_ordering compare_with_surd(Isolated a, const DyadicSurd& b) {
  bool may_be_equal = true;
  for (;;) {
    if (b <= DyadicSurd{a.low}) return std::strong_ordering::greater;
    if (b >= DyadicSurd{a.high}) return std::strong_ordering::less;
    if (may_be_equal && sign_at_surd(coefficients_of(*a.polynomial), b) == 0) return std::strong_ordering::equal;
    may_be_equal = false;
    if (const auto exact = refine(a, some_times)) return number::compare(DyadicSurd{*exact}, b);
  }
}

/// Of two neighbouring results the number at which rounding goes from one to the other; nothing where others lie
/// between. The greatest number rounds as if 2¹⁰²⁴ came next.
std::optional<Dyadic> boundary(double low, double high) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (std::nextafter(low, infinity) != high) return std::nullopt;
  const auto value = [](double x) {
    return std::isinf(x) ? Dyadic(Dyadic::Significand(x > 0 ? 1 : -1), 1024) : Dyadic(x);
  };
  return number::shifted(value(low) + value(high), -1);
}

bool is_one_result(double a, double b) { return a == b && std::signbit(a) == std::signbit(b); }

double rounded_isolated(const Dyadic& m, const Dyadic& n, Isolated root) {
  if (number::sign(n) == 0) return number::round_to_binary64(m);
  const auto at = [&](const Dyadic& t) { return m + n * t; };
  const bool ascends = number::sign(n) > 0;
  for (;;) {
    const Dyadic low = at(ascends ? root.low : root.high), high = at(ascends ? root.high : root.low);
    const double to_low = number::round_to_binary64(low), to_high = number::round_to_binary64(high);
    if (is_one_result(to_low, to_high)) return to_low;
    const bool has_zero = number::sign(low) < 0 && number::sign(high) > 0;
    if (const auto turn = has_zero ? std::optional(Dyadic()) : boundary(to_low, to_high)) {
      const auto side = compare_with_surd(root, {*turn - m, {}, {}, n});
      if (side == 0) return number::round_to_binary64(*turn);
      if (!has_zero) return (side > 0) == ascends ? to_high : to_low;
    }
    if (const auto exact = refine(root, some_times)) return number::round_to_binary64(at(*exact));
  }
}

/// A dyadic number below the root and above `low`, which is below it.
Dyadic above_and_below(Dyadic low, const auto& is_above_low, const auto& is_below_high) {
  Dyadic high = 1;
  while (is_below_high(high)) high = number::shifted(high, 1);
  for (;;) {
    const Dyadic middle = number::shifted(low + high, -1);
    if (!is_above_low(middle)) {
      low = middle;
    } else if (!is_below_high(middle)) {
      high = middle;
    } else {
      return middle;
    }
  }
}

}  // namespace

void normalise(Polynomial& polynomial) {
  while (!polynomial.empty() && number::sign(polynomial.back()) == 0) polynomial.pop_back();
}

std::vector<Root> positive_roots(const Polynomial& polynomial) {
  constexpr std::size_t quadratic = 3;
  if (polynomial.size() > quadratic) return isolated(IntegerPolynomial(polynomial));
  std::array<Dyadic, quadratic> c;
  std::ranges::copy(polynomial, c.begin());
  return quadratic_roots(c[0], c[1], c[2]);
}

int sign_at(const Polynomial& polynomial, const Root& root) {
  const auto* const surd = std::get_if<DyadicSurd>(&root);
  return surd ? sign_at_surd(polynomial, *surd) : sign_at_isolated(polynomial, std::get<Isolated>(root));
}

int sign_at(const Polynomial& polynomial, const Dyadic& t) {
  Dyadic sum;
  for (std::size_t i = polynomial.size(); i-- > 0;) sum = sum * t + polynomial[i];
  return number::sign(sum);
}

std::strong_ordering compare(const Root& a, const Root& b) {
  const auto *const x = std::get_if<DyadicSurd>(&a), *const y = std::get_if<DyadicSurd>(&b);
  if (x && y) return number::compare(*x, *y);
  if (y) return compare_with_surd(std::get<Isolated>(a), *y);
  if (x) return 0 <=> compare_with_surd(std::get<Isolated>(b), *x);
  return compare_isolated(std::get<Isolated>(a), std::get<Isolated>(b));
}

Dyadic between(const Root& low, const Root& high) {
  return above_and_below(
      Dyadic(), [&](const Dyadic& t) { return compare(low, DyadicSurd{t}) < 0; },
      [&](const Dyadic& t) { return compare(high, DyadicSurd{t}) > 0; });
}

Dyadic below(const Root& high) {
  return above_and_below(
      Dyadic(), [](const Dyadic&) { return true; }, [&](const Dyadic& t) { return compare(high, DyadicSurd{t}) > 0; });
}

Dyadic above(const Root& low) {
  Dyadic t = 1;
  while (compare(low, DyadicSurd{t}) >= 0) t = number::shifted(t, 1);
  return t;
}

double rounded_linear(const Dyadic& m, const Dyadic& n, const Root& root) {
  if (const auto* const surd = std::get_if<DyadicSurd>(&root))
    return number::round_to_binary64(number::linear(m, n, *surd));
  return rounded_isolated(m, n, std::get<Isolated>(root));
}

}  // namespace durero::algebra
