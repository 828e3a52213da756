/// Bisection by Descartes' rule of signs (Vincent, Collins and Akritas): a polynomial has at most as many positive
/// roots as its coefficients change their sign, and the difference is even. So no change means no root, and one change
/// means one root, and a simple one. Where the roots are simple, an interval that is short enough has at most one
/// change.
#include "isolate.hpp"

#include <algorithm>

namespace durero::algebra {
namespace {

using number::Dyadic;

const Whole& one() {
  static const Whole value(Dyadic::Significand(1));
  return value;
}

int sign_changes(const IntegerPolynomial& p) {
  int changes = 0, last = 0;
  for (slong i = 0; i <= p.degree(); ++i) {
    const int sign = fmpz_sgn(p.get()->coeffs + i);
    if (sign == 0) continue;
    if (last != 0 && sign != last) ++changes;
    last = sign;
  }
  return changes;
}

/// The sign changes of (1 + y)ⁿ·p(1 / (1 + y)): those that speak of the roots in 0 < x < 1.
int sign_changes_in_unit(const IntegerPolynomial& p) {
  IntegerPolynomial moved;
  fmpz_poly_reverse(moved.get(), p.get(), p.degree() + 1);
  fmpz_poly_taylor_shift(moved.get(), moved.get(), one().get());
  return sign_changes(moved);
}

/// p(2^k·x), times a positive number.
IntegerPolynomial stretched(const IntegerPolynomial& p, std::int64_t k) {
  IntegerPolynomial q(p);
  for (slong i = 0; i <= p.degree(); ++i) {
    const std::int64_t shift = k >= 0 ? k * i : -k * (p.degree() - i);
    fmpz_mul_2exp(q.get()->coeffs + i, q.get()->coeffs + i, static_cast<ulong>(shift));
  }
  return q;
}

class Bisection {
 public:
  explicit Bisection(const IntegerPolynomial& simple) : simple_(std::make_shared<const IntegerPolynomial>(simple)) {
    fmpz_poly_derivative(derivative_.get(), simple_->get());
  }

  /// `whole` is the polynomial in x, times a positive number. Precondition: the roots are simple.
  void search(IntegerPolynomial whole, const Dyadic& start, std::int64_t length) {
    std::vector<Part> parts;  // a stack of its own: roots may lie as near to each other as one likes
    parts.push_back({std::move(whole), start, length});
    while (!parts.empty()) {
      const Part part = std::move(parts.back());
      parts.pop_back();
      const int changes = sign_changes_in_unit(part.polynomial);
      if (changes == 1) take(part.low, part.low + Dyadic(Dyadic::Significand(1), part.exponent));
      if (changes > 1) divide(part, parts);
    }
  }

  /// Precondition: one simple root lies between the two.
  void take(const Dyadic& low, Dyadic high) {
    // Where the low end is a root too, a simple one, the sign behind it is that of the slope.
    const int at_low = simple_->sign_at(low);
    Isolated root{simple_, low, std::move(high), at_low != 0 ? at_low : derivative_.sign_at(low)};
    while (simple_->sign_at(root.low) == 0 || simple_->sign_at(root.high) == 0) {
      if (halve(root)) return void(found_.emplace_back(number::DyadicSurd{root.low}));
    }
    found_.emplace_back(std::move(root));
  }

  /// Ascending: the intervals and the points lie apart.
  std::vector<Root> found() && {
    std::ranges::sort(found_, {}, low_of);
    return std::move(found_);
  }

 private:
  /// Where low + 2^exponent·x is looked at for 0 < x < 1, and the polynomial in x.
  struct Part {
    IntegerPolynomial polynomial;
    Dyadic low;
    std::int64_t exponent;
  };

  static const Dyadic& low_of(const Root& root) {
    const auto* const point = std::get_if<number::DyadicSurd>(&root);
    return point ? point->x : std::get<Isolated>(root).low;
  }

  void divide(const Part& part, std::vector<Part>& parts) {
    IntegerPolynomial left = stretched(part.polynomial, -1), right;
    fmpz_poly_taylor_shift(right.get(), left.get(), one().get());
    const Dyadic middle = part.low + Dyadic(Dyadic::Significand(1), part.exponent - 1);
    if (fmpz_is_zero(right.get()->coeffs)) found_.emplace_back(number::DyadicSurd{middle});
    parts.push_back({std::move(right), middle, part.exponent - 1});
    parts.push_back({std::move(left), part.low, part.exponent - 1});
  }

  std::shared_ptr<const IntegerPolynomial> simple_;
  IntegerPolynomial derivative_;
  std::vector<Root> found_;
};

}  // namespace

bool halve(Isolated& root) {
  const Dyadic middle = number::shifted(root.low + root.high, -1);
  const int sign = root.polynomial->sign_at(middle);
  if (sign == 0) {
    root.low = root.high = middle;
    return true;
  }
  (sign == root.sign_at_low ? root.low : root.high) = middle;
  return false;
}

std::vector<Root> isolated(const IntegerPolynomial& of) {
  IntegerPolynomial p(of);
  slong zeros = 0;  // at t = 0, which is no root t > 0
  while (fmpz_is_zero(p.get()->coeffs + zeros)) ++zeros;
  fmpz_poly_shift_right(p.get(), p.get(), zeros);
  const int changes = sign_changes(p);
  if (changes == 0) return {};
  Whole bound;  // no root is greater
  fmpz_poly_bound_roots(bound.get(), p.get());
  const auto exponent = static_cast<std::int64_t>(fmpz_bits(bound.get()));
  const Dyadic end(Dyadic::Significand(1), exponent);
  if (changes == 1) {
    Bisection one(p);
    one.take(Dyadic(), end);
    return std::move(one).found();
  }
  const IntegerPolynomial simple = without_repetition(p);
  Bisection all(simple);
  all.search(stretched(simple, exponent), Dyadic(), exponent);
  return std::move(all).found();
}

}  // namespace durero::algebra
