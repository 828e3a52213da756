#include "conform/families/lattice.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <set>
#include <tuple>

#include "support/catch.hpp"

using namespace durero;
using conform::Random;

TEST_CASE("points of the lattice on a circle, exactly, and many of them") {
  Random random(1);
  for (const int radius : conform::circle_radii) {
    std::set<std::pair<double, double>> points;
    for (int i = 0; i < 300; ++i) {
      const glm::dvec2 p = conform::on_circle(random, radius);
      REQUIRE(p == glm::floor(p));
      REQUIRE(p.x * p.x + p.y * p.y == double(radius) * radius);
      points.emplace(p.x, p.y);
    }
    CHECK(points.size() >= 12);
  }
}

TEST_CASE("points of the lattice on a sphere, exactly, and many of them") {
  Random random(2);
  for (const int radius : conform::sphere_radii) {
    std::set<std::tuple<double, double, double>> points;
    for (int i = 0; i < 600; ++i) {
      const glm::dvec3 p = conform::on_sphere(random, radius);
      REQUIRE(p == glm::floor(p));
      REQUIRE(p.x * p.x + p.y * p.y + p.z * p.z == double(radius) * radius);
      points.emplace(p.x, p.y, p.z);
    }
    CHECK(points.size() >= 30);
  }
}

TEST_CASE("a power of two scales the points; for any other radius there is one") {
  Random random(3);
  const glm::dvec2 p = conform::on_circle(random, 0x1p-300 * 65);
  CHECK(p * 0x1p300 == glm::floor(p * 0x1p300));
  CHECK(glm::dot(p * 0x1p300, p * 0x1p300) == 65.0 * 65);
  CHECK(conform::on_circle(random, 7.5) == glm::dvec2(7.5, 0));
  CHECK(conform::on_sphere(random, 0.1) == glm::dvec3(0.1, 0, 0));
}
