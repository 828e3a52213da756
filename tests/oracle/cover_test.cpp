#include "durero/oracle/cover.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "support/catch.hpp"
#include "support/scenes.hpp"

using namespace durero;

namespace {

double distance_to(const oracle::Cover& cover, const glm::dvec3& point) {
  double best = std::numeric_limits<double>::infinity();
  for (const glm::dvec3& sample : cover.samples) best = std::min(best, glm::length(sample - point));
  return best;
}

/// Two directions across the axis.
std::pair<glm::dvec3, glm::dvec3> across(const glm::dvec3& d) {
  const glm::dvec3 u = glm::normalize(glm::cross(d, std::abs(d.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
  return {u, glm::cross(d, u)};
}

constexpr double fineness = 1.0 / 8;
constexpr double pi = std::numbers::pi;

}  // namespace

TEST_CASE("every point of a sphere has a sample within delta") {
  test::Random random(11);
  for (int round = 0; round < 20; ++round) {
    const scene::Sphere sphere{random.in_cube(10), random.uniform(0.01, 5)};
    const oracle::Cover cover = oracle::cover(sphere, fineness);
    CHECK(cover.delta <= fineness * sphere.radio * 1.001);
    for (int i = 0; i < 200; ++i)
      CHECK(distance_to(cover, sphere.centro + random.direction() * sphere.radio) <= cover.delta);
    CHECK(distance_to(cover, sphere.centro + glm::dvec3(0, 0, sphere.radio)) <= cover.delta);  // a pole
  }
}

TEST_CASE("every point of a cylinder has a sample within delta, on the rims too") {
  test::Random random(12);
  for (int round = 0; round < 20; ++round) {
    const glm::dvec3 d = random.axis().xyz();
    const scene::Cylinder c{random.in_cube(10), random.uniform(0.1, 2), d, random.uniform(0.1, 5)};
    const oracle::Cover cover = oracle::cover(c, fineness);
    const auto [u, v] = across(d);
    for (int i = 0; i < 200; ++i) {
      const double s = i % 4 == 0 ? 0 : i % 4 == 1 ? c.altura : random.uniform(0, c.altura);
      const double angle = random.uniform(0, 2 * pi);
      const glm::dvec3 point = c.centro + d * s + (u * std::cos(angle) + v * std::sin(angle)) * c.radio;
      CHECK(distance_to(cover, point) <= cover.delta);
    }
  }
}

TEST_CASE("every point of a cone has a sample within delta, apex and rim too") {
  test::Random random(13);
  for (int round = 0; round < 20; ++round) {
    const glm::dvec3 d = random.axis().xyz();
    const scene::Cone c{random.in_cube(10), random.uniform(0.1, 3), d, random.uniform(0.1, 2)};
    const oracle::Cover cover = oracle::cover(c, fineness);
    const auto [u, v] = across(d);
    for (int i = 0; i < 200; ++i) {
      const double s = i % 4 == 0 ? 0 : i % 4 == 1 ? c.altura : random.uniform(0, c.altura);
      const double angle = random.uniform(0, 2 * pi), radius = c.proporcion * (c.altura - s);
      const glm::dvec3 point = c.centro + d * s + (u * std::cos(angle) + v * std::sin(angle)) * radius;
      CHECK(distance_to(cover, point) <= cover.delta);
    }
  }
}

TEST_CASE("every point of a truncated cone has a sample within delta, on both rims too") {
  test::Random random(14);
  for (int round = 0; round < 20; ++round) {
    const glm::dvec3 d = random.axis().xyz(), centro = random.in_cube(10);
    const double radio = random.uniform(0.1, 2), proporcion = random.uniform(0.1, 3), altura = random.uniform(0.1, 2);
    const oracle::Cover cover = oracle::cover(scene::TruncatedCone{centro, radio, proporcion, d, altura}, fineness);
    const auto [u, v] = across(d);
    for (int i = 0; i < 200; ++i) {
      const double s = i % 4 == 0 ? 0 : i % 4 == 1 ? altura : random.uniform(0, altura);
      const double angle = random.uniform(0, 2 * pi), radius = radio + proporcion * (altura - s);
      const glm::dvec3 point = centro + d * s + (u * std::cos(angle) + v * std::sin(angle)) * radius;
      CHECK(distance_to(cover, point) <= cover.delta);
    }
  }
}

TEST_CASE("samples lie on the surface, so a cover proves something") {
  const scene::Sphere sphere{{1, 2, 3}, 2};
  const oracle::Cover cover = oracle::cover(sphere, fineness);
  for (const glm::dvec3& sample : cover.samples) CHECK(glm::length(sample - sphere.centro) == Approx(2).epsilon(1e-12));
}

TEST_CASE("a cover of too many samples is refused, not begun") {
  CHECK_THROWS_AS(oracle::cover(scene::Cylinder{{0, 0, 0}, 1e-6, {0, 0, 1}, 1e6}, fineness), std::length_error);
  CHECK_THROWS_AS(oracle::cover(scene::Sphere{{0, 0, 0}, 1}, 1e-9), std::length_error);
}

TEST_CASE("each ball holds its samples, and its halves share them out") {
  const scene::Cone cone{{1, 2, 3}, 0.5, {0, 0.6, 0.8}, 3};
  const oracle::Cover cover = oracle::cover(cone, fineness);
  REQUIRE(cover.balls.front().first == 0);
  REQUIRE(cover.balls.front().last == cover.samples.size());
  for (std::size_t i = 0; i < cover.balls.size(); ++i) {
    const oracle::BallNode& ball = cover.balls[i];
    for (std::uint32_t n = ball.first; n < ball.last; ++n)
      CHECK(glm::length(cover.samples[n] - ball.center) <= ball.radius);
    if (ball.right == 0) continue;
    CHECK(cover.balls[i + 1].first == ball.first);
    CHECK(cover.balls[i + 1].last == cover.balls[ball.right].first);
    CHECK(cover.balls[ball.right].last == ball.last);
  }
}

TEST_CASE("delta and the balls pay for the rounding of the samples, 2^-45 of where they are and of their size") {
  const double far = 0x1p30, rounding = 0x1p-45 * (far + 1);
  const oracle::Cover cover = oracle::cover(scene::Sphere{{far, 0, 0}, 1}, fineness);
  CHECK(cover.delta >= fineness + rounding * (1 - 0x1p-20));
  CHECK(cover.balls.front().radius >= rounding * (1 - 0x1p-20) + std::cos(pi / 52));  // of 26 rings, the outermost
}

TEST_CASE("an outline says of a cover what it is before it is made") {
  test::Random random(15);
  for (int round = 0; round < 20; ++round) {
    const scene::Scene scene = test::random_scene(random, 6);
    scene.for_each([](scene::ElementRef, const auto& shape) {
      const oracle::Parametrisation surface{scene::ShapeView(shape)};
      const oracle::CoverPlan outline = oracle::outline(surface, fineness);
      const oracle::Cover cover = oracle::cover(surface, fineness);
      const oracle::BallNode& all = cover.balls.front();
      CHECK(outline.ball.center == all.center);
      CHECK(outline.ball.radius == all.radius);
      CHECK(outline.ball.first == 0);
      CHECK(outline.ball.last == cover.samples.size());
      CHECK(outline.delta == cover.delta);
      CHECK(outline.bytes ==
            cover.samples.capacity() * sizeof(glm::dvec3) + cover.balls.capacity() * sizeof(oracle::BallNode));
    });
  }
  CHECK_THROWS_AS(oracle::outline(scene::Sphere{{0, 0, 0}, 1}, 1e-9), std::length_error);
}
