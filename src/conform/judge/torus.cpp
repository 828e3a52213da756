#include "conform/judge/torus.hpp"

#include "durero/algebra/value.hpp"

namespace durero::conform {
namespace {

using algebra::Polynomial;

Point<Dyadic> exact_of(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

/// Bounds on a root are apart by less than 2 to the power −bits of it.
constexpr std::int64_t bits = 400;

/// The square of a + b·t + c·t².
Polynomial squared(const Dyadic& a, const Dyadic& b, const Dyadic& c) {
  return {a * a, number::shifted(a * b, 1), b * b + number::shifted(a * c, 1), number::shifted(b * c, 1), c * c};
}

/// The root itself, or the middle between its bounds.
surface::exact::Parameter middle_of(const algebra::Root& root) {
  if (const auto* const surd = std::get_if<number::DyadicSurd>(&root)) return *surd;
  const auto& isolated = std::get<algebra::Isolated>(root);
  return {.x = number::shifted(isolated.low + isolated.high, -1)};
}

}  // namespace

Torus::Torus(const AskedBody& body)
    : centro_(exact_of(body.centro)),
      n_(cross(exact_of(body.sides[2]), exact_of(body.sides[0]))),
      nn_(squared_length(n_)),
      squared_(squared_length(exact_of(body.sides[0]))),
      radio_(body.radio) {}

bool Torus::is_tube(const Dyadic& rho) const { return number::sign(rho) > 0 && square(rho) <= squared_; }

Dyadic Torus::at(const Point<Dyadic>& w, const Dyadic& rho) const {
  const Point<Dyadic> q{w.x - centro_.x, w.y - centro_.y, w.z - centro_.z};
  const Dyadic qq = squared_length(q), along_n = dot(q, n_);
  return nn_ * square(qq + squared_ - square(rho)) - number::shifted(squared_ * (nn_ * qq - square(along_n)), 2);
}

Polynomial Torus::along(const model::Rayo& rayo, const Dyadic& rho) const {
  const Point<Dyadic> p = exact_of(rayo.p().xyz()), v = exact_of(rayo.v().xyz());
  const Point<Dyadic> q{p.x - centro_.x, p.y - centro_.y, p.z - centro_.z};
  const Dyadic qq = squared_length(q), qv = dot(q, v), vv = squared_length(v), qn = dot(q, n_), vn = dot(v, n_);
  Polynomial f = squared(qq + squared_ - square(rho), number::shifted(qv, 1), vv);
  for (Dyadic& coefficient : f) coefficient *= nn_;
  f[0] -= number::shifted(squared_ * (nn_ * qq - square(qn)), 2);
  f[1] -= number::shifted(squared_ * (nn_ * qv - qn * vn), 3);
  f[2] -= number::shifted(squared_ * (nn_ * vv - square(vn)), 2);
  return f;
}

std::vector<TubeRoot> tube_roots(const Polynomial& of) {
  Polynomial slope;
  for (std::size_t i = 1; i < of.size(); ++i) slope.push_back(Dyadic(static_cast<double>(i)) * of[i]);
  algebra::normalise(slope);
  std::vector<TubeRoot> all;
  for (const algebra::Root& root : algebra::positive_roots(of)) {
    const bool is_touched = algebra::sign_at(slope, root) == 0;
    algebra::Root fine = algebra::refined(root, bits);
    if (const auto* const surd = std::get_if<number::DyadicSurd>(&fine)) {
      all.push_back({fine, *surd, *surd, is_touched});
    } else {
      const auto& [polynomial, low, high, sign] = std::get<algebra::Isolated>(fine);
      const surface::exact::Parameter below{.x = low}, above{.x = high};
      all.push_back({std::move(fine), below, above, is_touched});
    }
  }
  return all;
}

surface::exact::Parameter crossing_at(const TubeRoot& root) { return middle_of(root.root); }

surface::exact::Parameter crossing_at(const algebra::Root& root) { return middle_of(algebra::refined(root, bits)); }

}  // namespace durero::conform
