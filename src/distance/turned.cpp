#include "turned.hpp"

#include <optional>

namespace durero::distance::exact {
namespace {

/// The polynomial a·b.
Polynomial product(const Polynomial& a, const Polynomial& b) {
  if (a.empty() || b.empty()) return {};
  Polynomial all(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) all[i + j] += a[i] * b[j];
  return all;
}

Polynomial operator*(const Dyadic& number, Polynomial p) {
  for (Dyadic& each : p) each *= number;
  return p;
}

Polynomial operator+(Polynomial a, const Polynomial& b) {
  a.resize(std::max(a.size(), b.size()));
  for (std::size_t i = 0; i < b.size(); ++i) a[i] += b[i];
  return a;
}

Polynomial operator-(const Polynomial& a, const Polynomial& b) { return a + Dyadic(-1) * b; }

Polynomial normal(Polynomial p) {
  algebra::normalise(p);
  return p;
}

Dyadic at(const Polynomial& p, const Dyadic& s) {
  Dyadic sum;
  for (std::size_t i = p.size(); i-- > 0;) sum = sum * s + p[i];
  return sum;
}

/// A direction across the axis that leads to the least x; to the least y where all points of a ring have one x. It is
/// −dd times the part of a unit vector of space across the axis.
struct Across {
  Triple direction;
  Dyadic squared;  ///< dd times dd − dⱼ², the square of its length
};
Across across(const AxialPoint& seen) {
  const std::size_t j = sign(seen.dd - square(seen.d[0])) > 0 ? 0 : 1;
  Across found{{}, seen.dd - square(seen.d[j])};
  for (std::size_t i = 0; i < 3; ++i) found.direction[i] = seen.d[i] * seen.d[j] - (i == j ? seen.dd : Dyadic());
  return found;
}

/// The nearest point of a ring about the point's own place on the axis, all of which is as near: at the advance n/m,
/// with m > 0, and with the squared radius H/m² over dd.
Nearest of_ring_around(const AxialPoint& seen, const Dyadic& n, const Dyadic& m, const Dyadic& H) {
  const auto [direction, less] = across(seen);
  Nearest found{.squared = DyadicSurd{.x = H + square(seen.s * m - n), .w = seen.dd * square(m)},
                .point = {},
                .many = sign(H) > 0};
  for (std::size_t i = 0; i < 3; ++i)
    found.point[i] =
        DyadicSurd{(seen.centro[i] * seen.dd * m + n * seen.d[i]) * less, direction[i], H * less, less * m * seen.dd};
  return found;
}

/// A search over the rings of a profile: the candidates are the ends, where the squared distance is stationary, and the
/// points on the axis. Each is a point of the shape, and the nearest point is one of them.
class RingSearch {
 public:
  RingSearch(const AxialPoint& seen, const RingProfile& profile) : seen_(seen), profile_(profile) {
    const auto& [a, k, altura] = profile;
    const Polynomial radius{a, -k};
    H_ = normal(seen.dd * product(radius, radius) - product({0, 1 - seen.dd}, {0, 1 - seen.dd}));
    H_.resize(3);
    U_ = {shifted(H_[1], -1), H_[2]};
    V_ = U_ + Polynomial{-seen.s, 1};
  }

  Nearest nearest() {
    take_ring({});
    take_ring(profile_.altura);
    if (sign(seen_.squared_out) == 0) {
      take_vertex();
      take_points_of_axis();
    } else if (seen_.dd == Dyadic(1)) {
      take_foot();
    } else {
      take_stationary();
    }
    return std::move(*found_);
  }

 private:
  void take(Nearest other) {
    if (found_) return exact::take(*found_, std::move(other));
    found_ = std::move(other);
  }

  void take_ring(const Dyadic& s) {
    Dyadic H = at(H_, s);
    if (sign(H) >= 0) take(of_ring(seen_, s, H));
  }

  bool is_between(const algebra::Root& s) const { return algebra::compare(s, DyadicSurd{profile_.altura}) < 0; }

  /// The point lies on the axis: dd times the squared distance is H + (s_p − s)², which is stationary at a rational s.
  void take_vertex() {
    Dyadic n = -V_[0], m = V_[1];
    if (sign(m) < 0) n = -n, m = -m;
    if (sign(m) == 0 || sign(n) <= 0 || n >= profile_.altura * m) return;
    const Dyadic H = (H_[0] * m + H_[1] * n) * m + H_[2] * square(n);
    if (sign(H) >= 0) take(of_ring_around(seen_, n, m, H));
  }

  /// The shape ends on the axis, or crosses it, where H is 0.
  void take_points_of_axis() {
    const Polynomial H = normal(H_), away{-seen_.s, 1};
    for (algebra::Root& s : algebra::positive_roots(H))
      if (is_between(s)) take(at_root(H, std::move(s), product(away, away), {}, {1}));
  }

