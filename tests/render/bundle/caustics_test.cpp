#include "durero/render/bundle/caustics.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <stdexcept>

#include "durero/engine/engine.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/render/light/directions.hpp"
#include "durero/render/light/whitted.hpp"
#include "durero/scene/stage.hpp"
#include "support/catch.hpp"

using namespace durero;

namespace {

constexpr double index_of_glass = 1.5, pi = std::numbers::pi;

/// A ball of glass that takes nothing, at the origin, under a light from straight above; a floor so far below.
scene::Scene glass_over_floor(double below) {
  scene::Scene scene;
  scene.stage().materials = {{"glass", {0, 0, 0}}, {"floor", {1, 1, 1}}};
  scene.stage().materials[0].k_d = 0;
  scene.stage().materials[0].k_t = 1;
  scene.stage().materials[0].index = index_of_glass;
  scene.stage().directional_lights = {{{0, -1, 0}, {1, 0.5, 0.25}}};
  scene.apply(model::Agregar_Esfera{model::Elemento("ball"), {0, 0, 0}, 1});
  scene.apply(model::Agregar_Plano{model::Elemento("floor"), {0, -below, 0}, {0, 1, 0}});
  scene.set_material(*scene.find("ball"), 0);
  scene.set_material(*scene.find("floor"), 1);
  return scene;
}

const scene::ElementRef floor_{model::Tipo::soy_plano, 0};

/// Where a ray that falls on the ball so far from its axis meets the floor: how far from the axis, by the law of Snell.
double landing(double height, double below) {
  const glm::dvec3 in(height, std::sqrt(1 - height * height), 0);
  const glm::dvec3 within = render::refracted({0, -1, 0}, in, 1 / index_of_glass).value();
  const glm::dvec3 out = in - 2 * glm::dot(in, within) * within;
  const glm::dvec3 d = render::refracted(within, -out, index_of_glass).value();
  return out.x + d.x * (out.y + below) / -d.y;
}

/// The flux through a disc about the axis, by the spots.
double flux_within(const render::Caustics& caustics, double radius, double below) {
  double sum = 0;
  constexpr int rings = 60, parts = 24;
  for (int i = 0; i < rings; ++i) {
    const double r = (i + 0.5) * radius / rings;
    for (int k = 0; k < parts; ++k) {
      const double angle = 2 * pi * (k + 0.5) / parts;
      sum += caustics.irradiance(floor_, {r * std::cos(angle), -below, r * std::sin(angle)}).x * 2 * pi * r *
             (radius / rings) / parts;
    }
  }
  return sum;
}

}  // namespace

TEST_CASE("the caustic of a ball has the light that Snell's law brings within each distance of its axis") {
  for (const double below : {1.2, 1.5, 2.5}) {
    CAPTURE(below);
    const scene::Scene scene = glass_over_floor(below);
    const auto engine = engine::find("fast")->prepare(scene);
    const render::Caustics caustics(scene, *engine, 4);
    CHECK(caustics.left_out() < 0.01);
    for (const double radius : {0.15, 0.3, 0.6}) {
      double exact = 0;
      constexpr int rings = 4000;
      for (int i = 0; i < rings; ++i) {
        const double height = (i + 0.5) / rings;
        if (std::abs(landing(height, below)) < radius) exact += 2 * pi * height / rings;
      }
      CAPTURE(radius);
      CHECK(flux_within(caustics, radius, below) == Approx(exact).epsilon(0.03));
    }
  }
}

TEST_CASE("on the axis the light grows by the matrix of the ball, and has the light's colour") {
  const double below = 1.2;  // the focus is 1.5 below: 1.2 is four fifths of the way
  const scene::Scene scene = glass_over_floor(below);
  const auto engine = engine::find("fast")->prepare(scene);
  const render::Caustics caustics(scene, *engine, 4);
  const glm::dvec3 light = caustics.irradiance(floor_, {0, -below, 0});
  // The rays from the rim cross the axis before the floor, and those that meet it there add to the paraxial ones.
  CHECK(light.x > 1 / (0.2 * 0.2));
  CHECK(light.y == Approx(light.x / 2));
  CHECK(light.z == Approx(light.x / 4));
  CHECK(caustics.irradiance(floor_, {3, -below, 0}).x < 0.01);
}

TEST_CASE("a picture has the caustic on matt surfaces alone, and a light behind something brings none") {
  scene::Scene scene = glass_over_floor(1.5);
  const auto engine = engine::find("fast")->prepare(scene);
  const render::Caustics caustics(scene, *engine, 4);
  CHECK(caustics.irradiance(floor_, {0, -1.5, 0}).x > 10);
  scene.apply(model::Agregar_Plano{model::Elemento("lid"), {0, 5, 0}, {0, 1, 0}});
  const auto shut = engine::find("fast")->prepare(scene);
  CHECK(render::Caustics(scene, *shut, 4).spots().all().empty());
}

TEST_CASE("a scene without a light, or without something that gathers it, is refused") {
  scene::Scene dark = glass_over_floor(2);
  dark.stage().directional_lights.clear();
  CHECK_THROWS_AS(render::Caustics(dark, *engine::find("fast")->prepare(dark), 4), std::domain_error);
  scene::Scene matt = glass_over_floor(2);
  matt.stage().materials[0].k_t = 0;
  CHECK_THROWS_AS(render::Caustics(matt, *engine::find("fast")->prepare(matt), 4), std::domain_error);
}

TEST_CASE("a light that shines into a cone brings what its cone sends on the ball") {
  scene::Scene scene = glass_over_floor(1.5);
  scene.stage().directional_lights.clear();
  scene.stage().lights = {{{0, 6, 0}, {1, 1, 1}}};
  const auto flux = [&] {
    const auto engine = engine::find("fast")->prepare(scene);
    return flux_within(render::Caustics(scene, *engine, 5), 1, 1.5);
  };
  const double around = flux();
  scene.stage().lights[0].cone = {
      .towards = {0, 0, 0}, .inner = 20, .outer = 30};  // the ball is seen within 9.6 degrees
  CHECK(flux() == Approx(around));
  scene.stage().lights[0].cone = {.towards = {0, 0, 0}, .inner = 2, .outer = 4};
  CHECK(flux() < around / 4);
  CHECK(flux() > 0);
}
