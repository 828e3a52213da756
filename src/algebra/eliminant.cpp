#include "eliminant.hpp"

#include <flint/fmpz_poly_mat.h>

#include <algorithm>
#include <limits>

#include "integer_polynomial.hpp"

namespace durero::algebra {
namespace {

using number::Dyadic;

/// A square matrix of polynomials of FLINT, released at its end.
class PolynomialMatrix {
 public:
  explicit PolynomialMatrix(std::size_t size) {
    fmpz_poly_mat_init(value_, static_cast<slong>(size), static_cast<slong>(size));
  }
  PolynomialMatrix(const PolynomialMatrix&) = delete;
  PolynomialMatrix& operator=(const PolynomialMatrix&) = delete;
  ~PolynomialMatrix() { fmpz_poly_mat_clear(value_); }

  /// Adds number · 2^-unit · x^power to an entry. Precondition: that is an integer.
  void add(std::size_t row, std::size_t column, slong power, const Dyadic& number, std::int64_t unit) {
    if (number::sign(number) == 0) return;
    Whole term(number.significand());
    fmpz_mul_2exp(term.get(), term.get(), static_cast<ulong>(number.exponent() - unit));
    fmpz_poly_struct* const entry = fmpz_poly_mat_entry(value_, static_cast<slong>(row), static_cast<slong>(column));
    Whole sum;
    fmpz_poly_get_coeff_fmpz(sum.get(), entry, power);
    fmpz_add(sum.get(), sum.get(), term.get());
    fmpz_poly_set_coeff_fmpz(entry, power, sum.get());
  }

  Polynomial determinant() const {
    IntegerPolynomial found;
    fmpz_poly_mat_det(found.get(), value_);
    Polynomial polynomial;
    for (slong i = 0; i <= found.degree(); ++i) polynomial.emplace_back(found.coefficient(i), 0);
    return polynomial;
  }

 private:
  fmpz_poly_mat_t value_;
};

std::int64_t least_exponent(std::initializer_list<const Polynomial*> polynomials) {
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  for (const Polynomial* polynomial : polynomials)
    for (const Dyadic& each : *polynomial)
      if (number::sign(each) != 0) least = std::min(least, each.exponent());
  return least;
}

Dyadic at(const Polynomial& polynomial, std::size_t i) { return i < polynomial.size() ? polynomial[i] : Dyadic(); }

}  // namespace

// Sylvester's matrix of the two polynomials in α; the entries of the second are linear in x. It is not 0 as a
// polynomial in x: for an x that is not the value at any root the two have no root in common, and the denominator has
// none either with `of`, so that the leading coefficient of the second matters to a factor only.
Polynomial eliminant(const Fraction& value, const Dyadic& more) {
  Polynomial numerator = value.numerator;
  numerator.resize(std::max(numerator.size(), value.denominator.size()));
  for (std::size_t i = 0; i < value.denominator.size(); ++i) numerator[i] += more * value.denominator[i];
  const std::size_t m = value.of.size() - 1, n = numerator.size() - 1;
  PolynomialMatrix matrix(m + n);
  const std::int64_t unit = least_exponent({&value.of}), other = least_exponent({&numerator, &value.denominator});
  for (std::size_t row = 0; row < n; ++row)
    for (std::size_t i = 0; i <= m; ++i) matrix.add(row, row + i, 0, value.of[m - i], unit);
  for (std::size_t row = 0; row < m; ++row)
    for (std::size_t i = 0; i <= n; ++i) {
      matrix.add(n + row, row + i, 0, numerator[n - i], other);
      matrix.add(n + row, row + i, 1, -at(value.denominator, n - i), other);
    }
  return matrix.determinant();
}

// With s = w·more: (w·x − (x₀ + s))² = y²·delta.
Polynomial eliminant(const number::DyadicSurd& value, const Dyadic& more) {
  const Dyadic middle = value.x + value.w * more;
  return {number::square(middle) - number::square(value.y) * value.delta, number::shifted(-(value.w * middle), 1),
          number::square(value.w)};
}

}  // namespace durero::algebra
