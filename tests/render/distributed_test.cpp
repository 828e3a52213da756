// Lens and shutter: what they blur has the width that optics gives it, and the same bytes whatever draws it.
#include <tbb/global_control.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "durero/model/operaciones.hpp"
#include "durero/render/light/whitted.hpp"
#include "durero/render/render.hpp"
#include "durero/scene/stage.hpp"
#include "support/catch.hpp"

using namespace durero;

namespace {

/// A ball that shines of itself, before black, seen along z from far enough that its outline is a circle.
scene::Scene shining_ball(const glm::dvec3& centre, double radius) {
  scene::Scene scene;
  scene.stage().materials = {{.name = "light", .color = {0, 0, 0}, .emission = {1, 1, 1}}};
  scene.apply(model::Agregar_Esfera{model::Elemento("ball"), model::Punto(centre), radius});
  scene.set_material(*scene.find("ball"), 0);
  return scene;
}

/// The moments of the light of a picture along x, in pixels: how much, where, and the variance.
struct Spread {
  double light = 0, middle = 0, variance = 0;
};

Spread spread(const render::Picture& picture) {
  Spread all;
  const auto over = [&](auto&& add) {
    for (std::size_t i = 0; i < picture.rgb.size(); ++i)
      add(static_cast<double>(i % picture.resolution.width), picture.rgb[i].x);
  };
  over([&](double x, double light) { all.light += light, all.middle += x * light; });
  all.middle /= all.light;
  over([&](double x, double light) { all.variance += (x - all.middle) * (x - all.middle) * light; });
  all.variance /= all.light;
  return all;
}

/// A scene in which everything is blurred: lens, shutter, a light of some size, a glossy mirror.
scene::Scene all_blurred() {
  scene::Scene scene = shining_ball({-1, 0.5, 1}, 0.5);
  scene.stage().materials.push_back({.name = "satin", .color = {0.2, 0.2, 0.2}, .k_ps = 0.7, .gloss = 40});
  scene.stage().lights = {{{2, 5, -2}, {1, 1, 1}, {scene::LightShape::sphere, 1, {}, {}}}};
  scene.apply(model::Agregar_Plano{model::Elemento("floor"), {0, 0, 0}, {0, 1, 0}});
  scene.apply(model::Agregar_Esfera{model::Elemento("other"), {1, 0.7, -1}, 0.7});
  scene.set_material(*scene.find("floor"), 1);
  scene.set_motion(*scene.find("ball"), {0, 1, 0});
  scene.stage().camera = scene::Camera{{0, 2, -6}, {0, 0.5, 0}, {0, 1, 0}, 40, 0.3, 5, 0.5, {0.2, 0, 0}};
  return scene;
}

}  // namespace

