#include "durero/composed/form.hpp"

#include <utility>

namespace durero::composed {
namespace {

/// The coefficient of row i, where `one` is row 3.
const Rational& coefficient(const LinearForm& a, std::size_t i) {
  return i == 0 ? a.x : i == 1 ? a.y : i == 2 ? a.z : a.one;
}

}  // namespace

QuadraticForm::QuadraticForm(const LinearForm& linear) {
  for (std::size_t i = 0; i < 3; ++i) m[matrix_place(i, 3)] = coefficient(linear, i) / 2;
  m[matrix_place(3, 3)] = linear.one;
}

QuadraticForm square(const LinearForm& a) {
  QuadraticForm result;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i; j < 4; ++j) result.m[matrix_place(i, j)] = coefficient(a, i) * coefficient(a, j);
  return result;
}

SpaceForm<Dyadic> whole(const QuadraticForm& form) {
  number::Integer common = 1;
  for (const Rational& each : form.m) common = lcm(common, denominator(each));
  std::array<Dyadic, matrix_places> m;
  for (std::size_t i = 0; i < matrix_places; ++i)
    m[i] = Dyadic(number::Integer(numerator(form.m[i]) * (common / denominator(form.m[i]))), 0);
  return SpaceForm<Dyadic>(std::move(m));
}

SpaceForm<RealBall> roughly(const SpaceForm<Dyadic>& form) {
  const auto& m = form.coefficients();
  return [&]<std::size_t... i>(std::index_sequence<i...>) {
    return SpaceForm<RealBall>({RealBall(m[i])...});
  }(std::make_index_sequence<matrix_places>());
}

// With t = (x + y√δ)/w the value times w² is A(x² + y²δ) + 2Bxw + Cw² + (2Axy + 2Byw)√δ.
int sign_at(const surface::Quadratic<Dyadic>& f, const number::DyadicSurd& t) {
  const Dyadic xx_yy = number::square(t.x) + number::square(t.y) * t.delta;
  const Dyadic rational = f.A * xx_yy + number::shifted(f.B * t.x * t.w, 1) + f.C * number::square(t.w);
  const Dyadic root = number::shifted(t.y * (f.A * t.x + f.B * t.w), 1);
  return number::sign(number::DyadicSurd{rational, root, t.delta});
}

}  // namespace durero::composed
