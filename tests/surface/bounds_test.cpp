#include "durero/surface/bounds.hpp"

#include <boost/multiprecision/cpp_dec_float.hpp>

#include "durero/surface/surfaces.hpp"
#include "support/catch.hpp"
#include "support/elements.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::test;

namespace {

/// Fifty digits: what they lose is far below the slack of any bound.
using Wide = boost::multiprecision::cpp_dec_float_50;

struct Place {
  Wide x, y, z;
};

Place operator+(const Place& a, const Place& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Place operator*(const Wide& k, const Place& a) { return {k * a.x, k * a.y, k * a.z}; }
Wide dot(const Place& a, const Place& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Place cross(const Place& a, const Place& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Place unit(const Place& a) { return Wide(1 / sqrt(dot(a, a))) * a; }
Place wide(const glm::dvec3& a) { return {a.x, a.y, a.z}; }

/// A point of the surface by two parameters in [0, 1].
Place point_of(const scene::Sphere& e, double u, double v) {
  const Wide turn = 6.28318530717958647692 * u, z = 2 * Wide(v) - 1, across = sqrt(1 - z * z);
  return wide(e.centro) + Wide(e.radio) * Place{across * cos(turn), across * sin(turn), z};
}

Wide radius_at(const scene::Cylinder& e, const Wide&) { return e.radio; }
Wide radius_at(const scene::Cone& e, const Wide& s) { return Wide(e.proporcion) * (Wide(e.altura) - s); }
Wide radius_at(const scene::TruncatedCone& e, const Wide& s) {
  return Wide(e.radio) + Wide(e.proporcion) * (Wide(e.altura) - s);
}

/// With the stored axis d and n = d·d, the point k·d + e, e across d, has the advance s = k·n, and is on the surface
/// where |e|² + (1 − n)²·k²·n is the square of the radius at s.
template <class Axial>
Place point_of(const Axial& shape, double u, double v) {
  const Place d = wide(shape.vector);
  const Wide n = dot(d, d), s = Wide(shape.altura) * v, k = s / n, turn = 6.28318530717958647692 * u;
  const Place a = unit(cross(d, abs(d.x) < 0.5 ? Place{1, 0, 0} : Place{0, 1, 0})), b = unit(cross(d, a));
  const Wide r = radius_at(shape, s), squared = r * r - (1 - n) * (1 - n) * k * k * n;
  const Wide across = squared > 0 ? Wide(sqrt(squared)) : Wide(0);
  return wide(shape.centro) + k * d + across * Place(cos(turn) * a + sin(turn) * b);
}

double unit_interval() {
  const double x = std::abs(*moderate());
  return x - std::floor(x);
}

template <class Shape>
void contained(const Shape& shape) {
  const surface::Ball ball = surface::ball(shape);
  const surface::Box box = surface::box(shape);
  Place low = point_of(shape, 0, 0), high = low;
  Wide farthest = 0;
  for (const double u : {0.0, 0.25, 0.5, 0.75, unit_interval(), unit_interval(), unit_interval()}) {
    for (const double v : {0.0, 1.0, 0.5, unit_interval()}) {
      const Place w = point_of(shape, u, v), q = w + Wide(-1) * wide(ball.centre);
      farthest = std::max(farthest, Wide(sqrt(dot(q, q))));
      low = {std::min(low.x, w.x), std::min(low.y, w.y), std::min(low.z, w.z)};
      high = {std::max(high.x, w.x), std::max(high.y, w.y), std::max(high.z, w.z)};
    }
  }
  // A sphere's ball is the sphere itself: there the digits of this test are what is left over.
  RC_ASSERT(farthest <= Wide(ball.radius) * (1 + Wide(1e-40)));
  RC_ASSERT((low.x >= box.low.x && low.y >= box.low.y && low.z >= box.low.z));
  RC_ASSERT((high.x <= box.high.x && high.y <= box.high.y && high.z <= box.high.z));
}

}  // namespace

TEST_CASE("the ball and the box of a shape contain its points") {
  property("parametrised points", [] {
    contained(*spheres(moderate()));
    contained(*cylinders(moderate()));
    contained(*cones(moderate()));
    contained(*truncated_cones(moderate()));
  });
}

TEST_CASE("the ball of a short shape far away pays for the rounding of its centre") {
  // Half of its altura is 7/8 of half a unit in the last place of the centre, which is rounded to centro.
  property("the far end", [] { contained(scene::Cylinder{{0x1p20, 0, 0}, 0x1p-60, {1, 0, 0}, 0x1.cp-33}); });
}

TEST_CASE("the box of a shape along an axis of space fits it") {
  const surface::Box of_cylinder = surface::box(scene::Cylinder{{1, 2, 3}, 2, {0, 0, 1}, 5});
  CHECK(of_cylinder.low.x == Approx(-1));
  CHECK(of_cylinder.high.y == Approx(4));
  CHECK(of_cylinder.low.z == Approx(3).margin(1e-5));
  CHECK(of_cylinder.high.z == Approx(8).margin(1e-5));
  const surface::Box of_cone = surface::box(scene::Cone{{0, 0, 0}, 0.5, {0, -1, 0}, 2});
  CHECK(of_cone.low.y == Approx(-2));
  CHECK(of_cone.high.x == Approx(1));
}
