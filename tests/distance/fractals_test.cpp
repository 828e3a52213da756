#include "durero/distance/fractals.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <random>
#include <vector>

#include "durero/conform/random.hpp"
#include "support/catch.hpp"

using namespace durero;
using conform::Random;
using distance::MengerSponge;
using distance::QuaternionJulia;

namespace {

std::uint32_t power(std::uint32_t base, std::uint32_t exponent) {
  std::uint32_t value = 1;
  while (exponent-- > 0) value *= base;
  return value;
}

/// visit(i, j, k) for each of the n³ cells.
template <class Visit>
void for_each_cell(std::uint32_t n, Visit visit) {
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < n; ++j)
      for (std::uint32_t k = 0; k < n; ++k) visit(i, j, k);
}

/// The low corners of the cells that are kept.
std::vector<glm::dvec3> corners(const MengerSponge& sponge) {
  const std::uint32_t n = power(3, sponge.level);
  std::vector<glm::dvec3> all;
  for_each_cell(n, [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    if (sponge.keeps(i, j, k)) all.push_back(glm::dvec3(i, j, k) / double(n));
  });
  return all;
}

/// The distance from the nearest of the cells, each a box.
double searched_distance(const std::vector<glm::dvec3>& corners, double side, const glm::dvec3& p) {
  double least = INFINITY;
  for (const glm::dvec3& low : corners)
    least = std::min(least, glm::length(glm::max(glm::max(low - p, p - low - side), glm::dvec3(0))));
  return least;
}

const QuaternionJulia julia{{-0.2, 0.6, 0.2, 0.2}, 12};

}  // namespace

TEST_CASE("A sponge of level k keeps 20ᵏ of 27ᵏ cells, and 8ᵏ of 9ᵏ on each face") {
  for (std::uint32_t level = 0; level <= 4; ++level) {
    const MengerSponge sponge{level};
    const std::uint32_t n = power(3, level);
    std::uint32_t all = 0;
    std::array<std::uint32_t, 6> faces{};
    for_each_cell(n, [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
      if (!sponge.keeps(i, j, k)) return;
      ++all;
      const std::array<std::uint32_t, 3> cell{i, j, k};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        faces[2 * axis] += cell[axis] == 0;
        faces[2 * axis + 1] += cell[axis] == n - 1;
      }
    });
    CHECK(all == power(20, level));
    for (const std::uint32_t face : faces) CHECK(face == power(8, level));
  }
}

TEST_CASE("The bound of a sponge is negative in the middle of each cell that is kept, and of no other") {
  for (const std::uint32_t level : {0U, 1U, 2U, 3U}) {
    const MengerSponge sponge{level};
    const std::uint32_t n = power(3, level);
    std::size_t wrong = 0;
    for_each_cell(n, [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
      wrong += (sponge.below((glm::dvec3(i, j, k) + 0.5) / double(n)) < 0) != sponge.keeps(i, j, k);
    });
    CHECK(wrong == 0);
  }
}

TEST_CASE("The bound of a sponge is no more than the distance from its nearest cell, nor less than half of it") {
  const std::uint64_t seed = std::random_device()();
  INFO("seed " << seed);
  Random random(seed);
  for (const std::uint32_t level : {1U, 2U, 3U}) {
    const MengerSponge sponge{level};
    const std::vector<glm::dvec3> cells = corners(sponge);
    std::size_t wrong = 0;
    for (int i = 0; i < 1000; ++i) {
      const glm::dvec3 p = random.in_cube(0.8) + 0.5;
      const double below = sponge.below(p), exact = searched_distance(cells, 1.0 / power(3, level), p);
      wrong += std::max(below, 0.0) > exact + 1e-14 || std::max(below, 0.0) < exact / 2 - 1e-14;
    }
    CHECK(wrong == 0);
  }
}

TEST_CASE("The normal of a sponge leads away from its nearest face") {
  const MengerSponge sponge{2};
  CHECK(sponge.normal({0.1, 0.5, -0.01}) == glm::dvec3(0, 0, -1));
  CHECK(sponge.normal({1.001, 0.05, 0.05}) == glm::dvec3(1, 0, 0));
  // In the great bar along z, beside its wall at x = 1/3.
  CHECK(sponge.normal({1.0 / 3 + 1e-4, 0.49, 0.05}) == glm::dvec3(1, 0, 0));
}

TEST_CASE("In the ball of its bound no point is of a Julia set") {
  const std::uint64_t seed = std::random_device()();
  INFO("seed " << seed);
  Random random(seed);
  std::size_t inside = 0, wrong = 0;
  for (int i = 0; i < 4000; ++i) {
    const glm::dvec3 p = random.in_cube(1.6);
    const double below = julia.below(p);
    if (julia.keeps(p)) {
      ++inside;
      wrong += below != 0;
      continue;
    }
    for (int k = 0; k < 25; ++k) wrong += julia.keeps(p + below * random.direction());
  }
  CHECK(inside > 100);
  CHECK(wrong == 0);
}

TEST_CASE("The bound of a Julia set is no more than the distance from a dense sample of it, and seldom much less") {
  std::vector<glm::dvec3> samples;
  constexpr int side = 90;
  constexpr double step = 3.2 / side;
  for_each_cell(side, [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    const glm::dvec3 p = glm::dvec3(i, j, k) * step - 1.6;
    if (julia.keeps(p)) samples.push_back(p);
  });
  REQUIRE(samples.size() > 10'000);
  const std::uint64_t seed = std::random_device()();
  INFO("seed " << seed);
  Random random(seed);
  std::size_t wrong = 0, poor = 0;
  for (int i = 0; i < 300; ++i) {
    const glm::dvec3 p = random.in_cube(1.6);
    if (julia.keeps(p)) continue;
    double least = INFINITY;
    for (const glm::dvec3& sample : samples) least = std::min(least, glm::length(sample - p));
    wrong += julia.below(p) > least;
    poor += julia.below(p) < (least - 2 * step) / 8;
  }
  CHECK(wrong == 0);
  CHECK(poor < 30);
}

TEST_CASE("The circle of radius one is the Julia set of c = 0 among complex numbers, and its ball here") {
  const QuaternionJulia ball{{0, 0, 0, 0}, 40};
  CHECK(ball.keeps({0.6, 0.6, 0.5}));
  CHECK_FALSE(ball.keeps({0.6, 0.6, 0.6}));
  for (const double out : {0.001, 0.1, 1.0}) {
    CHECK(ball.below({0, 1 + out, 0}) <= out);
    CHECK(ball.below({0, 1 + out, 0}) > out / 4);
  }
  const glm::dvec3 p = glm::normalize(glm::dvec3(1, 2, 2)) * 1.01;
  CHECK(glm::dot(ball.normal(p), glm::normalize(p)) == Approx(1));
}
