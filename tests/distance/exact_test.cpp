#include "durero/distance/exact.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "distance/searched.hpp"
#include "distance/shapes_gen.hpp"
#include "durero/oracle/cover.hpp"
#include "support/catch.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::test;
using distance::exact::Nearest;
using distance::exact::nearest;

namespace {

std::array<double, 3> rounded(const std::array<algebra::Value, 3>& point) {
  return {algebra::round_to_binary64(point[0]), algebra::round_to_binary64(point[1]),
          algebra::round_to_binary64(point[2])};
}

Big3 big(const std::array<algebra::Value, 3>& point) {
  return {test::big(point[0]), test::big(point[1]), test::big(point[2])};
}

/// What is nearest, in binary64.
struct Said {
  double distance;
  std::array<double, 3> point;
  bool many;
  bool operator==(const Said&) const = default;
};
std::ostream& operator<<(std::ostream& out, const Said& said) {
  return out << said.distance << " at " << said.point[0] << ' ' << said.point[1] << ' ' << said.point[2]
             << (said.many ? ", many" : "");
}
Said said(scene::ShapeView shape, const glm::dvec3& p) {
  const Nearest found = nearest(shape, p);
  return {algebra::rounded_root(found.squared), rounded(found.point), found.many};
}

/// A point often on the axis of a shape, or beside a rim.
template <class Shape>
glm::dvec3 point_about(const Shape& shape) {
  const glm::dvec3 any = (*any_point()).xyz();
  if constexpr (requires { shape.centro; }) {
    if (*rc::gen::inRange(0, 6) == 0) return shape.centro;
    if constexpr (requires { shape.altura; })
      if (*rc::gen::inRange(0, 4) == 0) return shape.centro + shape.altura * shape.vector;
  }
  return any;
}

}  // namespace

TEST_CASE("The search finds what is nearest at the last circle of a cone, and on each edge of a triangle") {
  const auto apart = [](const auto& shape, const glm::dvec3& p) {
    return abs(sqrt(test::big(nearest(shape, p).squared)) - searched_distance(shape, p));
  };
  const scene::Cone cone{{0, -7.5, 0}, 1, {0.911584, 0.411114, 0}, 1};
  CHECK(apart(cone, cone.centro + cone.vector) < Big(1e-38));
  const scene::Cone flat{{-10, 0, 0}, 0.75, {0, 0.6, 0.8}, 0.25};
  CHECK(apart(flat, flat.centro + flat.altura * flat.vector) < Big(1e-38));
  const scene::Triangle triangle{{{{-9.25, -8.75, -9}, {-10, -10, -10}, {0, 0, 0}}}};
  CHECK(apart(triangle, {-10, -10, -9.75}) < Big(1e-38));
  CHECK(apart(triangle, {-9.5, -9, -9.5}) < Big(1e-38));
}

TEMPLATE_TEST_CASE("The exact distance is that of a search in a hundred digits, and its point is on the shape", "",
                   scene::Sphere, scene::Cylinder, scene::Cone, scene::TruncatedCone, scene::Plane, scene::Disc,
                   scene::Triangle) {
  property("of any shape and point", [] {
    const auto shape = any_shape<TestType>();
    const glm::dvec3 p = point_about(shape);
    const Nearest found = nearest(shape, p);
    const Big squared = test::big(found.squared), away = sqrt(std::max(Big(0), squared));
    const Big other = searched_distance(shape, p);
    RC_ASSERT(abs(away - other) < Big(1e-38));
    const Big3 w = big(found.point);
    RC_ASSERT(abs(length(w - Big3(p)) - away) < Big(1e-35));
    const Big residue = abs(Big(surface::potencia(shape, surface::Point<Big>{w.x, w.y, w.z})));
    RC_ASSERT(residue < Big(1e-60));
    if (away < Big(1e-30)) {
      RC_ASSERT(algebra::rounded_root(found.squared) == 0 || away > 0);
      return;
    }
    const double rounded = algebra::rounded_root(found.squared);
    RC_ASSERT(abs(Big(rounded) - other) <= ldexp(Big(std::nextafter(rounded, 1e300)) - rounded, -1) + Big(1e-38));
  });
}

TEMPLATE_TEST_CASE(
    "The exact distance is at most that of any sample of the shape, and less by the cover's bound at most", "",
    scene::Sphere, scene::Cylinder, scene::Cone, scene::TruncatedCone, scene::Disc, scene::Triangle) {
  property("of any shape and points", [] {
    auto shape = any_shape<TestType>();  // of lengths that few samples cover
    if constexpr (requires { shape.radio; }) shape.radio = std::max(shape.radio, 0.5);
    if constexpr (requires { shape.altura; }) shape.altura = std::clamp(shape.altura, 0.5, 8.0);
    if constexpr (requires { shape.proporcion; }) shape.proporcion = std::max(shape.proporcion, 0.25);
    const oracle::Cover cover = oracle::cover(oracle::Parametrisation(shape), 0.05);
    const glm::dvec3 p = point_about(shape);
    double least = INFINITY;
    for (const glm::dvec3& sample : cover.samples) least = std::min(least, glm::length(sample - p));
    const double distance = algebra::rounded_root(nearest(shape, p).squared);
    RC_ASSERT(distance <= least + 1e-9);  // a sample is rounded
    RC_ASSERT(distance >= least - cover.delta - 1e-9);
  });
}

