#include "durero/surface/equation.hpp"

#include "durero/number/rational.hpp"
#include "durero/surface/surfaces.hpp"
#include "support/catch.hpp"
#include "support/elements.hpp"
#include "support/property.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;
using number::exact;
using number::Rational;
using surface::Point;

namespace {

Point<Rational> at(const model::Rayo& ray, const Rational& t) {
  const auto coordinate = [&](double p, double v) { return Rational(exact(p) + t * exact(v)); };
  return {coordinate(ray.p().x(), ray.v().x()), coordinate(ray.p().y(), ray.v().y()),
          coordinate(ray.p().z(), ray.v().z())};
}

/// For a shape at random, and a ray.
template <class Holds>
void for_shapes(const char* what, Holds holds) {
  property(what, [&] {
    const model::Rayo ray = *rays(moderate());
    holds(*spheres(moderate()), ray);
    holds(*cylinders(moderate()), ray);
    holds(*cones(moderate()), ray);
    holds(*truncated_cones(moderate()), ray);
  });
}

}  // namespace

TEST_CASE("along a ray, potencia is the quadratic whose coefficients the equation over Linear gives") {
  for_shapes("potencia(p + t·v) = A·t² + 2B·t + C", [](const auto& shape, const model::Rayo& ray) {
    const auto [A, B, C] = potencia(shape, surface::along<Rational>(ray));
    const Rational t = exact(*moderate());
    RC_ASSERT(potencia(shape, at(ray, t)) == Rational(A * t * t + 2 * B * t + C));
    if constexpr (surface::Axial<std::decay_t<decltype(shape)>>) {
      const auto s = avance(shape, surface::along<Rational>(ray));
      RC_ASSERT(avance(shape, at(ray, t)) == Rational(s.at_zero + t * s.slope));
    }
  });
}

TEST_CASE("over dual numbers the equation gives the gradient: of a quadratic, the central difference of any step") {
  for_shapes("2h·∂potencia = potencia(w + h·e) − potencia(w − h·e)", [](const auto& shape, const model::Rayo& ray) {
    using Dual = surface::Dual<Rational>;
    const Point<Rational> w = at(ray, 0);
    const Dual power = potencia(shape, Point<Dual>{{w.x, 1, 0, 0}, {w.y, 0, 1, 0}, {w.z, 0, 0, 1}});
    RC_ASSERT(power.value == potencia(shape, w));
    const Rational h = 3;
    const auto at_step = [&](int x, int y, int z) {
      return potencia(shape, Point<Rational>{w.x + x * h, w.y + y * h, w.z + z * h});
    };
    RC_ASSERT(Rational(2 * h * power.dx) == Rational(at_step(1, 0, 0) - at_step(-1, 0, 0)));
    RC_ASSERT(Rational(2 * h * power.dy) == Rational(at_step(0, 1, 0) - at_step(0, -1, 0)));
    RC_ASSERT(Rational(2 * h * power.dz) == Rational(at_step(0, 0, 1) - at_step(0, 0, -1)));
  });
}
