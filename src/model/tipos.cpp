#include "durero/model/tipos.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "durero/number/rational.hpp"

namespace durero::model {
namespace {

using number::exact;
using number::Rational;

Rational squared_length(const Vector& d) {
  const Rational x = exact(d.x()), y = exact(d.y()), z = exact(d.z());
  return x * x + y * y + z * z;
}

}  // namespace

void detail::refuse(const char* type, const glm::dvec3& xyz) {
  throw std::domain_error(fmt::format("{} ({}, {}, {}): a component is no real number", type, xyz.x, xyz.y, xyz.z));
}

Rmas::Rmas(double value) : value_(value) {
  contract::require(Rmas_inv_1, contains(value), [&] { return fmt::format("r = {}", value); });
}

bool Rmas::contains(double value) noexcept { return value > 0 && std::isfinite(value); }

Unitario::Unitario(const Vector& d) : d_(d) {
  contract::require(Unitario_inv_1, contains(d), [&] { return fmt::format("d = ({}, {}, {})", d.x(), d.y(), d.z()); });
}

bool Unitario::contains(const Vector& d) {
  // Triage. The three squares and two sums each err by a relative u = 2⁻⁵³ at most, so n errs by less than 3.1·u·n,
  // and 2⁻¹⁰⁷⁰ more where a square underflows. For n near 1 that is less than 4u = 2⁻⁵¹; far above 1 the decision is
  // as clear as n − 1 is large. The subtraction of 1 is exact wherever 1/2 ≤ n ≤ 2 (Sterbenz).
  constexpr double error = 0x1p-51;
  const double n = d.x() * d.x() + d.y() * d.y() + d.z() * d.z();
  const double off = std::abs(n - 1);
  if (off <= tolerancia_unidad - error) return true;
  if (off > tolerancia_unidad + error) return false;
  // Exact.
  const Rational squared = squared_length(d), tolerance = exact(tolerancia_unidad);
  return 1 - tolerance <= squared && squared <= 1 + tolerance;
}

Vertices::Vertices(const Terna& v) : v_(v) { contract::require(Vertices_inv_1, contains(v)); }

bool Vertices::contains(const Terna& v) {
  const auto coordinate = [](const Punto& p, int axis) { return p.xyz()[axis]; };
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    // Triage. Each difference errs by a relative u = 2⁻⁵³ at most, each product so by 3.1u, and the difference of the
    // two by u more: in all less than 5u of the sum of their sizes, and less than 2⁻¹⁰⁷⁰ where something underflows.
    // Where something overflows nothing is decided: ∞ and NaN are not greater than ∞ or NaN.
    const double by = coordinate(v.b, j) - coordinate(v.a, j), bz = coordinate(v.b, k) - coordinate(v.a, k);
    const double cy = coordinate(v.c, j) - coordinate(v.a, j), cz = coordinate(v.c, k) - coordinate(v.a, k);
    const double forward = by * cz, backward = bz * cy;
    if (std::abs(forward - backward) > 0x1p-50 * (std::abs(forward) + std::abs(backward)) + 0x1p-1060) return true;
  }
  // Exact.
  const auto difference = [&](const Punto& p, int axis) {
    return Rational(exact(coordinate(p, axis)) - exact(coordinate(v.a, axis)));
  };
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    if (difference(v.b, j) * difference(v.c, k) != difference(v.b, k) * difference(v.c, j)) return true;
  }
  return false;
}

Elemento::Elemento(std::string name) : name_(std::move(name)) {
  if (!is_name(name_)) throw std::invalid_argument("an element's name is 1 to 128 of A-Z a-z 0-9 _ . : -");
}

bool Elemento::is_name(std::string_view text) noexcept {
  constexpr auto allowed = [](char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '.' ||
           c == ':' || c == '-';
  };
  return !text.empty() && text.size() <= 128 && std::all_of(text.begin(), text.end(), allowed);
}

}  // namespace durero::model