TEST_CASE("A sphere, seen from outside, inside and its centre") {
  const scene::Sphere sphere{{1, 2, 3}, 2};
  CHECK(said(sphere, {1, 2, 8}) == Said{3, {1, 2, 5}, false});
  CHECK(said(sphere, {1, 3, 3}) == Said{1, {1, 4, 3}, false});
  CHECK(said(sphere, {1, 2, 5}) == Said{0, {1, 2, 5}, false});
  CHECK(said(sphere, {1, 2, 3}) == Said{2, {-1, 2, 3}, true});
}

TEST_CASE("A cylinder: its wall, its rims, and rings of nearest points about its axis") {
  const scene::Cylinder cylinder{{0, 0, 0}, 2, {0, 0, 1}, 6};
  CHECK(said(cylinder, {5, 0, 3}) == Said{3, {2, 0, 3}, false});
  CHECK(said(cylinder, {-1, 0, 3}) == Said{1, {-2, 0, 3}, false});
  CHECK(said(cylinder, {5, 0, 10}) == Said{5, {2, 0, 6}, false});
  CHECK(said(cylinder, {0, 5, -4}) == Said{5, {0, 2, 0}, false});
  CHECK(said(cylinder, {0, 0, 3}) == Said{2, {-2, 0, 3}, true});
  CHECK(said(cylinder, {0, 0, -1.5}) == Said{2.5, {-2, 0, 0}, true});
  CHECK(said({scene::Cylinder{{0, 0, 0}, 2, {1, 0, 0}, 6}}, {3, 0, 0}) == Said{2, {3, -2, 0}, true});
}

TEST_CASE("A cone: its wall, rim and apex; a truncated cone") {
  const scene::Cone cone{{0, 0, 0}, 0.75, {0, 0, 1}, 4};
  CHECK(said(cone, {4, 0, 7}) == Said{5, {0, 0, 4}, false});
  CHECK(said(cone, {0, 0, 6}) == Said{2, {0, 0, 4}, false});
  CHECK(said(cone, {3, 0, -2}) == Said{2, {3, 0, 0}, false});
  CHECK(said(cone, {1.5 + 4, 0, 2 + 3}) == Said{5, {1.5, 0, 2}, false});
  CHECK(said(cone, {0, 0, 0}) == Said{2.4, {-1.92, 0, 1.44}, true});
  const scene::TruncatedCone trunk{{0, 0, 0}, 1, 0.75, {0, 0, 1}, 4};
  CHECK(said(trunk, {0, 0, 5}) == Said{std::sqrt(2.0), {-1, 0, 4}, true});
  CHECK(said(trunk, {2.5 + 4, 0, 2 + 3}) == Said{5, {2.5, 0, 2}, false});
}

TEST_CASE("A plane, a disc and a triangle: over the inside and beyond the edge") {
  CHECK(said(scene::Plane{{0, 0, 1}, {0, 0, -1}}, {7, 8, 4}) == Said{3, {7, 8, 1}, false});
  const scene::Disc disc{{0, 0, 0}, 2, {0, 0, 1}};
  CHECK(said(disc, {1, 1, 4}) == Said{4, {1, 1, 0}, false});
  CHECK(said(disc, {5, 0, 4}) == Said{5, {2, 0, 0}, false});
  CHECK(said(disc, {0, 0, 0}) == Said{0, {0, 0, 0}, false});
  const scene::Triangle triangle{{glm::dvec3{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};
  CHECK(said(triangle, {1, 1, -3}) == Said{3, {1, 1, 0}, false});
  CHECK(said(triangle, {2, -3, 4}) == Said{5, {2, 0, 0}, false});
  CHECK(said(triangle, {7, 0, 4}) == Said{5, {4, 0, 0}, false});
  CHECK(said(triangle, {2, 2, 1}) == Said{1, {2, 2, 0}, false});
}

TEST_CASE("The stored axis counts as it is: a cylinder whose axis is short is a slim ellipsoid, and may end early") {
  // d·d = 1 − 2⁻⁵²: c² = (1 − dd)²/dd is some 2⁻¹⁰⁴, and at the advance 2⁶⁰ far more than the radius of 2⁻¹⁰.
  const scene::Cylinder thin{{0, 0, 0}, 0x1p-10, {0, 0, 1 - 0x1p-53}, 0x1p60};
  const Said far = said(thin, {0, 0, 0x1p60});
  CHECK(far.distance > 0x1p59);
  CHECK(far.point[2] < 0x1p43);
  const Big other = searched_distance(thin, {0, 0, 0x1p60});
  CHECK(far.distance == static_cast<double>(other));
}
