#pragma once
/// In the place of FLINT: square matrices of polynomials.
#include <flint/fmpz_poly.h>

struct fmpz_poly_mat_struct {
  std::size_t size = 0;
  std::vector<fmpz_poly_struct> entries{};
};
using fmpz_poly_mat_t = fmpz_poly_mat_struct[1];

/// Precondition: it is square.
void fmpz_poly_mat_init(fmpz_poly_mat_struct* of, slong rows, slong columns);
inline void fmpz_poly_mat_clear(fmpz_poly_mat_struct*) {}
inline fmpz_poly_struct* fmpz_poly_mat_entry(fmpz_poly_mat_struct* of, slong row, slong column) {
  return &of->entries[static_cast<std::size_t>(row) * of->size + static_cast<std::size_t>(column)];
}
void fmpz_poly_mat_det(fmpz_poly_struct* to, const fmpz_poly_mat_struct* of);