  /// dd = 1: the profile is a line. Of all its points the foot has ρ as near to a − k·s as can be, with ρ² =
  /// squared_out.
  void take_foot() {
    const auto& [a, k, altura] = profile_;
    const Dyadic w = 1 + square(k), &P = seen_.squared_out, n = seen_.s + k * a, beyond = k * seen_.s - a;
    const DyadicSurd s{n, -k, P, w};
    if (number::sign(s) <= 0 || s >= DyadicSurd{altura}) return;
    Nearest foot{.squared = DyadicSurd{P + square(beyond), shifted(beyond, 1), P, w}, .point = {}};
    for (std::size_t i = 0; i < 3; ++i)  // centro + s·d + ((a − k·s)/ρ)·e, over w·P
      foot.point[i] = DyadicSurd{P * (seen_.centro[i] * w + n * seen_.d[i] + square(k) * seen_.out[i]),
                                 (a * w - k * n) * seen_.out[i] - k * P * seen_.d[i], P, w * P};
    take(std::move(foot));
  }

  /// With P = squared_out, half the derivative of dd times the squared distance is V − U·√(P/H). Where that is 0 the
  /// squares are too: V²H = PU²; and √(H/P), the radius over that of the point, is U/V, so that U and V have one sign.
  /// Both are linear in s. Where they have their root in common it is s_p, and U/V is a number.
  void take_stationary() {
    const Dyadic& P = seen_.squared_out;
    if (sign(at(U_, seen_.s)) != 0) return take_roots(U_, V_);
    if (sign(seen_.s) > 0 && seen_.s < profile_.altura) take_ring(seen_.s);
    if (sign(U_[1]) * sign(V_[1]) > 0 && sign(P) > 0) take_roots({U_[1]}, {V_[1]});
  }

  void take_roots(const Polynomial& U, const Polynomial& V) {
    const Dyadic& P = seen_.squared_out;
    const Polynomial of = normal(product(product(V, V), H_) - P * product(U, U)), away{-seen_.s, 1};
    if (of.empty()) return;
    for (algebra::Root& s : algebra::positive_roots(of)) {
      if (!is_between(s) || algebra::sign_at(normal(U), s) * algebra::sign_at(normal(V), s) <= 0) continue;
      const Polynomial squared = product(H_ + product(away, away) + Polynomial{P}, V) - shifted(P, 1) * U;
      take(at_root(of, std::move(s), squared, U, V));
    }
  }

  /// The candidate at a root s, with the squared distance N/(dd·V) and the point centro + (s/dd)·d + (U/V)·e.
  Nearest at_root(const Polynomial& of, algebra::Root s, const Polynomial& N, const Polynomial& U,
                  const Polynomial& V) const {
    constexpr std::int64_t bits = 200;  // which mostly decide
    const algebra::Root fine = algebra::refined(std::move(s), bits);
    const Polynomial denominator = normal(seen_.dd * V);
    Nearest found{.squared = algebra::Fraction{normal(N), denominator, of, fine}, .point = {}};
    for (std::size_t i = 0; i < 3; ++i)
      found.point[i] = algebra::Fraction{
          normal(product({seen_.centro[i] * seen_.dd, seen_.d[i]}, V) + seen_.out[i] * U), denominator, of, fine};
    return found;
  }

  const AxialPoint& seen_;
  const RingProfile& profile_;
  Polynomial H_, U_, V_;  ///< U is half of H′, and V is U − (s_p − s)
  std::optional<Nearest> found_;
};

}  // namespace

AxialPoint::AxialPoint(const glm::dvec3& at, const glm::dvec3& vector, const glm::dvec3& p)
    : centro(triple(at)), d(triple(vector)), dd(dot(d, d)) {
  const Triple q = difference(triple(p), centro);
  s = dot(q, d);
  for (std::size_t i = 0; i < 3; ++i) out[i] = dd * q[i] - s * d[i];
  squared_out = dd * dot(q, q) - square(s);
}

Nearest of_ring(const AxialPoint& seen, const Dyadic& s, const Dyadic& H) {
  const Dyadic& P = seen.squared_out;
  if (sign(P) == 0) return of_ring_around(seen, s, 1, H);
  Nearest found{.squared = DyadicSurd{P + H + square(seen.s - s), -2, P * H, seen.dd}, .point = {}};
  for (std::size_t i = 0; i < 3; ++i)
    found.point[i] = DyadicSurd{(seen.centro[i] * seen.dd + s * seen.d[i]) * P, seen.out[i], H * P, seen.dd * P};
  return found;
}

Nearest of_profile(const AxialPoint& seen, const RingProfile& profile) { return RingSearch(seen, profile).nearest(); }

}  // namespace durero::distance::exact
