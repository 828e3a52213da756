#pragma once
/// Polynomials with integer coefficients, by FLINT.

#include <flint/fmpz_poly.h>

#include "durero/algebra/root.hpp"

namespace durero::algebra {

/// An integer of FLINT, released at its end.
class Whole {
 public:
  Whole() { fmpz_init(value_); }
  explicit Whole(const number::Dyadic::Significand& value);
  Whole(const Whole& other) { fmpz_init_set(value_, other.value_); }
  Whole& operator=(const Whole& other) {
    fmpz_set(value_, other.value_);
    return *this;
  }
  ~Whole() { fmpz_clear(value_); }
  fmpz* get() { return value_; }
  const fmpz* get() const { return value_; }

 private:
  fmpz_t value_;
};

class IntegerPolynomial {
 public:
  IntegerPolynomial() { fmpz_poly_init(value_); }
  /// The polynomial times a positive number, so that its coefficients are integers without a common divisor: it has
  /// the same signs everywhere.
  explicit IntegerPolynomial(const Polynomial& of);
  IntegerPolynomial(const IntegerPolynomial& other) {
    fmpz_poly_init(value_);
    fmpz_poly_set(value_, other.value_);
  }
  IntegerPolynomial(IntegerPolynomial&& other) noexcept : IntegerPolynomial() { fmpz_poly_swap(value_, other.value_); }
  IntegerPolynomial& operator=(const IntegerPolynomial&) = delete;
  ~IntegerPolynomial() { fmpz_poly_clear(value_); }

  fmpz_poly_struct* get() { return value_; }
  const fmpz_poly_struct* get() const { return value_; }
  slong degree() const { return fmpz_poly_degree(value_); }
  /// Precondition: 0 ≤ i ≤ degree().
  number::Integer coefficient(slong i) const;

  /// −1, 0 or 1.
  int sign_at(const number::Dyadic& t) const;

 private:
  fmpz_poly_t value_;
};

/// The greatest common divisor; of degree 0 where there is none.
IntegerPolynomial common_divisor(const IntegerPolynomial& a, const IntegerPolynomial& b);

/// The polynomial without repeated factors: it has the same roots, each once. Precondition: it is not 0.
IntegerPolynomial without_repetition(const IntegerPolynomial& of);

}  // namespace durero::algebra
