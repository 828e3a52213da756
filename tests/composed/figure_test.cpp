#include "durero/composed/figure.hpp"

#include <cmath>

#include "support/catch.hpp"
#include "support/shapes.hpp"

using namespace durero;
using composed::figure;
using composed::Parameter;

namespace {

scene::Body copy(const scene::AnyShape& shape, const model::Mapa& mapa) { return {scene::Instance{shape, mapa}}; }

const model::Mapa flattened{{0, 0, 0}, {3, 0, 0}, {0, 2, 0}, {0, 0, 1}};
const scene::Sphere unit_ball{{0, 0, 0}, 1};
const scene::Cylinder unit_can{{0, 0, 0}, 1, {0, 0, 1}, 1};

}  // namespace

TEST_CASE("A ray meets a copy at its least parameter, or nowhere, or has none that is least") {
  const auto pebble = figure(copy(unit_ball, flattened));
  const auto met = pebble->first(test::ray({-6, 0, 0}, {1, 0, 0}), false);
  REQUIRE(met.t);
  CHECK(*met.t == Parameter{.x = 3});
  CHECK_FALSE(met.no_minimum);
  CHECK_FALSE(pebble->first(test::ray({-6, 2.5, 0}, {1, 0, 0}), false).t);
  const auto can = figure(copy(unit_can, flattened));
  const auto within = can->first(test::ray({3, 0, 0.5}, {0, 0, 1}), false);
  CHECK(within.no_minimum);
  CHECK_FALSE(within.t);
  const auto from_below = can->first(test::ray({3, 0, -2}, {0, 0, 1}), false);
  REQUIRE(from_below.t);
  CHECK(*from_below.t == Parameter{.x = 2});
}

TEST_CASE("A ray that starts on a copy leaves its own point, though the stored origin is beside it") {
  const auto pebble = figure(copy(unit_ball, flattened));
  const glm::dvec3 beside(std::nextafter(3.0, 4.0), 0, 0);
  CHECK(pebble->first(test::ray(beside, {-1, 0, 0}), false).t);
  const auto across = pebble->first(test::ray(beside, {-1, 0, 0}), true);
  REQUIRE(across.t);
  CHECK(number::round_to_binary64(*across.t) == 2 * beside.x);
  CHECK_FALSE(pebble->first(test::ray(beside, {1, 0, 0}), true).t);
  CHECK_FALSE(pebble->may_meet(test::ray(beside, {1, 0, 0}), true));
}

TEST_CASE("What stands in the way stands before the parameter one") {
  const auto pebble = figure(copy(unit_ball, flattened));
  CHECK(pebble->hides(test::ray({-6, 0, 0}, {3.5, 0, 0}), false));
  CHECK_FALSE(pebble->hides(test::ray({-6, 0, 0}, {3, 0, 0}), false));
  CHECK_FALSE(pebble->hides(test::ray({-6, 0, 0}, {2, 0, 0}), false));
  CHECK(figure(copy(unit_can, flattened))->hides(test::ray({3, 0, 0.5}, {0, 0, 1}), false));
}

TEST_CASE("A quick no is a no") {
  const auto pebble = figure(copy(unit_ball, flattened));
  CHECK_FALSE(pebble->may_meet(test::ray({-6, 3, 0}, {1, 0, 0}), false));
  CHECK_FALSE(pebble->may_meet(test::ray({-6, 0, 0}, {-1, 0, 0}), false));
  CHECK(pebble->may_meet(test::ray({-6, 2, 0}, {1, 0, 0}), false));
  const auto floor = figure(copy(scene::Plane{{0, 0, 0}, {0, 0, 1}}, flattened));
  CHECK_FALSE(floor->may_meet(test::ray({0, 0, 1}, {0, 0, 1}), false));
  CHECK(floor->may_meet(test::ray({0, 0, 1}, {0, 0, -1}), false));
  CHECK_FALSE(floor->may_meet(test::ray({0, 0, 1}, {0, 0, -1}), true));
  CHECK(floor->may_meet(test::ray({0, 0, 0}, {1, 0, 0}), true));  // it lies in it
  CHECK(std::isinf(floor->box().high.z));
  CHECK(pebble->box().high.x >= 3);
  CHECK(pebble->box().high.x < 3.001);
}

TEST_CASE("Normals have length one") {
  const auto pebble = figure(copy(unit_ball, flattened));
  CHECK(pebble->normal({3, 0, 0}) == glm::dvec3(1, 0, 0));
  CHECK(pebble->normal({0, 0, -1}) == glm::dvec3(0, 0, -1));
  CHECK(pebble->normal({0, 0, 0}) == glm::dvec3(0));
}
