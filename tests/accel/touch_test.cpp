#include "durero/accel/touch.hpp"

#include <glm/geometric.hpp>
#include <map>
#include <numbers>

#include "durero/model/operaciones.hpp"
#include "durero/number/rational.hpp"
#include "durero/surface/surfaces.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"
#include "support/scenes.hpp"

using namespace durero;
using namespace durero::test;
using number::exact;
using number::Rational;
using surface::Box;

namespace {

/// A point of a shape, its numbers rounded: between the ends of an axis, on the wall, or within a disc or a triangle.
struct Point {
  Random& random;

  glm::dvec3 across(const glm::dvec3& d) const {
    const glm::dvec3 any = std::abs(d.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 u = normalize(cross(d, any)), w = cross(d, u);
    const double angle = random.uniform(0, 2 * std::numbers::pi);
    return std::cos(angle) * u + std::sin(angle) * w;
  }
  double share() const { return random.chance(1, 4) ? random.integer(0, 1) : random.uniform(0, 1); }

  glm::dvec3 operator()(const scene::Sphere& e) const { return e.centro + e.radio * random.direction(); }
  glm::dvec3 operator()(const scene::Disc& e) const { return e.centro + share() * e.radio * across(e.vector); }
  glm::dvec3 operator()(const scene::Triangle& e) const {
    const double b = share(), c = share() * (1 - b);
    return e.vertices[0] + b * (e.vertices[1] - e.vertices[0]) + c * (e.vertices[2] - e.vertices[0]);
  }
  glm::dvec3 operator()(const scene::Cylinder& e) const {
    return e.centro + share() * e.altura * e.vector + e.radio * across(e.vector);
  }
  glm::dvec3 operator()(const scene::Cone& e) const {
    const double at = share();
    return e.centro + at * e.altura * e.vector + (1 - at) * e.altura * e.proporcion * across(e.vector);
  }
  glm::dvec3 operator()(const scene::TruncatedCone& e) const {
    const double at = share();
    return e.centro + at * e.altura * e.vector + (e.radio + (1 - at) * e.altura * e.proporcion) * across(e.vector);
  }
  glm::dvec3 operator()(const scene::Plane& e) const { return e.centro + random.uniform(0, 1) * across(e.vector); }
};

bool holds(const Box& box, const glm::dvec3& w) {
  for (int i = 0; i < 3; ++i)
    if (w[i] < box.low[i] || box.high[i] < w[i]) return false;
  return true;
}

/// By fractions: the nearest and the farthest point of the box.
bool truly_touches(const scene::Sphere& e, const Box& box) {
  Rational nearest = 0, farthest = 0;
  for (int i = 0; i < 3; ++i) {
    const Rational low = exact(box.low[i]) - exact(e.centro[i]), high = exact(box.high[i]) - exact(e.centro[i]);
    const Rational near = low > 0 ? low : high < 0 ? high : Rational(0), far = -low > high ? low : high;
    nearest += near * near;
    farthest += far * far;
  }
  const Rational square = exact(e.radio) * exact(e.radio);
  return nearest <= square && square <= farthest;
}

/// By fractions: what is left of the triangle, cut along the six faces.
bool truly_touches(const scene::Triangle& e, const Box& box) {
  using Corner = std::array<Rational, 3>;
  std::vector<Corner> left;
  for (const glm::dvec3& w : e.vertices) left.push_back({exact(w.x), exact(w.y), exact(w.z)});
  for (std::size_t face = 0; face < 6; ++face) {
    const std::size_t axis = face / 2;
    const auto i = static_cast<int>(axis);
    const auto inside = [&](const Corner& w) {
      return Rational(face % 2 == 0 ? w[axis] - exact(box.low[i]) : exact(box.high[i]) - w[axis]);
    };
    std::vector<Corner> cut;
    for (std::size_t k = 0; k < left.size(); ++k) {
      const Corner &from = left[k], &to = left[(k + 1) % left.size()];
      const Rational a = inside(from), b = inside(to);
      if (a >= 0) cut.push_back(from);
      if (a * b < 0) {
        const Rational share = a / (a - b);
        cut.push_back({from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1]),
                       from[2] + share * (to[2] - from[2])});
      }
    }
    left = cut;
  }
  return !left.empty();
}

Box drawn_box(Random& random, const glm::dvec3& near) {
  const double size = random.any_of(std::array{0.02, 0.1, 0.5, 2.0});
  const glm::dvec3 low = near - size * (random.in_cube(1) + 1.0);
  return {low, low + size * (random.in_cube(0.5) + 1.0)};
}

}  // namespace

