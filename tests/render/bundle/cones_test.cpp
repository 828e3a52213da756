#include "durero/render/bundle/cones.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <stdexcept>

#include "durero/engine/engine.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/render/bundle/cone.hpp"
#include "durero/render/render.hpp"
#include "durero/scene/stage.hpp"
#include "render/bundle/cone_cover.hpp"
#include "support/catch.hpp"
#include "support/scenes.hpp"

using namespace durero;
using namespace durero::test;

namespace {

constexpr double step_of_255 = 1.0 / 255, pi = std::numbers::pi;

/// A camera before materials that shine of themselves: white, grey, black and a bright mirror.
scene::Scene shining_stage() {
  scene::Scene scene;
  scene::Stage& stage = scene.stage();
  stage.camera = scene::Camera{{0, 0.3, -5}, {0, 0, 0}, {0, 1, 0}, 40};
  stage.resolution = scene::Resolution{32, 24};
  stage.materials = {{"black", {}}, {"grey", {}}, {"mirror", {}}, {"white", {}}};
  for (scene::Material& m : stage.materials) m.k_d = 0;
  stage.materials[1].emission = glm::dvec3(0.5);
  stage.materials[2].k_ps = 1;
  stage.materials[3].emission = glm::dvec3(1);
  return scene;
}

void add_ball(scene::Scene& scene, const char* name, const glm::dvec3& at, double radius, std::uint32_t material) {
  scene.apply(model::Agregar_Esfera{model::Elemento(name), model::Punto(at), radius});
  scene.set_material(*scene.find(name), material);
}
void add_floor(scene::Scene& scene, double y, std::uint32_t material) {
  scene.apply(model::Agregar_Plano{model::Elemento("floor"), {0, y, 0}, {0, 1, 0}});
  scene.set_material(*scene.find("floor"), material);
}
void add_sail(scene::Scene& scene, const char* name, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
              std::uint32_t material) {
  scene.apply(model::Agregar_Triangulo{model::Elemento(name), {model::Punto(a), model::Punto(b), model::Punto(c)}});
  scene.set_material(*scene.find(name), material);
}

render::Picture cones(const scene::Scene& scene, std::uint32_t samples, double spread = 1) {
  const auto engine = engine::find("fast")->prepare(scene);
  return render::by_cones(scene, *engine, {}, {.samples = {.most = samples}}, spread);
}
render::Picture rays(const scene::Scene& scene, std::uint32_t samples = 1) {
  const auto engine = engine::find("fast")->prepare(scene);
  return render::render(scene, *engine, {}, {.samples = {.most = samples}});
}

double greatest_difference(const render::Picture& a, const render::Picture& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) most = std::max(most, std::abs(a.rgb[i].x - b.rgb[i].x));
  return most;
}

/// The colour in the middle of a picture of one pixel, by a ray from the eye.
double middle(scene::Scene& scene) {
  scene.stage().resolution = scene::Resolution{1, 1};
  return cones(scene, 1, 0).rgb[0].x;
}

}  // namespace

TEST_CASE("a cone of no angle is the ray: the picture is that by rays, to the last bit") {
  scene::Scene scene = shining_stage();
  scene.stage().background = glm::dvec3(0.2, 0.3, 0.4);
  scene.stage().lights = {{{3, 4, -5}, {0.7, 0.6, 0.5}}, {{-3, 6, -2}, {0.2, 0.3, 0.3}}};
  scene.stage().directional_lights = {{{1, -2, 1}, {0.2, 0.2, 0.1}}};
  for (scene::Material& m : scene.stage().materials) {
    m.color = {0.3, 0.4, 0.5};
    m.k_d = 0.5;
    m.k_s = 0.2;
    m.e = 9;
  }
  scene.stage().materials[2].k_ps = 0.6;
  scene.stage().max_depth = 4;
  add_floor(scene, -1, 2);
  add_ball(scene, "a", {0.3, 0, 0}, 0.8, 2);
  add_ball(scene, "b", {-1, -0.5, -0.4}, 0.5, 1);
  add_sail(scene, "sail", {1, -1, 1}, {2, -1, 0}, {1.5, 1, 0.5}, 3);
  CHECK(cones(scene, 1, 0).rgb == rays(scene).rgb);
  CHECK(cones(scene, 4, 0).rgb == rays(scene, 4).rgb);
  scene::Scene spot = scene;
  REQUIRE_FALSE(spot.stage().lights.empty());
  spot.stage().lights[0].cone = {.towards = {0, 0, 0}, .inner = 1, .outer = 9};
  CHECK(cones(spot, 1, 0).rgb == rays(spot).rgb);
  CHECK(cones(spot, 1, 0).rgb != cones(scene, 1, 0).rgb);
  CHECK(cones(scene, 1, 1).rgb != rays(scene).rgb);
}

TEST_CASE("edges by sixteen cones a pixel are those of 4096 rays, to 2/255") {
  scene::Scene one = shining_stage();
  add_ball(one, "ball", {0, 0, 0}, 1, 3);
  CHECK(greatest_difference(cones(one, 16), rays(one, 4096)) < 2 * step_of_255);
  scene::Scene many = shining_stage();
  add_floor(many, -1, 1);
  add_ball(many, "ball", {0, 0, 0}, 1, 3);
  add_ball(many, "before", {0.6, -0.4, -1.2}, 0.3, 0);
  add_sail(many, "sail", {-2, -1, 1}, {-0.5, -1.5, -0.5}, {-1.2, 1.2, 0.5}, 3);
  add_sail(many, "next", {-2, -1, 1}, {-2.5, 1, 1}, {-1.2, 1.2, 0.5}, 3);  // they share an edge
  CHECK(greatest_difference(cones(many, 16), rays(many, 4096)) < 2 * step_of_255);
}

