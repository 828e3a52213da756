#include "durero/render/sample/maps.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <vector>

#include "render/sample/points.hpp"
#include "support/catch.hpp"

using namespace durero;

namespace {

constexpr std::uint32_t count = 4096;

/// The mean of a number over the pairs of a net, which lie evenly in the square: within 2⁻¹² times its variation.
template <class Number>
double mean_over_pairs(Number&& number) {
  double sum = 0;
  for (std::uint32_t i = 0; i < count; ++i) sum += number(render::SampleSource{42, i}.pair(7));
  return sum / count;
}

const glm::dvec3 axes[] = {{0, 0, 1}, {0, 0, -1}, {0, 1, 0}, {-0.6, 0, 0.8}, {2.0 / 3, -1.0 / 3, -2.0 / 3}};

}  // namespace

TEST_CASE("two vectors across an axis: unit vectors at right angles") {
  for (const glm::dvec3& axis : axes) {
    const auto [u, v] = render::across(axis);
    CHECK(glm::dot(u, u) == Approx(1));
    CHECK(glm::dot(v, v) == Approx(1));
    CHECK(std::abs(glm::dot(u, v)) < 1e-15);
    CHECK(std::abs(glm::dot(u, axis)) < 1e-15);
    CHECK(glm::distance(glm::cross(u, v), axis) < 1e-15);
  }
}

TEST_CASE("a disc is filled evenly: each circle within it has its share, and each side a half") {
  for (const double radius : {0.25, 0.5, 0.9, 1.0})
    CHECK(mean_over_pairs([&](auto pair) { return double(glm::length(render::in_disc(pair)) <= radius); }) ==
          Approx(radius * radius).margin(0.004));
  CHECK(mean_over_pairs([](auto pair) { return double(render::in_disc(pair).x < 0); }) == Approx(0.5).margin(0.004));
  CHECK(mean_over_pairs([](auto pair) { return render::in_disc(pair).x * render::in_disc(pair).y; }) ==
        Approx(0).margin(0.001));
  CHECK(render::in_disc({0.5, 0.5}) == glm::dvec2(0));
}

TEST_CASE("a disc is the square by concentric rings, to four roundings, whatever the library's sine") {
  const double pi = std::numbers::pi;
  for (const double share : {-1.0, -0.9, -0.3, 0.0, 0.2, 0.75, 1.0})
    for (const double radius : {-1.0, -0.5, 0.3, 1.0}) {
      const glm::dvec2 along(radius * std::cos(pi / 4 * share), radius * std::sin(pi / 4 * share));
      const auto is_at = [&](const glm::dvec2& square, const glm::dvec2& place) {
        CHECK(glm::length(render::in_disc((square + 1.0) / 2.0) - place) < 0x1p-50);
      };
      if (std::abs(share) < 1) is_at({radius, radius * share}, along);
      is_at({radius * share, radius}, {along.y, along.x});
    }
}

TEST_CASE("a sphere is covered evenly: unit vectors, a third of the square along each axis") {
  for (int axis = 0; axis < 3; ++axis) {
    CHECK(mean_over_pairs([&](auto pair) { return render::on_sphere(pair)[axis]; }) == Approx(0).margin(0.001));
    CHECK(mean_over_pairs([&](auto pair) { return std::pow(render::on_sphere(pair)[axis], 2); }) ==
          Approx(1.0 / 3).margin(0.001));
  }
  CHECK(mean_over_pairs([](auto pair) { return glm::length(render::on_sphere(pair)); }) == Approx(1));
}

TEST_CASE("a triangle is filled evenly: the weights are a third each, a half-sized triangle has a quarter") {
  const auto of = [](auto&& number) {
    return mean_over_pairs([&](auto pair) { return number(render::in_triangle(pair)); });
  };
  CHECK(of([](auto w) { return w.x; }) == Approx(1.0 / 3).margin(0.001));
  CHECK(of([](auto w) { return w.y; }) == Approx(1.0 / 3).margin(0.001));
  CHECK(of([](auto w) { return double(w.x >= 0 && w.y >= 0 && w.x + w.y <= 1); }) == 1);
  CHECK(of([](auto w) { return double(w.x + w.y < 0.5); }) == Approx(0.25).margin(0.004));
  CHECK(of([](auto w) { return double(w.y > 0.5); }) == Approx(0.25).margin(0.004));
}

TEST_CASE("directions have their densities: the share within an angle is the integral of the density") {
  for (const glm::dvec3& axis : axes) {
    const auto within = [&](const auto& direction, double cosine) {
      return mean_over_pairs([&](auto pair) { return double(glm::dot(direction(pair), axis) > cosine); });
    };
    const auto by_cosine = [&](auto pair) { return render::by_cosine(pair, axis); };
    const auto in_cone = [&](auto pair) { return render::in_cone(pair, axis, 0.3); };
    for (const double cosine : {0.1, 0.5, 0.9})
      CHECK(within(by_cosine, cosine) == Approx(1 - cosine * cosine).margin(0.004));
    CHECK(within(in_cone, 0.7) == 1);
    CHECK(within(in_cone, 0.85) == Approx(0.5).margin(0.004));
    for (const double e : {0.0, 1.0, 20.0, 3000.5}) {
      const auto in_lobe = [&](auto pair) { return render::in_lobe(pair, axis, e); };
      for (const double share : {0.1, 0.5, 0.9})
        CHECK(within(in_lobe, std::pow(1 - share, 1 / (e + 1))) == Approx(share).margin(0.004));
    }
    CHECK(render::in_lobe({0.3, 0.4}, axis, std::numeric_limits<double>::infinity()) == axis);
  }
}

TEST_CASE("a density adds to one over the sphere") {
  const auto sum = [](const auto& density) {
    double all = 0;  // the midpoint rule over the cosine
    constexpr int steps = 200000;
    for (int i = 0; i < steps; ++i) all += density(-1 + 2 * (i + 0.5) / steps) * 2 / steps;
    return 2 * std::numbers::pi * all;
  };
  CHECK(sum(render::cosine_density) == Approx(1).epsilon(1e-6));
  for (const double e : {0.0, 1.0, 20.0, 3000.5})
    CHECK(sum([&](double cosine) { return render::lobe_density(cosine, e); }) == Approx(1).epsilon(1e-4));
}
