#include "durero/render/light/environment.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "durero/scene/stage.hpp"
#include "support/catch.hpp"

using namespace durero;
using render::direction_of;
using render::spot_of;
using scene::Environment;
using scene::Surroundings;

namespace {

constexpr Surroundings with_pictures[] = {Surroundings::box, Surroundings::spherical, Surroundings::equirectangular};

/// The colour of a direction is the direction, from [−1, 1] to [0, 1].
glm::dvec3 coded(const glm::dvec3& d) { return 0.5 * d + 0.5; }

/// The pictures of what is around, so many texels wide, filled by texel.
template <class Color>
Environment filled(Surroundings kind, std::uint32_t side, Color&& color) {
  Environment environment{.kind = kind, .pictures = std::vector<scene::PictureFile>(pictures_of(kind))};
  const bool is_panorama = kind == Surroundings::equirectangular;
  for (std::size_t i = 0; i < environment.pictures.size(); ++i) {
    scene::TexelImage picture{is_panorama ? 2 * side : side, side};
    for (std::uint32_t y = 0; y < picture.height; ++y)
      for (std::uint32_t x = 0; x < picture.width; ++x)
        picture.texels.push_back(
            color(direction_of(kind, {i, {(x + 0.5) / picture.width, 1 - (y + 0.5) / picture.height}})));
    environment.pictures[i].levels = std::make_shared<const std::vector<scene::TexelImage>>(1, picture);
  }
  return environment;
}

/// Texels there show no direction of their own.
bool is_outside_the_ball(std::size_t texel, std::size_t side) {
  const auto centre = [&](std::size_t i) { return (2 * static_cast<double>(i) + 1) / static_cast<double>(side) - 1; };
  return std::hypot(centre(texel % side), centre(texel / side)) > 1;
}

struct Directions {
  std::mt19937_64 draw{};  // the same directions each time
  double number() { return std::ldexp(static_cast<double>(draw() >> 11), -52) - 1; }
  glm::dvec3 next() {
    for (;;) {
      const double x = number(), y = number(), z = number();
      const glm::dvec3 d(x, y, z);
      if (const double square = glm::dot(d, d); square > 0.01 && square <= 1) return d / std::sqrt(square);
    }
  }
};

}  // namespace

TEST_CASE("a direction to its spot and back, in every layout") {
  Directions directions;
  for (const Surroundings kind : with_pictures)
    for (int i = 0; i < 20000; ++i) {
      const glm::dvec3 d = directions.next();
      const render::PictureSpot spot = spot_of(kind, 3.0 * d);
      REQUIRE(spot.picture < pictures_of(kind));
      REQUIRE((spot.at.x >= 0 && spot.at.x <= 1 && spot.at.y >= 0 && spot.at.y <= 1));
      // Near the rim of the ball a rounding of the square root of what is left counts for its root.
      REQUIRE(glm::distance(direction_of(kind, spot), d) < (kind == Surroundings::spherical ? 1e-6 : 1e-14));
    }
}

