#include "placement.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace durero::oracle {
namespace {

glm::dvec3 rounded(const model::ExactVector& v) {
  return {number::round_to_binary64(v.x), number::round_to_binary64(v.y), number::round_to_binary64(v.z)};
}

/// At least the greatest stretch of a direction: the square root of an eigenvalue of mᵀm, none of which is above the
/// greatest sum of the magnitudes in a row (Gershgorin). Where m turns what it has stretched along the axes, that is
/// the stretch itself.
double greatest_stretch(const glm::dmat3& m) {
  double greatest = 0;
  for (int i = 0; i < 3; ++i) {
    double sum = 0;
    for (int j = 0; j < 3; ++j) sum += std::abs(glm::dot(m[i], m[j]));
    greatest = std::max(greatest, sum);
  }
  return std::sqrt(greatest) * (1 + 0x1p-40);
}

/// The binary exponent of the greatest entry.
int exponent_of(const glm::dmat3& m) {
  double greatest = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) greatest = std::max(greatest, std::abs(m[i][j]));
  int exponent = 0;
  std::frexp(greatest, &exponent);
  return exponent;
}

glm::dmat3 scaled(const glm::dmat3& m, int exponent) {
  glm::dmat3 by = m;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) by[i][j] = std::ldexp(m[i][j], exponent);
  return by;
}

}  // namespace

// With entries of at most 1 no product overflows, and none that counts underflows.
Placement::Placement(const model::Mapa& mapa)
    : linear_(rounded(mapa.x), rounded(mapa.y), rounded(mapa.z)), centro_(rounded(mapa.centro)) {
  const int exponent = exponent_of(linear_);
  const glm::dmat3 near_one = scaled(linear_, -exponent), back = glm::inverse(near_one);
  inverse_ = scaled(back, -exponent);
  most_ = std::ldexp(greatest_stretch(near_one), exponent);
  least_ = std::ldexp(1 / greatest_stretch(glm::transpose(back)), exponent);
  is_identity_ = model::identidad(mapa);
}

glm::dvec3 Placement::normal(const glm::dvec3& n) const {
  if (is_identity_) return n;
  const int exponent = exponent_of(inverse_);
  return glm::normalize(glm::transpose(scaled(inverse_, -exponent)) * n);
}

// A coordinate is three products and three sums of rounded numbers.
double Placement::rounding(double from_origin) const noexcept {
  return is_identity_ ? 0 : 0x1p-48 * (glm::length(centro_) + most_ * from_origin);
}

}  // namespace durero::oracle
