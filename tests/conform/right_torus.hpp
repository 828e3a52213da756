#pragma once
/// The crossings of a ray with a torus, a second time: its polynomial from five values, each by the square of what is
/// left when the point's distances are put together, and its roots by algebra.

#include <vector>

#include "durero/algebra/value.hpp"
#include "durero/conform/families/asked_body.hpp"
#include "durero/surface/exact_element.hpp"

namespace durero::test {

/// The points within `radio` of the circle around the middle: with the distance² from the middle A, and the way² out of
/// the plane B, √(A − B) is R ± √(radio² − B), and so (A + R² − radio²)² = 4R²·(A − B). By the square of x for R², and
/// by z × x for the plane.
inline number::Dyadic torus_power(const conform::AskedBody& body, const std::array<number::Dyadic, 3>& w) {
  using number::Dyadic;
  using Row = std::array<Dyadic, 3>;
  const auto row = [](const glm::dvec3& v) { return Row{Dyadic(v.x), Dyadic(v.y), Dyadic(v.z)}; };
  const auto product = [](const Row& a, const Row& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  const Row x = row(body.sides[0]), z = row(body.sides[2]), c = row(body.centro);
  const Row n{x[1] * z[2] - x[2] * z[1], x[2] * z[0] - x[0] * z[2], x[0] * z[1] - x[1] * z[0]};
  const Row q{w[0] - c[0], w[1] - c[1], w[2] - c[2]};
  const Dyadic A = product(q, q), out = product(q, n), nn = product(n, n), R = product(x, x);
  const Dyadic sum = A + R - number::square(Dyadic(body.radio));
  return sum * sum * nn - Dyadic(4) * R * (A * nn - out * out);
}

/// 24 times the polynomial through the values at t = −2, −1, 0, 1 and 2.
inline algebra::Polynomial torus_polynomial(const conform::AskedBody& body, const model::Rayo& rayo) {
  using number::Dyadic;
  const glm::dvec3 &p = rayo.p().xyz(), &v = rayo.v().xyz();
  const auto at = [&](int t) {
    std::array<Dyadic, 3> w;
    for (int i = 0; i < 3; ++i) w[static_cast<std::size_t>(i)] = Dyadic(p[i]) + Dyadic(t) * Dyadic(v[i]);
    return torus_power(body, w);
  };
  const Dyadic e = at(0), odd1 = at(1) - at(-1), odd2 = at(2) - at(-2), even1 = at(1) + at(-1) - Dyadic(2) * e,
               even2 = at(2) + at(-2) - Dyadic(2) * e;
  // f(±1) = e ± b + c ± d + a·1, f(±2) = e ± 2b + 4c ± 8d + 16a
  const Dyadic a = even2 - Dyadic(4) * even1, c = Dyadic(16) * even1 - even2, d = Dyadic(2) * (odd2 - Dyadic(2) * odd1),
               b = Dyadic(2) * (Dyadic(8) * odd1 - odd2);
  return {Dyadic(24) * e, b, c, d, a};
}

/// Every crossing at t > 0, to 300 digits where it is no root of a quadratic.
inline std::vector<surface::exact::Parameter> torus_crossings(const conform::AskedBody& body, const model::Rayo& rayo) {
  std::vector<surface::exact::Parameter> all;
  for (algebra::Root& root : algebra::positive_roots(torus_polynomial(body, rayo))) {
    const algebra::Root fine = algebra::refined(std::move(root), 1000);
    const auto* const surd = std::get_if<number::DyadicSurd>(&fine);
    all.push_back(surd ? *surd : surface::exact::Parameter{.x = std::get<algebra::Isolated>(fine).low});
  }
  return all;
}

}  // namespace durero::test