TEST_CASE("a box with a point of the surface is touched, also where the point is on its face, edge or corner") {
  Random random(1);
  for (std::size_t i = 0; i < fewer_when_sanitized(20000); ++i) {
    scene::Scene scene;
    scene.apply(random_addition(random, "e"));
    scene.for_each([&](scene::ElementRef, const auto& shape) {
      const glm::dvec3 w = Point{random}(shape);
      Box box{w, w};
      for (int axis = 0; axis < 3; ++axis) {
        const double size = random.any_of(std::array{0.01, 0.3, 3.0});
        if (random.chance(2, 3)) box.low[axis] -= size;
        if (random.chance(2, 3)) box.high[axis] += size;
      }
      INFO("box " << i << " of type " << static_cast<int>(shape.tipo));
      // The point was rounded: the box of a surface alone may end before it.
      if (holds(surface::box(shape), w)) REQUIRE(accel::touches(shape, box));
    });
  }
}

TEST_CASE("of spheres and triangles the cells are the true ones") {
  Random random(2);
  int touched = 0;
  for (std::size_t i = 0; i < fewer_when_sanitized(10000); ++i) {
    if (i % 2 == 0) {
      const scene::Sphere sphere{random.in_cube(1), random.uniform(0.1, 2)};
      const Box box = drawn_box(random, Point{random}(sphere));
      REQUIRE(accel::touches(sphere, box) == truly_touches(sphere, box));
      touched += accel::touches(sphere, box) ? 1 : 0;
    } else {
      const scene::Triangle triangle{{random.in_cube(1), random.in_cube(1), random.in_cube(1)}};
      const Box box = drawn_box(random, Point{random}(triangle));
      REQUIRE(accel::touches(triangle, box) == truly_touches(triangle, box));
      touched += accel::touches(triangle, box) ? 1 : 0;
    }
  }
  CHECK(touched > static_cast<int>(fewer_when_sanitized(2000)));
}

TEST_CASE("of the other shapes few cells are listed that hold no point") {
  Random random(3);
  std::map<model::Tipo, int> listed, without;
  while (listed.size() < 4 || std::ranges::any_of(listed, [](const auto& of) {
           return of.second < static_cast<int>(fewer_when_sanitized(300));
         })) {
    scene::Scene scene;
    scene.apply(random_addition(random, "e"));
    scene.for_each([&]<class Shape>(scene::ElementRef, const Shape& shape) {
      if constexpr (std::is_same_v<Shape, scene::Disc> || surface::Axial<Shape>) {
        const double size = random.any_of(std::array{0.05, 0.2, 0.5});
        const surface::Box around = surface::box(shape);
        const glm::dvec3 u = random.in_cube(0.5) + 0.5;
        const glm::dvec3 middle = around.low + u * (around.high - around.low);
        const Box box{middle - size / 2, middle + size / 2};
        if (!accel::touches(shape, box)) return;
        ++listed[shape.tipo];
        bool found = false;
        for (int k = 0; k < 20000 && !found; ++k) found = holds(box, Point{random}(shape));
        without[shape.tipo] += found ? 0 : 1;
      }
    });
  }
  for (const auto& [tipo, count] : listed) {
    INFO("type " << static_cast<int>(tipo) << ": " << without[tipo] << " of " << count);
    CHECK(without[tipo] * 100 <= count * 6);
  }
}

TEST_CASE("a box wholly inside a wall is not touched, and one that reaches it is") {
  const glm::dvec3 up(0, 0, 1);
  const Box inside{{-0.4, -0.4, 0.2}, {0.4, 0.4, 0.4}}, reaching{{-0.4, -0.4, 0.2}, {0.8, 0.8, 0.4}};
  for (const Box& box : {inside, reaching}) {
    const bool expected = &box != &inside && box.high.x > 0.5;
    CHECK(accel::touches(scene::Sphere{{0, 0, 0}, 1}, box) == expected);
    CHECK(accel::touches(scene::Cylinder{{0, 0, 0}, 1, up, 1}, box) == expected);
    CHECK(accel::touches(scene::Cone{{0, 0, 0}, 1.0, up, 1}, box) == expected);
    CHECK(accel::touches(scene::TruncatedCone{{0, 0, 0}, 0.5, 0.75, up, 1}, box) == expected);
  }
  CHECK(accel::touches(scene::Sphere{{0, 0, 0}, 1}, {{-2, -2, -2}, {2, 2, 2}}));
  CHECK(accel::touches(scene::Cylinder{{0, 0, 0}, 1, up, 1}, {{1, -1, 0}, {2, 1, 1}}));
  CHECK_FALSE(accel::touches(scene::Cylinder{{0, 0, 0}, 1, up, 1}, {{0.8, 0.8, 0}, {2, 1, 1}}));
}
