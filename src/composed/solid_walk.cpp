#include "composed/solid_walk.hpp"

#include <algorithm>
#include <cmath>

namespace durero::composed {
namespace {

surface::exact::Coefficients coefficients(const SolidFace& face, bool starts_on, const model::Rayo& rayo) {
  auto [A, B, C] = face.form().along(rayo);
  return {std::move(A), std::move(B), starts_on ? Dyadic() : std::move(C)};
}

/// The sign of A·t² + 2B·t + C for small t > 0.
template <class Sign>
Sign first_sign(Sign A, Sign B, Sign C) {
  return C != 0 ? C : B != 0 ? B : A;
}

/// A number of about 50 bits, which is 0 only where it is exactly that.
struct RoughNumber {
  RealBall ball;

  bool is_zero() const { return ball.middle == 0 && ball.radius == 0; }
  /// Nothing where the bits do not decide.
  std::optional<int> sign() const {
    const int decided = ball.decided_sign();
    return decided != 0 || is_zero() ? std::optional(decided) : std::nullopt;
  }
};

/// A root of a face, in about 50 bits.
struct QuickRoot {
  double t;  // about
  RealBall ball;
  std::size_t face;
  bool is_upper;
};

/// The faces along a ray as far as 50 bits tell.
class QuickFaces {
 public:
  QuickFaces(std::span<const SolidFace> faces, const model::Rayo& rayo, const Starts& starts) : sides_(faces.size()) {
    for (std::size_t i = 0; i < faces.size() && is_decided_; ++i) {
      const auto [A, B, C] = faces[i].rough().along(rayo);
      take(i, {A}, {B}, starts[i] != 0 ? RoughNumber{RealBall(0.0)} : RoughNumber{C});
    }
    std::ranges::sort(roots_, {}, &QuickRoot::t);
  }

  std::optional<QuickFirst> first(const SideTree& tree) {
    if (!is_decided_ || tree.place(sides_) == SolidPlace::surface) return std::nullopt;
    for (std::size_t i = 0; i < roots_.size(); ++i) {
      const QuickRoot& root = roots_[i];
      const auto is_later = [&](const QuickRoot& other) { return (other.ball - root.ball).decided_sign() > 0; };
      if (!std::all_of(roots_.begin() + static_cast<std::ptrdiff_t>(i) + 1, roots_.end(), is_later))
        return std::nullopt;
      const auto before = sides_[root.face];
      sides_[root.face] = 0;
      if (tree.place(sides_) == SolidPlace::surface) return QuickFirst{true, root.face, root.is_upper};
      sides_[root.face] = static_cast<std::int8_t>(-before);
    }
    return QuickFirst{false, 0, false};
  }

 private:
  void take(std::size_t face, const RoughNumber& A, const RoughNumber& B, const RoughNumber& C) {
    const std::optional<int> a = A.sign(), b = B.sign(), c = C.sign();
    const bool needs_b = c == 0 || a == 0;
    is_decided_ = a && c && (b || !needs_b);
    if (!is_decided_) return;
    sides_[face] = static_cast<std::int8_t>(first_sign(*a, b.value_or(0), *c));
    if (*a == 0 && *b == 0) return;
    if (*a == 0) return linear(face, B, C);
    if (*c == 0) return from_zero(face, A, B);
    return quadratic(face, *a, A, B, C);
  }

  void linear(std::size_t face, const RoughNumber& B, const RoughNumber& C) {
    if (!C.is_zero()) add(face, -C.ball / (B.ball + B.ball), false);
  }

  void from_zero(std::size_t face, const RoughNumber& A, const RoughNumber& B) {
    if (!B.is_zero()) add(face, -(B.ball + B.ball) / A.ball, true);
  }

  void quadratic(std::size_t face, int a, const RoughNumber& A, const RoughNumber& B, const RoughNumber& C) {
    const RealBall D = B.ball * B.ball - A.ball * C.ball;
    const int d = D.decided_sign();
    is_decided_ = d != 0;
    if (d <= 0) return;
    const RealBall root = sqrt(D);
    const RealBall minus = (-B.ball - root) / A.ball, plus = (-B.ball + root) / A.ball;
    add(face, a > 0 ? minus : plus, false);
    add(face, a > 0 ? plus : minus, true);
  }

  void add(std::size_t face, const RealBall& t, bool is_upper) {
    const int sign = t.decided_sign();
    const double about = std::ldexp(t.middle, static_cast<int>(std::clamp<std::int64_t>(t.exponent, -4000, 4000)));
    is_decided_ = is_decided_ && sign != 0 && std::isfinite(about) && about != 0;
    if (is_decided_ && sign > 0) roots_.push_back({about, t, face, is_upper});
  }

  bool is_decided_ = true;
  std::vector<std::int8_t> sides_;
  std::vector<QuickRoot> roots_;
};

}  // namespace

FacesAlong faces_along(std::span<const SolidFace> faces, const model::Rayo& rayo, const Starts& starts) {
  FacesAlong along;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const surface::exact::Coefficients f = coefficients(faces[i], starts[i] != 0, rayo);
    along.sides.push_back(static_cast<std::int8_t>(first_sign(sign(f.A), sign(f.B), sign(f.C))));
    const surface::exact::Roots roots = surface::exact::roots(f);
    if (roots.every) continue;
    const bool turns = roots.count == 2 || sign(f.A) == 0;
    for (const Parameter& t : roots.values())
      if (number::sign(t) > 0) along.crossings.push_back({t, i, turns});
  }
  std::ranges::stable_sort(along.crossings, [](const FaceCrossing& a, const FaceCrossing& b) { return a.t < b.t; });
  return along;
}

std::optional<QuickFirst> quick_first(std::span<const SolidFace> faces, const SideTree& tree, const model::Rayo& rayo,
                                      const Starts& starts) {
  return QuickFaces(faces, rayo, starts).first(tree);
}

Parameter parameter(const SolidFace& face, bool starts_on, bool is_upper, const model::Rayo& rayo) {
  const surface::exact::Roots roots = surface::exact::roots(coefficients(face, starts_on, rayo));
  const auto values = roots.values();
  if (starts_on) return *std::ranges::find_if(values, [](const Parameter& t) { return number::sign(t) > 0; });
  return is_upper ? values.back() : values.front();
}

}  // namespace durero::composed
