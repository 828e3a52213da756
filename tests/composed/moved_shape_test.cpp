// Held against the text: the parameters of the moved ray on the original, and membership of the copy.
#include "durero/composed/moved_shape.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "durero/model/interseccion.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/scene/addition.hpp"
#include "durero/surface/exact.hpp"
#include "support/catch.hpp"
#include "support/elements.hpp"
#include "support/property.hpp"

using namespace durero;
using composed::MovedShape;
using model::ExactVector;

namespace {

const model::Elemento name("e");

glm::dvec3 whole_vector(int most) {
  const auto one = [&] { return static_cast<double>(*rc::gen::inRange(-most, most + 1)); };
  const double x = one(), y = one();
  return {x, y, one()};
}

ExactVector exact(const glm::dvec3& v) { return {number::exact(v.x), number::exact(v.y), number::exact(v.z)}; }

/// A map of whole numbers, which puts a ray of eighths exactly. Small cases are often no maps: they are one that
/// mirrors.
struct WholeMap {
  glm::dvec3 centro = whole_vector(9), x = whole_vector(5), y = whole_vector(5), z = whole_vector(5);

  WholeMap() {
    if (!model::inv(mapa()).front().holds) x = {2, 1, 0}, y = {0, 3, 1}, z = {1, 0, -2};
  }

  model::Mapa mapa() const { return {exact(centro), exact(x), exact(y), exact(z)}; }
  glm::dvec3 led(const glm::dvec3& v) const { return v.x * x + v.y * y + v.z * z; }
};

model::Escena only(const scene::AnyShape& shape) {
  model::Escena escena = model::Init();
  std::visit([&](const auto& each) { model::apply(escena, scene::addition(name, each)); }, shape);
  return escena;
}

/// The points of the ray of the space of the original, and of its copy, are at the same parameters.
void check_reach(const scene::AnyShape& shape) {
  const WholeMap by;
  const MovedShape moved({shape, by.mapa()});
  const glm::dvec3 p = whole_vector(24) / 8.0, to = whole_vector(8) / 8.0;
  const glm::dvec3 v = to == p ? glm::dvec3(0, 0, 1) : to - p;
  const bool on = *rc::gen::arbitrary<bool>();
  const model::Rayo otro = test::ray(p, v), rayo = test::ray(by.centro + by.led(p), by.led(v));
  const auto expected =
      model::alcance(only(shape), otro, on ? std::set{name} : std::set<model::Elemento>(), name).parameters;
  const auto reach = moved.reach(rayo, on);
  RC_ASSERT(reach.empty() == expected.is_empty());
  RC_ASSERT(reach.empty() || moved.may_meet(rayo, on));
  RC_ASSERT(reach.count == expected.points.size());
  for (std::size_t i = 0; i < reach.count; ++i) RC_ASSERT(number::Surd(reach.t[i]) == expected.points[i]);
  RC_ASSERT(reach.segment.has_value() == expected.interval.has_value());
  if (reach.segment) RC_ASSERT(reach.no_minimum() == !expected.interval->has_first);
}

}  // namespace

TEST_CASE("A ray meets a copy where the moved ray meets the original, with the same t") {
  test::property("of a whole map and any shape", [] {
    const auto eighths = rc::gen::map(rc::gen::inRange(-16, 17), [](int i) { return i / 8.0; });
    test::for_one_of_each(eighths, [](const auto& shape) { check_reach(shape); });
  });
}

TEST_CASE("The unit ball by a map that stretches evenly meets a ray exactly as the sphere does") {
  test::property("at any centre, of any radius", [] {
    const scene::Sphere sphere = *test::spheres(test::moderate());
    const auto r = number::exact(sphere.radio);
    const model::Mapa mapa{exact(sphere.centro), {r, 0, 0}, {0, r, 0}, {0, 0, r}};
    const MovedShape copy({scene::Sphere{{0, 0, 0}, 1}, mapa});
    const model::Rayo rayo = *test::rays(test::moderate());
    for (const bool on : {false, true}) {
      const auto here = copy.reach(rayo, on), there = surface::exact::reach(scene::ShapeView(sphere), rayo, on);
      RC_ASSERT(here.count == there.count);
      for (std::size_t i = 0; i < here.count; ++i)
        RC_ASSERT(number::round_to_binary64(here.t[i]) == number::round_to_binary64(there.t[i]));
    }
  });
}

TEST_CASE("The box of a copy holds its points, and that of a plane is all of space") {
  test::property("of a whole map", [] {
    const WholeMap by;
    const auto eighths = rc::gen::map(rc::gen::inRange(-16, 17), [](int i) { return i / 8.0; });
    test::for_one_of_each(eighths, [&]<class Shape>(const Shape& shape) {
      const surface::Box box = MovedShape({shape, by.mapa()}).box();
      model::Random random(3);
      const auto points = model::puntos_de_instancia(only(shape), by.mapa(), name);
      for (int i = 0; i < 4; ++i) {
        const auto w = points.sample(random);
        if (!w) continue;
        const model::Surd at[3] = {w->x, w->y, w->z};
        for (int axis = 0; axis < 3; ++axis) {
          if (std::isinf(box.low[axis])) continue;
          RC_ASSERT(model::Surd(box.low[axis]) <= at[axis]);
          RC_ASSERT(at[axis] <= model::Surd(box.high[axis]));
        }
      }
      RC_ASSERT((std::isinf(box.low.x) == std::is_same_v<Shape, scene::Plane>));
    });
  });
}

TEST_CASE("A copy beyond the numbers that boxes bear has all of space for a box") {
  const number::Rational huge = number::exact(0x1p1000) * number::exact(0x1p100);
  const MovedShape far({scene::Sphere{{0, 0, 0}, 1}, {{huge, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
  CHECK(std::isinf(far.box().low.x));
}

TEST_CASE("The gradient is across the copy and looks outwards, also where the map mirrors") {
  const model::Mapa mirror{{1, 2, 3}, {2, 1, 0}, {0, 3, 1}, {1, 0, -2}};
  REQUIRE(model::mixto(mirror.x, mirror.y, mirror.z) < 0);
  const MovedShape copy({scene::Sphere{{0, 0, 0}, 1}, mirror});
  const glm::dvec3 x(2, 1, 0), y(0, 3, 1), z(1, 0, -2), centro(1, 2, 3);
  const glm::dvec3 outwards = 0.6 * x + 0.8 * z;
  const glm::dvec3 n = glm::normalize(copy.gradient(centro + outwards));
  CHECK(std::abs(glm::dot(n, y)) < 1e-12);
  CHECK(std::abs(glm::dot(n, -0.8 * x + 0.6 * z)) < 1e-12);
  CHECK(glm::dot(n, outwards) > 0);
}

TEST_CASE("The normal at the apex of a cone is its axis, as a plane across it is moved") {
  const model::Mapa leaning{{1, 2, 3}, {2, 0, 0}, {0, -1, 0}, {1, 0, 4}};
  const MovedShape hat({scene::Cone{{0, 0, 0}, 1, {0, 0, 1}, 1}, leaning});
  const glm::dvec3 apex = hat.gradient({2, 2, 7});
  CHECK(glm::dot(apex, {2, 0, 0}) == 0);
  CHECK(glm::dot(apex, {0, 1, 0}) == 0);
  CHECK(glm::dot(apex, {1, 0, 4}) > 0);
}
