#include "durero/surface/shape/triangle.hpp"

#include "durero/number/rational.hpp"
#include "durero/scene/addition.hpp"
#include "durero/surface/normal.hpp"
#include "support/catch.hpp"
#include "support/elements.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::test;
using surface::Point;

namespace {

constexpr scene::Triangle triangle{{{{1, 2, 3}, {5, 2, 3}, {1, 4, 3}}}};

}  // namespace

TEST_CASE("the power of a point is the volume over the edges of a triangle") {
  CHECK(potencia(triangle, Point<double>{1, 2, 3}) == 0);
  CHECK(potencia(triangle, Point<double>{-100, 50, 3}) == 0);
  CHECK(potencia(triangle, Point<double>{0, 0, 5}) == 16);
  CHECK(potencia(triangle, Point<double>{0, 0, 1}) == -16);
}

TEST_CASE("along a ray the power of a triangle is linear") {
  const surface::Linear<double> power = potencia(triangle, surface::along<double>(model::Rayo({0, 0, 0}, {5, 7, 2})));
  CHECK(power.at_zero == -24);
  CHECK(power.slope == 16);
}

TEST_CASE("a triangle faces where its vertices are seen to turn to the left") {
  scene::Scene scene;
  scene.apply(scene::addition(model::Elemento("t"), triangle));
  CHECK(surface::normal(scene, {model::Tipo::soy_triangulo, 0}, {2, 2.5, 3}) == glm::dvec3(0, 0, 1));
}

TEST_CASE("the box of its vertices contains a triangle, and a ball about its middle") {
  const surface::Box box = surface::box(triangle);
  CHECK(box.low == glm::dvec3(1, 2, 3));
  CHECK(box.high == glm::dvec3(5, 4, 3));
  CHECK(surface::ball(triangle).centre == glm::dvec3(3, 3, 3));
  CHECK(surface::ball(triangle).radius >= std::sqrt(5));
  CHECK(surface::ball(triangle).radius < std::sqrt(5) * (1 + 0x1p-40));
  property("every vertex, exactly", [] {
    const scene::Triangle any = *triangles(moderate());
    const surface::Ball ball = surface::ball(any);
    const auto apart = [](double a, double b) { return number::Rational(number::exact(a) - number::exact(b)); };
    for (const glm::dvec3& vertex : any.vertices) {
      const auto x = apart(vertex.x, ball.centre.x), y = apart(vertex.y, ball.centre.y),
                 z = apart(vertex.z, ball.centre.z);
      RC_ASSERT(x * x + y * y + z * z <= number::exact(ball.radius) * number::exact(ball.radius));
    }
  });
}
