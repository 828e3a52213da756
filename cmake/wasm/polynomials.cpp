// In the place of FLINT: polynomials with integer coefficients, and determinants of their matrices.
#include <flint/fmpz_poly.h>
#include <flint/fmpz_poly_mat.h>

#include "algebra/integer_polynomial.hpp"

namespace {

using durero::number::Integer;
using Coefficients = std::vector<fmpz>;

const Coefficients& all(const fmpz_poly_struct* of) { return of->coeffs.all; }

void assign(fmpz_poly_struct* to, Coefficients coefficients) {
  while (!coefficients.empty() && coefficients.back().value.is_zero()) coefficients.pop_back();
  to->coeffs.all = std::move(coefficients);
}

Integer content(const Coefficients& of) {
  Integer divisor = 0;
  for (const fmpz& each : of) divisor = gcd(divisor, each.value);
  return divisor;
}

void trim(Coefficients& of) {
  while (!of.empty() && of.back().value.is_zero()) of.pop_back();
}

void divide(Coefficients& of, const Integer& by) {
  for (fmpz& each : of) each.value /= by;
}

Coefficients product(const Coefficients& a, const Coefficients& b) {
  if (a.empty() || b.empty()) return {};
  Coefficients result(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) result[i + j].value += a[i].value * b[j].value;
  return result;
}

Coefficients difference(Coefficients a, const Coefficients& b) {
  a.resize(std::max(a.size(), b.size()));
  for (std::size_t i = 0; i < b.size(); ++i) a[i].value -= b[i].value;
  trim(a);
  return a;
}

// The quotient where it is exact. Precondition: the divisor is not 0.
Coefficients exact_quotient(Coefficients a, const Coefficients& b) {
  if (a.size() < b.size()) return {};
  Coefficients quotient(a.size() - b.size() + 1);
  for (std::size_t i = quotient.size(); i-- > 0;) {
    const Integer factor = a[i + b.size() - 1].value / b.back().value;
    for (std::size_t j = 0; j < b.size(); ++j) a[i + j].value -= factor * b[j].value;
    quotient[i].value = factor;
  }
  return quotient;
}

// A multiple of the remainder, by a number that is not 0. Precondition: the divisor is not 0.
Coefficients pseudo_remainder(Coefficients a, const Coefficients& b) {
  while (a.size() >= b.size()) {
    const Integer lead = a.back().value;
    const std::size_t shift = a.size() - b.size();
    for (fmpz& each : a) each.value *= b.back().value;
    for (std::size_t j = 0; j < b.size(); ++j) a[shift + j].value -= lead * b[j].value;
    trim(a);
  }
  return a;
}

Coefficients with_positive_lead(Coefficients of) {
  if (!of.empty() && of.back().value.sign() < 0)
    for (fmpz& each : of) each.value = -each.value;
  return of;
}

}  // namespace

void fmpz_poly_init(fmpz_poly_struct*) {}
void fmpz_poly_init2(fmpz_poly_struct*, slong) {}
void fmpz_poly_clear(fmpz_poly_struct*) {}
void fmpz_poly_set(fmpz_poly_struct* to, const fmpz_poly_struct* from) { *to = *from; }
void fmpz_poly_swap(fmpz_poly_struct* a, fmpz_poly_struct* b) { std::swap(*a, *b); }
slong fmpz_poly_degree(const fmpz_poly_struct* of) { return static_cast<slong>(all(of).size()) - 1; }

void fmpz_poly_get_coeff_fmpz(fmpz* to, const fmpz_poly_struct* of, slong i) {
  to->value = i <= fmpz_poly_degree(of) ? (of->coeffs + i)->value : Integer(0);
}

void fmpz_poly_set_coeff_fmpz(fmpz_poly_struct* of, slong i, const fmpz* value) {
  Coefficients coefficients = all(of);
  coefficients.resize(std::max(coefficients.size(), static_cast<std::size_t>(i) + 1));
  coefficients[static_cast<std::size_t>(i)].value = value->value;
  assign(of, std::move(coefficients));
}

void fmpz_poly_content(fmpz* to, const fmpz_poly_struct* of) { to->value = content(all(of)); }

void fmpz_poly_scalar_divexact_fmpz(fmpz_poly_struct* to, const fmpz_poly_struct* of, const fmpz* by) {
  Coefficients coefficients = all(of);
  divide(coefficients, by->value);
  assign(to, std::move(coefficients));
}