TEST_CASE("the circle of confusion is that of thin lenses, to 2 %") {
  constexpr std::uint32_t side = 64;
  constexpr double aperture = 1, focus = 10, field = 4;  // degrees
  const double pixel = 2 * std::tan(field / 2 * std::numbers::pi / 180) / side;
  for (const double z : {7.0, 25.0}) {
    scene::Scene scene = shining_ball({0, 0, z}, 0.06);
    scene.stage().camera = scene::Camera{{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, field, aperture, focus};
    const auto engine = engine::find("fast")->prepare(scene);
    const render::Picture picture =
        render::render(scene, *engine, {}, {.size = scene::Resolution{side, side}, .samples = {.most = 400}});
    // circulo_de_confusion.def.1, over the distance in focus: its place in the window at the distance one.
    const double circle = aperture * std::abs(z - focus) / z / focus / pixel;
    const double own = 0.06 / z / pixel;  // the ball's own radius
    REQUIRE((circle > 10 && circle < 55));
    // The variance of a circle of diameter c along a line is c²/16, and that of the ball's outline r²/4.
    CHECK(4 * std::sqrt(spread(picture).variance - own * own / 4) == Approx(circle).epsilon(0.02));
  }
}

TEST_CASE("what is in focus is as sharp as by a pinhole") {
  scene::Scene scene = shining_ball({0, 0, 10}, 0.1);
  scene.stage().camera = scene::Camera{{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 4};
  const auto engine = engine::find("fast")->prepare(scene);
  const render::RenderSettings frame{.size = scene::Resolution{48, 48}, .samples = {.most = 64}};
  const Spread sharp = spread(render::render(scene, *engine, {}, frame));
  scene.stage().camera->aperture = 0.5;
  scene.stage().camera->focus = 10;
  const Spread seen = spread(render::render(scene, *engine, {}, frame));
  // Of a ball, points nearer than its middle are in focus nowhere: 0.5·0.1/10 of its radius 0.1 at most.
  CHECK(seen.light == Approx(sharp.light).epsilon(0.01));
  CHECK(seen.variance == Approx(sharp.variance).epsilon(0.02));
}

TEST_CASE("a ball that moves leaves the box filter of its outline, to 2 %") {
  constexpr std::uint32_t width = 96, height = 24;
  constexpr double far = 1000, field = 0.024 * 180 / std::numbers::pi;  // a pixel is 1 wide at the ball
  scene::Scene scene = shining_ball({-20, 0, 0}, 6);
  scene.stage().camera = scene::Camera{{0, 0, far}, {0, 0, 0}, {0, 1, 0}, field, 0, 0, 2};
  scene.set_motion(*scene.find("ball"), {20, 0, 0});
  const auto engine = engine::find("fast")->prepare(scene);
  // A picture has as many times as samples; of 64 pictures none has the times of another.
  std::vector<double> columns(width);
  constexpr std::uint32_t seeds = 64;
  for (std::uint32_t seed = 0; seed < seeds; ++seed) {
    const render::RenderSettings frame{.size = scene::Resolution{width, height}, .samples = {.most = 64, .seed = seed}};
    const render::Picture picture = render::render(scene, *engine, {}, frame);
    for (std::size_t i = 0; i < picture.rgb.size(); ++i) columns[i % width] += picture.rgb[i].x / seeds;
  }
  const double pixel = 2 * std::tan(field / 2 * std::numbers::pi / 180) / height * far;
  // The chords of a circle of the radius r up to x, an integral: of the whole circle πr².
  const auto area_up_to = [](double x, double r) {
    const double c = std::clamp(x / r, -1.0, 1.0);
    return r * r * (c * std::sqrt(1 - c * c) + std::asin(c) + std::numbers::pi / 2);
  };
  const double r = 6 / pixel, from = (width - 1) / 2.0 - 20 / pixel, way = 40 / pixel;
  double greatest = 0;
  for (const double column : columns) greatest = std::max(greatest, column);
  CHECK(greatest == Approx(std::numbers::pi * r * r / way).epsilon(0.02));
  for (std::uint32_t x = 0; x < width; ++x) {
    // A column is the mean over its own width and over the times.
    double truth = 0;
    constexpr int parts = 16;
    for (int i = 0; i < parts; ++i) {
      const double u = x - 0.5 + (i + 0.5) / parts - from;
      truth += (area_up_to(u, r) - area_up_to(u - way, r)) / way / parts;
    }
    CHECK(columns[x] == Approx(truth).margin(0.02 * greatest));
  }
}

TEST_CASE("a camera that moves past a thing at rest sees what a camera at rest sees of a thing that moves back") {
  scene::Scene thing = shining_ball({0, 0, 0}, 0.5);
  thing.stage().camera = scene::Camera{{0, 0, -8}, {0, 0, 0}, {0, 1, 0}, 30, 0, 0, 1};
  scene::Scene camera = thing;
  thing.set_motion(*thing.find("ball"), {-1, 0, 0});
  camera.stage().camera->motion = {1, 0, 0};
  const render::RenderSettings frame{.size = scene::Resolution{32, 24}, .samples = {.most = 16}};
  CHECK(render::render(thing, *engine::find("fast")->prepare(thing), {}, frame).rgb ==
        render::render(camera, *engine::find("fast")->prepare(camera), {}, frame).rgb);
}

TEST_CASE("what is blurred has the same bytes for any threads, engine and crop, and others for another seed") {
  const scene::Scene scene = all_blurred();
  const auto engine = engine::find("fast")->prepare(scene), other = engine::find("bvh")->prepare(scene);
  for (const render::Sampling sampling :
       {render::Sampling::grid, render::Sampling::stratified, render::Sampling::net, render::Sampling::allotted,
        render::Sampling::independent, render::Sampling::statistical})
    for (const render::Integrator integrator : {render::Integrator::whitted, render::Integrator::path}) {
      render::RenderSettings frame{
          .size = scene::Resolution{24, 18}, .samples = {.sampling = sampling, .most = 16}, .integrator = integrator};
      const render::Picture picture = render::render(scene, *engine, {}, frame);
      frame.prepare = [](const scene::Scene& then) { return engine::find("bvh")->prepare(then); };
      {
        const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
        CHECK(render::render(scene, *other, {}, frame).rgb == picture.rgb);
      }
      frame.crop = render::Crop{5, 7, {9, 4}};
      const render::Picture crop = render::render(scene, *other, {}, frame);
      bool same = true;
      for (std::uint32_t y = 0; y < 4; ++y)
        for (std::uint32_t x = 0; x < 9; ++x)
          same = same && crop.rgb[std::size_t(y) * 9 + x] == picture.rgb[std::size_t(y + 7) * 24 + x + 5];
      CHECK(same);
      frame.samples.seed = 1;
      CHECK(render::render(scene, *engine, {}, frame).rgb != crop.rgb);
    }
}

TEST_CASE("a glossy mirror spreads what it shows, and keeps how much: a lobe of all exponents before one colour") {
  for (const double gloss : {0.0, 3.0, 50.0}) {
    scene::Scene scene;
    scene.stage().background = glm::dvec3(0.5, 1, 2);
    scene.stage().materials = {{.name = "satin", .color = {0, 0, 0}, .k_ps = 0.5, .gloss = gloss},
                               {.name = "soot", .color = {0, 0, 0}}};
    scene.apply(model::Agregar_Plano{model::Elemento("floor"), {0, 0, 0}, {0, 1, 0}});
    scene.apply(model::Agregar_Plano{model::Elemento("cellar"), {0, -1, 0}, {0, 1, 0}});
    scene.set_material(*scene.find("floor"), 0);
    scene.set_material(*scene.find("cellar"), 1);
    const auto engine = engine::find("fast")->prepare(scene);
    const std::vector<scene::Query> rays(64, {{{0, 1, 0}, {3, -1, 0}}});
    for (const render::PathRadiance& one : render::brought(scene, *engine, rays, {2}))
      CHECK(one.color == glm::dvec3(0.25, 0.5, 1));  // no way leads through the floor: black
  }
}

TEST_CASE("the mean direction of a glossy mirror: of an edge a mirror would show, each side has its half") {
  scene::Scene scene;
  scene.stage().background = glm::dvec3(0);
  scene.stage().materials = {{.name = "satin", .color = {0, 0, 0}, .k_ps = 1, .gloss = 200},
                             {.name = "light", .color = {0, 0, 0}, .emission = {1, 1, 1}}};
  scene.apply(model::Agregar_Plano{model::Elemento("floor"), {0, 0, 0}, {0, 1, 0}});
  scene.apply(model::Agregar_Triangulo{model::Elemento("half"), {{0, 5, -1000}, {0, 5, 1000}, {1000, 5, 0}}});
  scene.set_material(*scene.find("floor"), 0);
  scene.set_material(*scene.find("half"), 1);
  const auto engine = engine::find("fast")->prepare(scene);
  const std::vector<scene::Query> rays(4096, {{{0, 1, 0}, {0, -1, 0}}});
  double sum = 0;
  for (const render::PathRadiance& one : render::brought(scene, *engine, rays, {2})) sum += one.color.x;
  CHECK(sum / 4096 == Approx(0.5).margin(0.01));
}