TEST_CASE("the parts of a cone are what its directions meet, to 2/255, and add up to it") {
  Random random(2);
  std::size_t several = 0;
  for (int i = 0; i < 10; ++i) {
    CAPTURE(i);
    scene::Scene scene = shining_stage();
    add_floor(scene, -1, 1);
    for (const char* name : {"a", "b"}) {
      const glm::dvec3 at = random.in_cube(1);
      add_ball(scene, name, at, random.uniform(0.3, 1), 3);
    }
    const glm::dvec3 a = random.in_cube(2), b = random.in_cube(2), c = random.in_cube(2);
    add_sail(scene, "sail", a, b, c, 3);
    std::vector<render::ConeTarget> targets;
    scene.for_each([&]<class Shape>(scene::ElementRef e, const Shape& shape) {
      if constexpr (std::is_constructible_v<render::ConeTarget, scene::ElementRef, const Shape&>)
        targets.emplace_back(e, shape);
    });
    const glm::dvec3 to = random.in_cube(1), from(0.2, 0.1, -5);
    const render::RayCone cone(from, glm::normalize(to - from), random.uniform(0.02, 0.3));
    const auto parts = render::parts_of(cone, targets, {});
    // Directions spread evenly over the cone, by the engine.
    const auto engine = engine::find("fast")->prepare(scene);
    constexpr int side = 300;
    std::vector<scene::Query> queries;
    for (int k = 0; k < side * side; ++k) {
      const double angle = render::half_angle(render::solid_angle(cone.half) * (k / side + 0.5) / side);
      const double turn = 2 * pi * (k % side + 0.5 * (k / side % 2)) / side;
      const glm::dvec3 d = cone.direction(std::tan(angle) * glm::dvec2(std::cos(turn), std::sin(turn)));
      queries.push_back({{model::Punto(from), model::Vector(d)}});
    }
    std::map<scene::ElementSet, double> counted;
    for (const scene::Hit& hit : engine::first_hits(*engine, queries)) counted[hit.elementos] += 1.0 / (side * side);
    double sum = 0;
    for (const render::ConePart& part : parts) {
      sum += part.share;
      const scene::ElementSet key = part.target ? scene::ElementSet{part.target->element()} : scene::ElementSet{};
      CHECK(std::abs(part.share - counted[key]) < 2 * step_of_255);
    }
    CHECK(sum == Approx(1).epsilon(1e-12));
    several += parts.size() > 2;
  }
  CHECK(several >= 3);
}

TEST_CASE("a ball before a light of some size takes the overlap of the two away") {
  for (const double x : {0.0, 0.3, 0.62, 0.9, 1.4}) {
    CAPTURE(x);
    scene::Scene scene = shining_stage();
    scene.stage().camera = scene::Camera{{0, 3, -5}, {0, -1, 0}, {0, 1, 0}, 40};
    scene.stage().materials[0].k_a = 1;
    scene.stage().materials[0].color = glm::dvec3(1);
    scene.stage().lights = {{{0, 9, 0}, glm::dvec3(1), {.shape = scene::LightShape::sphere, .radius = 1}}};
    add_floor(scene, -1, 0);
    add_ball(scene, "ball", {x, 4, 0}, 0.4, 0);
    const double away = std::hypot(x, 5);
    const double taken = render::cone_overlap(std::asin(1.0 / 10), std::asin(0.4 / away), std::atan2(x, 5));
    CHECK(middle(scene) == Approx(1 - taken).margin(1e-9));
  }
}

TEST_CASE("a dull mirror shows the share of its lobe that something covers") {
  for (const double gloss : {20.0, 200.0, 5000.0}) {
    CAPTURE(gloss);
    scene::Scene scene = shining_stage();
    scene.stage().camera = scene::Camera{{0, 3, -4}, {0, -1, 0}, {0, 1, 0}, 40};
    scene.stage().materials[2].gloss = gloss;
    add_floor(scene, -1, 2);
    add_ball(scene, "lamp", {0, 3, 4.7}, 0.7, 3);
    const glm::dvec3 axis = glm::normalize(glm::dvec3(0, 4, 4)), to(0, 4, 4.7);
    const double lobe = render::half_angle(2 * pi / (gloss + 1)), away = glm::length(to);
    const double shown = render::cone_overlap(lobe, std::asin(0.7 / away), std::acos(glm::dot(axis, to) / away));
    CHECK(middle(scene) == Approx(shown).margin(1e-9));
  }
}

TEST_CASE("what cones do not draw is refused by name") {
  const auto said = [](const scene::Scene& scene) {
    try {
      cones(scene, 1);
      return std::string();
    } catch (const std::domain_error& error) {
      return std::string(error.what());
    }
  };
  scene::Scene round = shining_stage();
  round.apply(model::Agregar_Disco{model::Elemento("lid"), {0, 0, 0}, 1, {0, 1, 0}});
  CHECK(said(round).starts_with("element lid is no sphere, plane or triangle"));
  scene::Scene glass = shining_stage();
  glass.stage().materials[0].k_t = 0.5;
  CHECK(said(glass).starts_with("material black lets light through"));
  scene::Scene waves = shining_stage();
  waves.stage().materials[1].bump = scene::Bump{};
  CHECK(said(waves).starts_with("material grey has a relief"));
  scene::Scene panel = shining_stage();
  panel.stage().lights = {
      {{0, 9, 0}, glm::dvec3(1), {.shape = scene::LightShape::disc, .radius = 1, .normal = {0, 1, 0}}}};
  CHECK(said(panel).starts_with("a light has another shape"));
  scene::Scene lens = shining_stage();
  lens.stage().camera->aperture = 1;
  CHECK(said(lens).starts_with("the camera has a lens"));
}