TEST_CASE("faces, and where the sides of each are") {
  const auto spot = [](const glm::dvec3& d) { return spot_of(Surroundings::box, d); };
  const glm::dvec3 axes[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (std::size_t i = 0; i < 6; ++i) {
    CHECK(spot(axes[i]).picture == i);
    CHECK(spot(axes[i]).at == glm::dvec2(0.5));
  }
  CHECK(spot({1, 1, 1}).picture == 0);
  CHECK(spot({0, -1, 1}).picture == 3);
  CHECK(spot({0.5, 0, -1}).at == glm::dvec2(0.75, 0.5));  // to the right of −z is +x
  CHECK(spot({1, 0, 0.5}).at == glm::dvec2(0.75, 0.5));   // of +x, +z
  CHECK(spot({1, 0.5, 0}).at == glm::dvec2(0.5, 0.75));
  CHECK(spot({0, 1, 0.5}).at == glm::dvec2(0.5, 0.75));
  CHECK(spot({0, -1, -0.5}).at == glm::dvec2(0.5, 0.75));
}

TEST_CASE("a panorama has -z in its middle and +x to the right of it; its seam is +z") {
  const auto at = [](const glm::dvec3& d) { return spot_of(Surroundings::equirectangular, d).at; };
  CHECK(at({0, 0, -2}) == glm::dvec2(0.5));
  CHECK(at({1, 0, 0}) == glm::dvec2(0.75, 0.5));
  CHECK(at({-1, 0, 0}) == glm::dvec2(0.25, 0.5));
  CHECK(at({0, 1, 0}).y == 1);
  CHECK(at({0, -1, 0}).y == 0);
  CHECK(at({1e-9, 0, 1}).x > 0.999);
  CHECK(at({-1e-9, 0, 1}).x < 0.001);
}

TEST_CASE("the ball: its middle mirrors +z, and its whole rim -z") {
  const auto at = [](const glm::dvec3& d) { return spot_of(Surroundings::spherical, d).at; };
  CHECK(at({0, 0, 1}) == glm::dvec2(0.5));
  CHECK(at({0, 0, -1}) == glm::dvec2(1, 0.5));
  CHECK(at({1, 0, 0}).x == Approx(0.5 + std::sqrt(0.125)));  // a normal at 45°
  for (const glm::dvec2& rim : {glm::dvec2(1, 0.5), glm::dvec2(0.5, 0), glm::dvec2(0, 0), glm::dvec2(0.1, 0.9)})
    CHECK(direction_of(Surroundings::spherical, {0, rim}) == glm::dvec3(0, 0, -1));
}

TEST_CASE("a picture that codes its directions gives each back to a texel's diagonal") {
  constexpr std::uint32_t side = 64;
  Directions directions;
  for (const Surroundings kind : with_pictures) {
    const Environment environment = filled(kind, side, coded);
    for (int i = 0; i < 5000; ++i) {
      const glm::dvec3 d = directions.next();
      // Away from the rim of the ball, where a texel is many directions.
      if (kind == Surroundings::spherical && d.z < -0.5) continue;
      const glm::dvec3 seen = 2.0 * render::environment_at(environment, d) - 1.0;
      // A face is 2 wide at the distance 1; a panorama's texel π/side; the ball's turns the direction twice as much as
      // its normal, which at d.z = −½ leans by 60°.
      const double texel = kind == Surroundings::box ? 2.0 / side : 8.0 / side;
      REQUIRE(glm::distance(seen, d) < texel * std::sqrt(2));
    }
  }
}

TEST_CASE("each layout turned into each other and back: above 40 dB on smooth data") {
  const auto smooth = [](const glm::dvec3& d) {
    return glm::dvec3(0.5 + 0.3 * d.x * d.y, 0.5 + 0.4 * d.z, 0.5 + 0.3 * std::sin(3 * d.x));
  };
  for (const Surroundings from : with_pictures)
    for (const Surroundings by : with_pictures) {
      const Environment first = filled(from, 128, smooth);
      const Environment other = filled(by, 512, [&](const glm::dvec3& d) { return render::environment_at(first, d); });
      const Environment back = filled(from, 128, [&](const glm::dvec3& d) { return render::environment_at(other, d); });
      double square = 0, count = 0;
      for (std::size_t i = 0; i < first.pictures.size(); ++i) {
        const auto& a = first.pictures[i].levels->front().texels;
        const auto& b = back.pictures[i].levels->front().texels;
        for (std::size_t j = 0; j < a.size(); ++j) {
          if (from == Surroundings::spherical && is_outside_the_ball(j, 128)) continue;
          square += glm::dot(a[j] - b[j], a[j] - b[j]);
          count += 3;
        }
      }
      const double psnr = -10 * std::log10(square / count);
      INFO(static_cast<int>(from) << " by " << static_cast<int>(by) << ": " << psnr << " dB");
      CHECK(psnr > 40);
    }
}

TEST_CASE("a panorama is continuous over its seam and at its poles") {
  const Environment environment = filled(Surroundings::equirectangular, 64, coded);
  const auto at = [&](const glm::dvec3& d) { return render::environment_at(environment, d); };
  CHECK(glm::distance(at({1e-9, 0.2, 1}), at({-1e-9, 0.2, 1})) < 1e-7);
  // About a pole the uppermost row is π/128 away from it on every side.
  for (const double y : {1.0, -1.0}) CHECK(glm::distance(at({1e-9, y, 0}), at({-1e-9, y, 1e-9})) < 0.03);
}

TEST_CASE("a gradient goes by the sine of the height, and needs no picture") {
  const Environment sky{.kind = Surroundings::gradient, .colors = {glm::dvec3(1, 0, 0), glm::dvec3(0, 0, 2)}};
  CHECK(render::environment_at(sky, {0, -3, 0}) == glm::dvec3(1, 0, 0));
  CHECK(render::environment_at(sky, {0, 5, 0}) == glm::dvec3(0, 0, 2));
  CHECK(render::environment_at(sky, {1, 0, 7}) == glm::dvec3(0.5, 0, 1));
  CHECK(render::most_of(sky) == glm::dvec3(1, 0, 2));
  CHECK_THROWS_AS(spot_of(Surroundings::gradient, {1, 0, 0}), std::domain_error);
  CHECK_THROWS_AS(direction_of(Surroundings::gradient, {}), std::domain_error);
}

TEST_CASE("a picture of an environment that has not been read is asked for") {
  const Environment environment{.kind = Surroundings::spherical, .pictures = {{"a.png"}}};
  CHECK_THROWS_AS(render::environment_at(environment, {0, 0, 1}), std::domain_error);
}
