#include "durero/render/bundle/spots.hpp"

#include <glm/geometric.hpp>

#include "support/catch.hpp"

using namespace durero;

namespace {

const scene::ElementRef floor_{model::Tipo::soy_plano, 0}, other{model::Tipo::soy_plano, 1};
const glm::dvec3 up(0, 1, 0);

}  // namespace

TEST_CASE("a spot spreads its flux, whatever the shape of its cell") {
  const glm::dvec3 flux(3, 2, 1);
  for (const glm::dvec3& side : {glm::dvec3(0.2, 0, 0), glm::dvec3(0.1, 0, 0.4), glm::dvec3(0)}) {
    const render::LightSpot spot = render::spot_of(floor_, {1, 0, 2}, up, side, {0, 0, 0.1}, 0.05, flux);
    glm::dvec3 sum(0);
    constexpr double step = 0.01;
    for (int i = -300; i < 300; ++i)
      for (int k = -300; k < 300; ++k) sum += step * step * render::density(spot, {1 + step * i, 0, 2 + step * k});
    CHECK(glm::distance(sum, flux) < 0.01 * glm::length(flux));  // what lies beyond 3.5 deviations is 0.2 %
  }
}

TEST_CASE("spots side by side give an even light") {
  render::Spots spots;
  for (int i = -20; i <= 20; ++i)
    for (int k = -20; k <= 20; ++k)
      spots.add(render::spot_of(floor_, {0.1 * i, 0, 0.1 * k}, up, {0.1, 0, 0}, {0, 0, 0.1}, 1e-4, glm::dvec3(0.01)));
  for (int i = 0; i < 30; ++i) {
    const glm::dvec3 light = spots.density(floor_, {0.013 * i, 0, 0.007 * i});
    CHECK(std::abs(light.x - 1) < 0.01);
    CHECK(light.x == light.z);
  }
  CHECK(spots.density(other, {0, 0, 0}) == glm::dvec3(0));
  CHECK(spots.density(floor_, {5, 0, 0}) == glm::dvec3(0));
  CHECK(spots.all().size() == 41 * 41);
}

TEST_CASE("each spot is found from any point that it lights, however large or small it is") {
  render::Spots spots;
  std::vector<render::LightSpot> all;
  for (int i = 0; i < 40; ++i) {
    const double size = std::ldexp(1.0, i % 13 - 9);
    all.push_back(render::spot_of(floor_, {0.37 * i - 7, 0, 0.11 * i}, up, {size, 0, 0.3 * size}, {0, 0, size / 7},
                                  1e-3, glm::dvec3(1 + i)));
    spots.add(all.back());
  }
  for (int i = 0; i < 500; ++i) {
    const glm::dvec3 point(0.03 * i - 7, 0, 0.009 * i - 0.05);
    glm::dvec3 sum(0);
    for (const render::LightSpot& spot : all) sum += render::density(spot, point);
    CHECK(glm::distance(spots.density(floor_, point), sum) <= 1e-12 * glm::length(sum));
  }
}
