#include "durero/render/light/light_cones.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "durero/render/render.hpp"
#include "render/lone_rays.hpp"

using namespace durero;
using namespace durero::test;

namespace {

glm::dvec3 at_angle(double degrees) {
  return {std::sin(degrees * 0.017453292519943295), -std::cos(degrees * 0.017453292519943295), 0};
}

/// A matt floor under a lamp at the height 10, which shines down into a cone.
scene::Scene under_a_spot(const scene::LightCone& cone) {
  scene::Scene scene;
  scene.stage().materials = {{.name = "a", .color = glm::dvec3(1)}};
  scene.stage().lights = {{{0, 10, 0}, {1, 1, 1}, {}, cone}};
  scene.apply(model::Agregar_Plano{model::Elemento("floor"), {0, 0, 0}, {0, 1, 0}});
  scene.set_material(*scene.find("floor"), 0);
  return scene;
}

/// The colour of the floor at (x, 0, 0) over Lambert's cosine.
double light_at(const scene::Scene& scene, double x, render::Integrator by = render::Integrator::whitted) {
  const scene::Query query{{{x, 1, -1}, {0, -1, 1}}};
  const glm::dvec3 seen =
      render::brought(scene, *engine::find("exact")->prepare(scene), {&query, 1}, {.max_depth = 1, .integrator = by})
          .at(0)
          .color;
  return seen.x * std::hypot(x, 10) / 10;
}

}  // namespace

TEST_CASE("a cone of light is full within, ends without a step, and is narrowed by a power of the cosine") {
  const render::CosineCone cone = render::cosine_cone({.towards = {0, -7, 0}, .inner = 20, .outer = 40}, {0, 1, 0});
  CHECK(cone.axis == glm::dvec3(0, -1, 0));
  CHECK(render::intensity(cone, {0, -1, 0}) == 1);
  CHECK(render::intensity(cone, at_angle(19.99)) == 1);
  CHECK(render::intensity(cone, at_angle(40.01)) == 0);
  CHECK(render::intensity(cone, at_angle(39.99)) < 1e-5);
  CHECK(render::intensity(cone, at_angle(20.01)) > 1 - 1e-5);
  CHECK(render::intensity(cone, {0, 1, 0}) == 0);
  double last = 1;
  for (double angle = 20; angle <= 40; angle += 0.5) {
    const double now = render::intensity(cone, at_angle(angle));
    CHECK(now <= last);
    last = now;
  }
  // POV-Ray's documentation: the step is x²(3 − 2x) over the cosines; here at 35.18 degrees of its defaults.
  const render::CosineCone plain = render::cosine_cone({.towards = {0, -1, 0}}, {0, 0, 0});
  CHECK(render::intensity(plain, at_angle(35.18)) == Approx(0.7764).epsilon(1e-3));
  const render::CosineCone tight =
      render::cosine_cone({.towards = {0, -1, 0}, .inner = 12, .outer = 40, .tightness = 10}, {0, 0, 0});
  CHECK(render::intensity(tight, at_angle(10)) == Approx(std::pow(std::cos(10 * 0.017453292519943295), 10)));
  CHECK(render::intensity(tight, at_angle(19.55)) == Approx(0.5108).epsilon(1e-3));
}

TEST_CASE("a cone as wide at its edge as within is full up to there, and one of a right angle fills half of space") {
  const render::CosineCone sharp =
      render::cosine_cone({.towards = {0, -1, 0}, .inner = 30, .outer = 30, .tightness = 2}, {0, 0, 0});
  CHECK(render::intensity(sharp, at_angle(29.9)) == Approx(0.7515).epsilon(1e-3));
  CHECK(render::intensity(sharp, at_angle(30.1)) == 0);
  const render::CosineCone half = render::cosine_cone({.towards = {0, -1, 0}, .inner = 90, .outer = 90}, {0, 0, 0});
  CHECK(render::intensity(half, at_angle(89.9)) == 1);
  CHECK(render::intensity(half, at_angle(90.1)) == 0);
}

TEST_CASE("what a surface gets of a cone is the share along the way to it, by rays and by paths") {
  const scene::LightCone cone{.towards = {0, 0, 0}, .inner = 20, .outer = 40, .tightness = 3};
  const scene::Scene scene = under_a_spot(cone);
  const render::CosineCone of = render::cosine_cone(cone, {0, 10, 0});
  for (const double x : {0.0, 1.0, 4.0, 6.0, 8.0, 9.0}) {
    const double share = render::intensity(of, glm::normalize(glm::dvec3(x, -10, 0)));
    CHECK(light_at(scene, x) == Approx(share).margin(1e-12));
    CHECK(light_at(scene, x, render::Integrator::path) == Approx(share).margin(1e-12));
  }
}

TEST_CASE("lights without a cone shine all around, beside one with a cone") {
  scene::Scene scene = under_a_spot({.towards = {0, 0, 0}, .inner = 5, .outer = 6});
  scene.stage().lights.push_back({{5, 10, 0}, {1, 1, 1}});
  const render::LightCones cones(scene.stage());
  CHECK(cones.share(0, {0, 1, 0}) == 1);
  CHECK(cones.share(0, {1, 0, 0}) == 0);
  CHECK(cones.share(1, {1, 0, 0}) == 1);
}

TEST_CASE("a light of some size shines into its cone from each of its points") {
  scene::Scene scene = under_a_spot({.towards = {0, 0, 0}, .inner = 5, .outer = 5});
  scene.stage().lights[0].extent = {.shape = scene::LightShape::disc, .radius = 3, .normal = {0, -1, 0}};
  scene.stage().camera = scene::Camera{{0, 5, -9}, {2.5, 0, 0}, {0, 1, 0}, 5};
  const auto fast = engine::find("fast")->prepare(scene);
  const auto drawn = render::render(scene, *fast, {}, {.size = scene::Resolution{1, 1}, .samples = {.most = 256}}).rgb;
  CHECK(drawn[0].x > 0.05);  // the middle of the disc lights nothing there
  CHECK(drawn[0].x < 0.95);
  CHECK(light_at(under_a_spot({.towards = {0, 0, 0}, .inner = 5, .outer = 5}), 2.5) == 0);
}
