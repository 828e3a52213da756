#include "durero/render/light/extent.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "durero/model/operaciones.hpp"
#include "durero/scene/stage.hpp"
#include "render/light/follower.hpp"
#include "support/catch.hpp"

using namespace durero;
using scene::LightShape;

namespace {

/// A floor at y = 0 that shows how much of a light is seen, whatever the angle; an edge along z at that height, from
/// which on all is covered; and a disc light of the radius 1 at the height 5.
scene::Scene under_an_edge(double edge) {
  scene::Scene scene;
  scene.stage().materials = {{.name = "white", .color = {1, 1, 1}, .k_a = 1, .k_d = 0}};
  scene.stage().lights = {{{0, 5, 0}, {1, 1, 1}, {LightShape::disc, 1, {0, -1, 0}, {}}}};
  scene.apply(model::Agregar_Plano{model::Elemento("floor"), {0, 0, 0}, {0, 1, 0}});
  scene.apply(model::Agregar_Triangulo{model::Elemento("cover"), {{0, edge, -1000}, {0, edge, 1000}, {1000, edge, 0}}});
  scene.set_material(*scene.find("floor"), 0);
  return scene;
}

/// The colours that so many samples of one pixel bring from the floor at x, and their mean.
std::vector<double> brought(const render::Follower& follower, double x, std::uint32_t samples, std::uint32_t pixel,
                            bool independent = false) {
  const std::vector<scene::Query> rays(samples, {{{x, 0.25, 0}, {0, -1, 0}}});
  std::vector<render::SampleSource> sources(samples);
  for (std::uint32_t i = 0; i < samples; ++i) sources[i] = {render::key_of(pixel, 1, 0), i, independent};
  std::vector<double> all;
  for (const render::PathRadiance& one : follower.brought(rays, sources)) all.push_back(one.color.x);
  return all;
}

double mean(const std::vector<double>& all) {
  double sum = 0;
  for (const double one : all) sum += one;
  return sum / static_cast<double>(all.size());
}

/// The part of a unit disc on one side of a line at that distance from its middle: a segment of the circle.
double part_of_disc(double distance) {
  const double d = std::clamp(distance, -1.0, 1.0);
  return 0.5 + (d * std::sqrt(1 - d * d) + std::asin(d)) / std::numbers::pi;
}

}  // namespace

TEST_CASE("points of a light are on its shape, and all over it") {
  const glm::dvec3 at(1, 2, 3);
  const glm::dvec3 normal = glm::normalize(glm::dvec3(1, -2, 2));
  const scene::Light point{at, {1, 1, 1}}, disc{at, {}, {LightShape::disc, 0.5, 3.0 * normal, {}}},
      sphere{at, {}, {LightShape::sphere, 0.5, {}, {}}},
      triangle{at, {}, {LightShape::triangle, 0, {}, {glm::dvec3(1, 0, 0), {0, 0, 2}}}},
      rectangle{at, {}, {LightShape::rectangle, 0, {}, {glm::dvec3(1, 0, 0), {0, 0, 2}}}};
  glm::dvec3 low(0), high(0);
  for (std::uint32_t i = 0; i < 256; ++i) {
    const glm::dvec2 pair = render::SampleSource{1, i}.pair(3);
    CHECK(render::point_of(point, pair) == at);
    const glm::dvec3 of_disc = render::point_of(disc, pair) - at, of_sphere = render::point_of(sphere, pair) - at;
    CHECK((std::abs(glm::dot(of_disc, normal)) < 1e-15 && glm::length(of_disc) <= 0.5 + 1e-15));
    CHECK(glm::length(of_sphere) == Approx(0.5));
    const glm::dvec3 of_triangle = render::point_of(triangle, pair) - at,
                     of_rectangle = render::point_of(rectangle, pair) - at;
    CHECK((of_triangle.x >= 0 && of_triangle.z >= 0 && of_triangle.x + of_triangle.z / 2 <= 1 + 1e-15));
    CHECK((of_triangle.y == 0 && of_rectangle.y == 0));
    low = glm::min(low, of_rectangle);
    high = glm::max(high, of_rectangle);
  }
  CHECK(glm::distance(low, {-0.5, 0, -1}) < 0.02);  // about the position
  CHECK(glm::distance(high, {0.5, 0, 1}) < 0.02);
}

TEST_CASE("the half-shadow of a disc is the segment of its circle that is seen; its width is 2rh/(H - h) to 2 %") {
  for (const double edge : {1.0, 2.5}) {
    const scene::Scene scene = under_an_edge(edge);
    const auto engine = engine::find("fast")->prepare(scene);
    const render::Follower follower(scene, *engine, {1});
    const double half = edge / (5 - edge);  // on the floor, of the light's radius 1
    // The edge's profile falls from 1 to 0. Of the density of that fall, half a circle, the variance is half²/4.
    double moment0 = 0, moment1 = 0;
    constexpr int steps = 200;
    const double step = 2.4 * half / steps;
    for (int i = 0; i < steps; ++i) {
      const double x = -1.2 * half + (i + 0.5) * step;
      const double seen = mean(brought(follower, x, 256, static_cast<std::uint32_t>(i)));
      CHECK(seen == Approx(part_of_disc(-x / half)).margin(0.02));
      moment0 += seen * step;
      moment1 += 2 * x * seen * step;
    }
    // Partial integration: the means of x and x² over the fall, which begins at −1.2·half.
    const double low = -1.2 * half, fall1 = moment0 + low, fall2 = moment1 + low * low;
    CHECK(fall1 == Approx(0).margin(0.01 * half));
    CHECK(4 * std::sqrt(fall2 - fall1 * fall1) == Approx(2 * half).epsilon(0.02));
  }
}

TEST_CASE("the variance of independent points falls as 1/N; that of a net faster") {
  const scene::Scene scene = under_an_edge(2.5);
  const auto engine = engine::find("fast")->prepare(scene);
  const render::Follower follower(scene, *engine, {1});
  const auto slope = [&](bool independent) {
    // A line of least squares through log variance over log N.
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (std::uint32_t samples = 4; samples <= 256; samples *= 2) {
      double sum = 0, squares = 0;
      constexpr std::uint32_t pixels = 400;
      for (std::uint32_t pixel = 0; pixel < pixels; ++pixel) {
        const double one = mean(brought(follower, -0.3, samples, pixel, independent));
        sum += one;
        squares += one * one;
      }
      const double variance = (squares - sum * sum / pixels) / (pixels - 1);
      const double u = std::log(samples), v = std::log(variance);
      n += 1, x += u, y += v, xx += u * u, xy += u * v;
    }
    return (n * xy - x * y) / (n * xx - x * x);
  };
  // 400 pixels tell a variance to 7 %, and seven of them over a factor of 64 the slope to 0.02.
  CHECK(slope(true) == Approx(-1).margin(0.1));
  CHECK(slope(false) < -1.3);
}
