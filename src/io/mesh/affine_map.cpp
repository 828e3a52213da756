#include "affine_map.hpp"

#include "durero/number/quotient.hpp"

namespace durero::io {
namespace {

using number::Dyadic;

Dyadic inner_product(const std::array<Dyadic, 3>& a, const std::array<Dyadic, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// n/d rounded once. Precondition: d ≠ 0.
double rounded(const Dyadic& n, const Dyadic& d) {
  return d == 1 ? number::round_to_binary64(n) : number::round_quotient(n, d);
}

std::array<Dyadic, 3> exact_triple(const glm::dvec3& x) { return {Dyadic(x.x), Dyadic(x.y), Dyadic(x.z)}; }

}  // namespace

AffineMap::AffineMap() {
  for (std::size_t i = 0; i < 3; ++i) linear_[i][i] = 1;
}

AffineMap AffineMap::of_matrix(const std::array<double, 16>& matrix) {
  AffineMap map;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) map.linear_[i][j] = matrix[4 * j + i];
    map.shift_[i] = matrix[12 + i];
  }
  map.divisor_ = matrix[15];
  return map;
}

AffineMap AffineMap::of_parts(const glm::dvec3& translation, const std::array<double, 4>& rotation,
                              const glm::dvec3& scale) {
  const Dyadic x = rotation[0], y = rotation[1], z = rotation[2], w = rotation[3], two = 2;
  const Dyadic xx = square(x), yy = square(y), zz = square(z), ww = square(w);
  AffineMap map;
  map.linear_ = {Row{ww + xx - yy - zz, two * (x * y - w * z), two * (x * z + w * y)},
                 Row{two * (x * y + w * z), ww - xx + yy - zz, two * (y * z - w * x)},
                 Row{two * (x * z - w * y), two * (y * z + w * x), ww - xx - yy + zz}};
  map.divisor_ = xx + yy + zz + ww;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) map.linear_[i][j] *= scale[static_cast<int>(j)];
    map.shift_[i] = translation[static_cast<int>(i)] * map.divisor_;
  }
  return map;
}

AffineMap AffineMap::after(const AffineMap& inner) const {
  AffineMap map;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j)
      map.linear_[i][j] = inner_product(linear_[i], {inner.linear_[0][j], inner.linear_[1][j], inner.linear_[2][j]});
    map.shift_[i] = inner_product(linear_[i], inner.shift_) + shift_[i] * inner.divisor_;
  }
  map.divisor_ = divisor_ * inner.divisor_;
  return map;
}

glm::dvec3 AffineMap::point(const glm::dvec3& numerators, double denominator) const {
  const Row p = exact_triple(numerators);
  const Dyadic below = denominator, divisor = divisor_ * below;
  glm::dvec3 image;
  for (std::size_t i = 0; i < 3; ++i)
    image[static_cast<int>(i)] = rounded(inner_product(linear_[i], p) + shift_[i] * below, divisor);
  return image;
}

Dyadic AffineMap::cofactor(std::size_t row, std::size_t column) const {
  const Row &a = linear_[(row + 1) % 3], &b = linear_[(row + 2) % 3];
  const std::size_t j = (column + 1) % 3, k = (column + 2) % 3;
  return a[j] * b[k] - a[k] * b[j];
}

Dyadic AffineMap::determinant() const {
  return inner_product(linear_[0], {cofactor(0, 0), cofactor(0, 1), cofactor(0, 2)});
}

// The transposed inverse of linear/divisor is divisor · cofactors / determinant.
std::optional<AffineMap> AffineMap::normals() const {
  const Dyadic whole = determinant();
  if (sign(whole) == 0) return std::nullopt;
  const Dyadic factor = sign(whole) > 0 ? divisor_ : -divisor_;
  AffineMap map;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) map.linear_[i][j] = factor * cofactor(i, j);
  map.divisor_ = sign(whole) > 0 ? whole : -whole;
  return map;
}

std::optional<AffineMap> AffineMap::inverse() const {
  const auto transposed = normals();
  if (!transposed) return std::nullopt;
  AffineMap back;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) back.linear_[i][j] = transposed->linear_[j][i] * divisor_;
  for (std::size_t i = 0; i < 3; ++i)
    back.shift_[i] =
        -inner_product({transposed->linear_[0][i], transposed->linear_[1][i], transposed->linear_[2][i]}, shift_);
  back.divisor_ = transposed->divisor_ * divisor_;
  return back;
}

AffineMap AffineMap::linear() const {
  AffineMap map = *this;
  map.shift_ = {};
  return map;
}

bool AffineMap::keeps_axes() const {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (i != j && sign(linear_[i][j]) != 0) return false;
  return true;
}

bool AffineMap::is_identity() const {
  for (std::size_t i = 0; i < 3; ++i)
    if (linear_[i][i] != divisor_ || sign(shift_[i]) != 0) return false;
  return keeps_axes();
}

}  // namespace durero::io
