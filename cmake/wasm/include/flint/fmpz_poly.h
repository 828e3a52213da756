#pragma once
/// In the place of FLINT: what src/algebra asks of its integers and polynomials, by Boost's integers. The meanings are
/// FLINT's. Its methods are the schoolbook's, as the degrees here are small.
#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "durero/number/rational.hpp"

using slong = std::int64_t;
using ulong = std::uint64_t;
inline constexpr int FLINT_BITS = 64;

struct fmpz {
  durero::number::Integer value = 0;
};
using fmpz_t = fmpz[1];

inline void fmpz_init(fmpz*) {}
inline void fmpz_clear(fmpz*) {}
inline void fmpz_init_set(fmpz* to, const fmpz* from) { to->value = from->value; }
inline void fmpz_set(fmpz* to, const fmpz* from) { to->value = from->value; }
inline void fmpz_neg(fmpz* to, const fmpz* of) { to->value = -of->value; }
inline void fmpz_add(fmpz* to, const fmpz* a, const fmpz* b) { to->value = a->value + b->value; }
inline void fmpz_add_ui(fmpz* to, const fmpz* a, ulong b) { to->value = a->value + b; }
inline void fmpz_mul(fmpz* to, const fmpz* a, const fmpz* b) { to->value = a->value * b->value; }
inline void fmpz_mul_2exp(fmpz* to, const fmpz* of, ulong exponent) {
  to->value = of->value << static_cast<unsigned>(exponent);
}
inline int fmpz_sgn(const fmpz* of) { return of->value.sign(); }
inline bool fmpz_is_zero(const fmpz* of) { return of->value.is_zero(); }
/// The bits of the magnitude; none of 0.
inline ulong fmpz_bits(const fmpz* of) {
  return of->value.is_zero() ? 0 : msb(durero::number::Integer(abs(of->value))) + 1;
}

/// The coefficients, the last one not 0.
struct fmpz_poly_struct {
  struct Coefficients {
    std::vector<fmpz> all{};
    fmpz* operator+(slong i) { return &all[static_cast<std::size_t>(i)]; }
    const fmpz* operator+(slong i) const { return &all[static_cast<std::size_t>(i)]; }
    operator const fmpz*() const { return all.data(); }
  };
  Coefficients coeffs{};
};
using fmpz_poly_t = fmpz_poly_struct[1];

void fmpz_poly_init(fmpz_poly_struct* of);
void fmpz_poly_init2(fmpz_poly_struct* of, slong length);
void fmpz_poly_clear(fmpz_poly_struct* of);
void fmpz_poly_set(fmpz_poly_struct* to, const fmpz_poly_struct* from);
void fmpz_poly_swap(fmpz_poly_struct* a, fmpz_poly_struct* b);
slong fmpz_poly_degree(const fmpz_poly_struct* of);
void fmpz_poly_get_coeff_fmpz(fmpz* to, const fmpz_poly_struct* of, slong i);
void fmpz_poly_set_coeff_fmpz(fmpz_poly_struct* of, slong i, const fmpz* value);
/// The greatest common divisor of the coefficients, not negative.
void fmpz_poly_content(fmpz* to, const fmpz_poly_struct* of);
void fmpz_poly_scalar_divexact_fmpz(fmpz_poly_struct* to, const fmpz_poly_struct* of, const fmpz* by);
/// The greatest common divisor; its leading coefficient is positive.
void fmpz_poly_gcd(fmpz_poly_struct* to, const fmpz_poly_struct* a, const fmpz_poly_struct* b);
void fmpz_poly_derivative(fmpz_poly_struct* to, const fmpz_poly_struct* of);
/// The quotient, where it is exact.
void fmpz_poly_div(fmpz_poly_struct* to, const fmpz_poly_struct* a, const fmpz_poly_struct* b);
/// x^(length − 1)·of(1/x).
void fmpz_poly_reverse(fmpz_poly_struct* to, const fmpz_poly_struct* of, slong length);
/// of(x + by).
void fmpz_poly_taylor_shift(fmpz_poly_struct* to, const fmpz_poly_struct* of, const fmpz* by);
/// of/x^by, cut.
void fmpz_poly_shift_right(fmpz_poly_struct* to, const fmpz_poly_struct* of, slong by);
/// A number that no root exceeds in size: Cauchy's bound.
void fmpz_poly_bound_roots(fmpz* to, const fmpz_poly_struct* of);
