#include "durero/render/bundle/cone.hpp"

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <numbers>

#include "support/catch.hpp"
#include "support/scenes.hpp"

using namespace durero;
using namespace durero::test;

namespace {

constexpr double pi = std::numbers::pi;

/// The overlap of two circles of the plane, by its textbook formula: as a share of the first.
double plane_overlap(double r, double q, double d) {
  const double a = r * r * std::acos((d * d + r * r - q * q) / (2 * d * r)),
               b = q * q * std::acos((d * d + q * q - r * r) / (2 * d * q)),
               c = 0.5 * std::sqrt((-d + r + q) * (d + r - q) * (d - r + q) * (d + r + q));
  return (a + b - c) / (pi * r * r);
}

/// The overlap on the sphere, ring by ring about the first axis: at the angle a from it, the arc within the other cone.
double by_rings(double half, double other, double between) {
  constexpr int rings = 400000;
  double sum = 0;
  for (int i = 0; i < rings; ++i) {
    const double a = (i + 0.5) * half / rings;
    const double c = (std::cos(other) - std::cos(a) * std::cos(between)) / (std::sin(a) * std::sin(between));
    sum += std::sin(a) * 2 * std::acos(std::clamp(c, -1.0, 1.0)) * half / rings;
  }
  return sum / render::solid_angle(half);
}

/// The share of the directions of a cone, spread evenly, for which a predicate holds.
double by_points(const render::RayCone& cone, const std::function<bool(const glm::dvec3&)>& holds) {
  constexpr int side = 1200;
  std::size_t count = 0;
  for (int i = 0; i < side; ++i)
    for (int k = 0; k < side; ++k) {
      const double angle = render::half_angle(render::solid_angle(cone.half) * (i + 0.5) / side);
      const double turn = 2 * pi * (k + 0.5 * (i % 2)) / side;
      count += holds(cone.direction(std::tan(angle) * glm::dvec2(std::cos(turn), std::sin(turn))));
    }
  return double(count) / (side * double(side));
}

}  // namespace

TEST_CASE("the overlap of two cones is that of their circles on the sphere, to 10^-6") {
  for (const auto& [half, other, between] : {std::array{0.5, 0.3, 0.4},
                                             {0.5, 0.3, 0.6},
                                             {0.2, 0.8, 0.9},
                                             {1.0, 1.2, 1.5},
                                             {0.3, pi / 2, pi / 2 + 0.1},
                                             {0.01, 0.02, 0.025}}) {
    CAPTURE(half, other, between);
    CHECK(std::abs(render::cone_overlap(half, other, between) - by_rings(half, other, between)) < 1e-6);
  }
  CHECK(render::cone_overlap(0.1, pi / 2, pi / 2) == Approx(0.5).margin(1e-12));
}

TEST_CASE("the overlap of narrow cones is that of two circles of the plane, to 10^-6") {
  for (const double size : {1e-4, 1e-6, 1e-8})
    for (const auto& [half, other, between] : {std::array{1.0, 0.7, 0.9}, {1.0, 3.0, 2.5}, {1.0, 1.0, 0.1}}) {
      CAPTURE(size, half, other, between);
      CHECK(std::abs(render::cone_overlap(size * half, size * other, size * between) -
                     plane_overlap(half, other, between)) < 1e-6);
    }
}

TEST_CASE("an overlap begins and ends where the circles touch") {
  CHECK(render::cone_overlap(0.2, 0.3, 0.5) == 0);
  CHECK(render::cone_overlap(0.2, 0.3, 0.499999) > 0);
  CHECK(render::cone_overlap(0.2, 0.3, 0.1) == 1);
  CHECK(render::cone_overlap(0.2, 0.3, 0.100001) < 1);
  CHECK(render::cone_overlap(0.3, 0.2, 0.05) == render::solid_angle(0.2) / render::solid_angle(0.3));
  CHECK(render::half_angle(render::solid_angle(0.7)) == Approx(0.7));
}

TEST_CASE("the share of a triangle is that of the directions that it holds") {
  Random random(4);
  const render::RayCone cone({0, 0, 0}, glm::normalize(glm::dvec3(0.3, -0.2, 1)), 0.4);
  std::size_t partly = 0;
  for (int i = 0; i < 12; ++i) {
    CAPTURE(i);
    const glm::dvec3 a = random.in_cube(1.5), b = random.in_cube(1.5), c = random.in_cube(1.5);
    const std::array<glm::dvec3, 3> corners{a + 0.7 * cone.axis, b + 0.7 * cone.axis, c + 0.7 * cone.axis};
    const double volume = glm::dot(corners[0], glm::cross(corners[1], corners[2]));
    const auto holds = [&](const glm::dvec3& d) {
      for (std::size_t k = 0; k < 3; ++k)
        if (glm::dot(d, glm::cross(corners[k], corners[(k + 1) % 3])) * volume < 0) return false;
      return true;
    };
    const double share = render::triangle_share(cone, corners);
    CHECK(std::abs(share - by_points(cone, holds)) < 2e-3);
    partly += share > 0.02 && share < 0.98;
  }
  CHECK(partly >= 3);
}

TEST_CASE("triangles of a fan add up to the whole cone, however narrow it is; one behind covers nothing") {
  for (const double half : {0.6, 1e-2, 1e-5}) {
    CAPTURE(half);
    const render::RayCone cone({1, 2, 3}, {0, 0, 1}, half);
    const glm::dvec3 middle(0.3 * half, 0.2 * half, 1);
    double sum = 0;
    for (int i = 0; i < 5; ++i) {
      const auto corner = [&](int k) { return glm::dvec3(std::cos(2 * pi * k / 5), std::sin(2 * pi * k / 5), 0.8); };
      sum += render::triangle_share(cone, {middle, corner(i), corner(i + 1)});
    }
    CHECK(std::abs(sum - 1) < 1e-6);
    CHECK(render::triangle_share(cone, {glm::dvec3(-3, -3, -1), {3, -3, -1}, {0, 3, -1}}) == 0);
    CHECK(render::triangle_share(cone, {glm::dvec3(-3, -3, -1), {3, -3, -1}, {0, 30, 0.1}}) < 1e-6);
  }
}