// Euclid's remainders, each made primitive, so that the coefficients stay small.
void fmpz_poly_gcd(fmpz_poly_struct* to, const fmpz_poly_struct* a, const fmpz_poly_struct* b) {
  Coefficients one = all(a), other = all(b);
  const Integer common = gcd(content(one), content(other));
  if (!one.empty()) divide(one, content(one));
  while (!other.empty()) {
    divide(other, content(other));
    Coefficients rest = pseudo_remainder(std::move(one), other);
    one = std::move(other);
    other = std::move(rest);
  }
  for (fmpz& each : one) each.value *= common;
  assign(to, with_positive_lead(std::move(one)));
}

void fmpz_poly_derivative(fmpz_poly_struct* to, const fmpz_poly_struct* of) {
  Coefficients result;
  for (std::size_t i = 1; i < all(of).size(); ++i) result.push_back({Integer(all(of)[i].value * i)});
  assign(to, std::move(result));
}

void fmpz_poly_div(fmpz_poly_struct* to, const fmpz_poly_struct* a, const fmpz_poly_struct* b) {
  assign(to, exact_quotient(all(a), all(b)));
}

void fmpz_poly_reverse(fmpz_poly_struct* to, const fmpz_poly_struct* of, slong length) {
  Coefficients coefficients = all(of);
  coefficients.resize(static_cast<std::size_t>(length));
  std::ranges::reverse(coefficients);
  assign(to, std::move(coefficients));
}

// Horner's rule, once for each coefficient.
void fmpz_poly_taylor_shift(fmpz_poly_struct* to, const fmpz_poly_struct* of, const fmpz* by) {
  Coefficients c = all(of);
  const Integer step = by->value;
  for (std::size_t i = 0; i + 1 < c.size(); ++i)
    for (std::size_t j = c.size() - 1; j-- > i;) c[j].value += step * c[j + 1].value;
  assign(to, std::move(c));
}

void fmpz_poly_shift_right(fmpz_poly_struct* to, const fmpz_poly_struct* of, slong by) {
  const Coefficients& from = all(of);
  assign(to, {from.begin() + std::min<std::ptrdiff_t>(by, std::ssize(from)), from.end()});
}

// |root| ≤ 1 + max |aᵢ|/|aₙ|, of the coefficients below the leading one.
void fmpz_poly_bound_roots(fmpz* to, const fmpz_poly_struct* of) {
  const Coefficients& c = all(of);
  Integer greatest = 0;
  for (std::size_t i = 0; i + 1 < c.size(); ++i) greatest = std::max(greatest, Integer(abs(c[i].value)));
  to->value = c.empty() ? Integer(0) : Integer(greatest / abs(c.back().value) + 2);
}

void fmpz_poly_mat_init(fmpz_poly_mat_struct* of, slong rows, slong columns) {
  of->size = static_cast<std::size_t>(rows);
  of->entries.resize(static_cast<std::size_t>(rows * columns));
}

// Bareiss's elimination, whose divisions are exact.
void fmpz_poly_mat_det(fmpz_poly_struct* to, const fmpz_poly_mat_struct* of) {
  const std::size_t n = of->size;
  std::vector<Coefficients> m;
  for (const fmpz_poly_struct& each : of->entries) m.push_back(all(&each));
  Coefficients before = {{Integer(1)}};
  bool negative = false;
  for (std::size_t k = 0; k + 1 < n; ++k) {
    std::size_t pivot = k;
    while (pivot < n && m[pivot * n + k].empty()) ++pivot;
    if (pivot == n) return assign(to, {});
    if (pivot != k) {
      for (std::size_t j = 0; j < n; ++j) std::swap(m[pivot * n + j], m[k * n + j]);
      negative = !negative;
    }
    for (std::size_t i = k + 1; i < n; ++i)
      for (std::size_t j = k + 1; j < n; ++j)
        m[i * n + j] = exact_quotient(
            difference(product(m[i * n + j], m[k * n + k]), product(m[i * n + k], m[k * n + j])), before);
    before = m[k * n + k];
  }
  Coefficients result = n == 0 ? Coefficients{{Integer(1)}} : std::move(m.back());
  if (negative)
    for (fmpz& each : result) each.value = -each.value;
  assign(to, std::move(result));
}

namespace durero::algebra {

number::Integer IntegerPolynomial::coefficient(slong i) const { return (value_->coeffs + i)->value; }

}  // namespace durero::algebra
